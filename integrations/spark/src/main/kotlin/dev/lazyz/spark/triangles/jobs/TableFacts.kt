package dev.lazyz.spark.triangles.jobs

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.spark.triangles.TriangleChunk
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Surface
import java.io.Serializable
import java.util.function.UnaryOperator
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.function.FlatMapFunction
import org.apache.spark.sql.Row
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * What is known of a partition of triangles.
 *
 * @property sides least x, y, z and greatest x, y, z in the scene; null if there are no vertices
 */
internal class PartFacts(val triangles: Long, val greatestIndex: Long, private val sides: DoubleArray?) : Serializable {
    val box: Box? get() = sides?.let { Box(it[0], it[1], it[2], it[3], it[4], it[5]) }

    companion object {
        fun of(triangles: Long, greatestIndex: Long, box: Box?): PartFacts {
            val sides = box?.let { doubleArrayOf(it.minX, it.minY, it.minZ, it.maxX, it.maxY, it.maxZ) }
            return PartFacts(triangles, greatestIndex, sides)
        }
    }
}

/**
 * All triangles as one surface, for a camera that is fitted: it knows where they are. Its answers are those of a mesh
 * in memory. Each new direction is a job of Spark over all triangles.
 *
 * @param rows the triangles
 * @property parts what is known of each partition
 */
internal class TableExtent private constructor(
    private val rows: JavaRDD<Row>,
    private val scene: TriangleScene,
    val parts: List<PartFacts>,
) : Surface {
    override val bounds: Box? = parts.mapNotNull { it.box }.reduceOrNull(Box::union)

    private val known = HashMap<Vector3d, Vector3d?>()

    @Synchronized
    override fun farthest(direction: Vector3dc): Vector3d? = known.getOrPut(Vector3d(direction)) {
        val (x, y, z) = listOf(direction.x(), direction.y(), direction.z())
        rows.mapPartitions(FarthestOf(scene, x, y, z)).collect().map { Vector3d(it[0], it[1], it[2]) }
            .minWithOrNull(
                compareByDescending<Vector3d> {
                    x * it.x + y * it.y + z * it.z
                }.thenBy { it.x }.thenBy { it.y }.thenBy { it.z }
            )
    }?.let { Vector3d(it) }

    override fun primitives(setUp: SetUp): Sequence<Primitive> = emptySequence()

    /** The positions are those after the rotation, which tasks make. */
    override fun withUpAxis(up: UpAxis): Surface = this

    override fun withMaterials(change: UnaryOperator<Material>): Surface = this

    private class FarthestOf(
        private val scene: TriangleScene,
        private val x: Double,
        private val y: Double,
        private val z: Double,
    ) : FlatMapFunction<Iterator<Row>, DoubleArray> {
        override fun call(rows: Iterator<Row>): Iterator<DoubleArray> = TriangleChunk.chunks(rows)
            .mapNotNull { scene.scene(it.mesh()).farthest(Vector3d(x, y, z)) }
            .map { doubleArrayOf(it.x, it.y, it.z) }.iterator()
    }

    private class FactsOf(private val scene: TriangleScene) : FlatMapFunction<Iterator<Row>, PartFacts> {
        override fun call(rows: Iterator<Row>): Iterator<PartFacts> {
            var count = 0L
            var greatest = -1L
            var box: Box? = null
            for (chunk in TriangleChunk.chunks(rows)) {
                count += chunk.size
                greatest = maxOf(greatest, chunk.index(chunk.size - 1).toLong())
                val own = scene.scene(chunk.mesh()).bounds ?: continue
                box = box?.union(own) ?: own
            }
            return listOf(PartFacts.of(count, greatest, box)).iterator()
        }
    }

    companion object {
        /** Looks at all [rows] once. */
        fun of(rows: JavaRDD<Row>, scene: TriangleScene): TableExtent =
            TableExtent(rows, scene, rows.mapPartitions(FactsOf(scene)).collect())
    }
}
