package dev.lazyz.spark

import dev.lazyz.Counters
import dev.lazyz.RowSink
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import dev.lazyz.spark.triangles.BandSamples
import dev.lazyz.spark.triangles.PartDrawing
import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.spark.triangles.files.ByteRanges
import dev.lazyz.spark.triangles.files.FaceRecords
import dev.lazyz.spark.triangles.files.SplitPly
import dev.lazyz.spark.triangles.files.SplitStl
import dev.lazyz.spark.triangles.files.StlFacets
import dev.lazyz.spark.triangles.files.VertexRecords
import dev.lazyz.spark.triangles.jobs.FinishedBand
import dev.lazyz.spark.triangles.jobs.Planner
import dev.lazyz.spark.triangles.jobs.SortLast
import dev.lazyz.spark.triangles.jobs.SortMiddle
import dev.lazyz.spark.triangles.jobs.TableExtent
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import java.io.IOException
import java.nio.file.Path
import org.apache.spark.api.java.JavaPairRDD
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.functions.col
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType
import org.apache.spark.storage.StorageLevel
import scala.Tuple2

/** Where work is sorted by what is in front, see [TrianglePicture]. */
public enum class SortOrder {
    /** Each partition is drawn where it is, and the nearest fragments are merged. */
    LAST,

    /** Triangles are sent to the bands of rows that they reach, and each band is drawn by one task. */
    MIDDLE,
}

/** When colours are computed, for [SortOrder.LAST]. */
public enum class SortedShading {
    /** Each partition shades what is nearest within itself, and colours are merged with keys. */
    EAGER,

    /** Keys are merged first; then what is visible is shaded, once each sample. */
    LAZY,
}

/**
 * A picture of a Dataset of triangles, see [TriangleTable], which may be larger than the memory of any machine. The
 * bits are those of one JVM with all triangles in one `Mesh`.
 *
 * ```
 * val triangles = TriangleTable.readStl(spark, "scan.stl")
 * val picture = TrianglePicture(triangles, 4000, 3000, { Scene(listOf(it)).withUpAxis(UpAxis.Z) })
 * println(picture.explain())
 * picture.writePng(Path.of("scan.png"))
 * ```
 *
 * The fragments of a sample are merged by the minimum of their keys, which is associative and commutative (contract
 * rule 5.1); so partitions, their order, failures and repeated tasks have no effect on the picture.
 *
 * A fitted camera needs about 30 jobs over all triangles, when it is first needed. Cache the Dataset, or give the scene
 * a [dev.lazyz.world.camera.Camera], which needs one. Memory of a task: 131,072 triangles, which take some 50 MB while
 * they are drawn, and for [SortOrder.LAST] bands at 12 bytes a sample, up to a fifth of the heap for all tasks of an
 * executor. Thread safe.
 *
 * @param triangles a table of triangles
 * @property width number of columns
 * @property height number of rows
 * @param scene makes the scene around the triangles
 * @param order which order to use; null for the one that moves fewer bytes, as far as can be estimated
 * @param shading when to shade
 * @throws IllegalArgumentException if a column of [triangles] is missing or has another type
 */
public class TrianglePicture @JvmOverloads constructor(
    triangles: Dataset<Row>,
    public val width: Int,
    public val height: Int,
    private val scene: TriangleScene,
    private val order: SortOrder? = null,
    private val shading: SortedShading = SortedShading.EAGER,
) {
    private val context = JavaSparkContext.fromSparkContext(triangles.sparkSession().sparkContext())

    init {
        val types = triangles.schema().fields().associate { it.name() to it.dataType() }
        for (field in TriangleTable.schema.fields()) {
            require(types[field.name()] == field.dataType()) {
                "the table must have a column '${field.name()}' of type ${field.dataType().simpleString()}: it has " +
                    triangles.schema().simpleString()
            }
        }
    }

    private val rows = triangles.select(col("index"), *TriangleTable.CORNERS.map { col(it) }.toTypedArray()).javaRDD()
    private val extent by lazy { TableExtent.of(rows, scene) }
    private val camera by lazy { scene.scene(extent).camera(width, height) }
    private val setUp by lazy {
        PictureSetUp(scene, SerializableCamera(camera), width, height, PictureSetUp.bandRows(width, height))
    }
    private val planner by lazy { Planner(extent.parts, setUp.drawing().raster, camera) }
    private val chosen: SortOrder
        get() = order ?: if (planner.lastBytes <= planner.middleBytes) SortOrder.LAST else SortOrder.MIDDLE

    /** Returns which order is used, and why: the bytes that each is estimated to move. Looks at all triangles. */
    public fun explain(): String = planner.explain(
        when {
            order != null -> "$order is used: it was asked for."
            else -> "$chosen is used: it moves fewer bytes."
        },
    )

    /**
     * Renders the picture, and passes its rows to [sink] on this thread, from the top.
     *
     * @throws IllegalArgumentException if the scene is translucent, or has other surfaces
     * @throws org.apache.spark.SparkException if a task has failed too often
     * @throws IOException if the sink throws it
     */
    @Throws(IOException::class)
    public fun render(sink: RowSink): TriangleReport {
        requireOpaque()
        val broadcast: Broadcast<PictureSetUp> = context.broadcast(setUp)
        try {
            val used = chosen
            val bands = bands(used, broadcast).sortByKey().persist(StorageLevel.DISK_ONLY())
            try {
                bands.count()
                return handOut(bands.toLocalIterator(), TriangleReport.Builder(used, shading), sink)
            } finally {
                bands.unpersist(false)
            }
        } finally {
            broadcast.destroy()
        }
    }

    private fun handOut(
        bands: Iterator<Tuple2<Int, FinishedBand>>,
        report: TriangleReport.Builder,
        sink: RowSink,
    ): TriangleReport {
        var next = 0
        for (band in bands) {
            while (next < band._1()) background(setUp, next++, sink)
            band._2().pixels.sendTo(sink)
            report.add(band._2().pixels.counters, band._2().moved)
            next++
        }
        while (next < setUp.bands) background(setUp, next++, sink)
        return report.build(extent.parts.sumOf { it.triangles })
    }

    private fun bands(used: SortOrder, broadcast: Broadcast<PictureSetUp>): JavaPairRDD<Int, FinishedBand> =
        when (used) {
            SortOrder.LAST -> SortLast(rows, broadcast).bands(shading == SortedShading.LAZY)
            SortOrder.MIDDLE -> SortMiddle(rows, broadcast).bands()
        }

    /** Fails here and not in a task. */
    private fun requireOpaque() {
        val own = scene.scene(Mesh(FloatArray(9), intArrayOf(0, 1, 2)))
        require((own.surfaces.singleOrNull() as? Mesh)?.triangleCount == 1) { PartDrawing.otherSurfaces(own) }
        require((own.surfaces.single() as Mesh).material.alphaMode != AlphaMode.BLEND) { PartDrawing.TRANSLUCENT }
    }

    /** Passes the rows of a band that shows nothing. */
    private fun background(known: PictureSetUp, band: Int, sink: RowSink) {
        val samples = BandSamples(known.drawing().raster, known.region(band))
        samples.forEachRow { y, argb, depth, primitive -> sink.row(y, argb, depth, primitive) }
    }

    /**
     * Writes the picture to a PNG file on the driver, which appears when it is complete. Throws like [render].
     *
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     * @throws InterruptedException if the thread is interrupted while it writes
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun writePng(path: Path): TriangleReport {
        val isOpaque = setUp.drawing().raster.background.alpha >= 1f
        val alpha = if (isOpaque) AlphaChannel.DROP else AlphaChannel.KEEP
        return ImageFiles.write(path, width, height, ImageFormat.PNG, alpha) { render(it) }
    }

    override fun toString(): String = "TrianglePicture($width x $height, order=$order, $shading)"
}

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

/**
 * What a [TrianglePicture] took. Immutable.
 *
 * @property order the order that was used
 * @property shading when colours were computed
 * @property counters the work of all tasks
 * @property movedBytes bytes of fragments or triangles that crossed from task to task, before Spark compressed them;
 *   not counted are finished rows on their way to the driver
 */
public class TriangleReport internal constructor(
    public val order: SortOrder,
    public val shading: SortedShading,
    public val counters: Counters,
    public val movedBytes: Long,
) {
    override fun toString(): String = "TriangleReport($order, $shading, $movedBytes bytes moved, $counters)"

    /** Adds up what bands took. */
    internal class Builder(private val order: SortOrder, private val shading: SortedShading) {
        private val counters = Counters.Builder()
        private var moved = 0L

        fun add(work: Counters, moved: Long) {
            counters.add(work)
            this.moved += moved
        }

        fun build(triangles: Long): TriangleReport {
            counters.primitives = triangles
            return TriangleReport(order, shading, counters.build(), moved)
        }
    }
}
