package dev.lazyz.spark

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.spark.triangles.files.ByteRanges
import dev.lazyz.spark.triangles.files.FaceRecords
import dev.lazyz.spark.triangles.files.SplitPly
import dev.lazyz.spark.triangles.files.SplitStl
import dev.lazyz.spark.triangles.files.StlFacets
import dev.lazyz.spark.triangles.files.VertexRecords
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType

/**
 * Triangles as rows of a Dataset, for models that are larger than the memory of any machine.
 *
 * The columns are `index`, the submission index from 0 (a long integer, different for each triangle), which resolves
 * ties of depth; and `x0`, `y0`, `z0` to `x2`, `y2`, `z2`, the corners, counter-clockwise seen from outside. A Parquet
 * file with these columns is such a table; further columns are ignored. The order of rows and their division into
 * partitions have no effect on pictures. Partitions of triangles that are near to each other move fewer bytes.
 */
public object TriangleTable {
    /** The columns. */
    @JvmStatic
    public val schema: StructType
        get() = CORNERS.fold(StructType().add("index", DataTypes.LongType, false)) { all, name ->
            all.add(name, DataTypes.FloatType, false)
        }

    internal val CORNERS: List<String> = (0..2).flatMap { corner -> listOf("x$corner", "y$corner", "z$corner") }

    /** Bytes of a partition, unless the caller chooses. */
    private const val USUAL_BYTES = 32L shl 20

    /**
     * Returns the triangles of a binary STL file. Each partition reads a range of its bytes, wherever Hadoop's file
     * systems find it. The picture is that of `Scenes.load` without smooth normals.
     *
     * @param path a path or URI, as for Spark's own sources
     * @param partitionBytes bytes of the file that a partition reads
     * @throws SceneFormatException if the file cannot be read, is not binary, has fewer bytes than it
     *   announces, or, in a task, has colours
     */
    @JvmStatic
    @JvmOverloads
    @Throws(SceneFormatException::class)
    public fun readStl(spark: SparkSession, path: String, partitionBytes: Long = USUAL_BYTES): Dataset<Row> {
        val file = SplitStl.open(spark, path)
        return ByteRanges.read(spark, file.ranges(partitionBytes), StlFacets(file.bytes), schema)
    }

    /**
     * Returns the triangles of a binary PLY file. Partitions read ranges of its bytes; Spark joins faces and vertices.
     * The picture is that of `Scenes.load` without smooth normals.
     *
     * Vertices must come first, and have 32-bit positions and no normals, colours or texture coordinates; all faces
     * must be triangles, as records of one length.
     *
     * @param path a path or URI, as for Spark's own sources
     * @param partitionBytes bytes of the file that a partition reads
     * @throws SceneFormatException if the file cannot be read or is not of this kind; or, in a task,
     *   if a face is not a triangle
     */
    @JvmStatic
    @JvmOverloads
    @Throws(SceneFormatException::class)
    public fun readPly(spark: SparkSession, path: String, partitionBytes: Long = USUAL_BYTES): Dataset<Row> {
        val file = SplitPly.open(spark, path)
        val vertexRanges = file.vertexRanges(partitionBytes)
        val vertices = ByteRanges.read(spark, vertexRanges, VertexRecords(file), VertexRecords.SCHEMA)
        var faces = ByteRanges.read(spark, file.faceRanges(partitionBytes), FaceRecords(file), FaceRecords.SCHEMA)
        for (corner in 0..2) {
            val own = vertices.toDF("v$corner", "x$corner", "y$corner", "z$corner")
            faces = faces.join(own, "v$corner")
        }
        return faces.select("index", *CORNERS.toTypedArray())
    }
}
