package dev.lazyz.spark.triangles.jobs

import dev.lazyz.Raster
import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.ScreenReach
import dev.lazyz.spark.triangles.TriangleChunk
import dev.lazyz.world.camera.Camera
import org.apache.spark.api.java.JavaPairRDD
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.sql.Row

/**
 * Estimates how many bytes cross from task to task, for each order.
 *
 * @param parts the partitions of triangles
 */
internal class Planner(private val parts: List<PartFacts>, private val raster: Raster, camera: Camera) {
    private val reach = ScreenReach(raster, camera)

    /** Samples in the rectangles of all partitions. */
    private val covered: Double = parts.sumOf { samples(it).toDouble() }

    /** Samples of a partition's rectangle on the screen. */
    private fun samples(part: PartFacts): Long {
        val box = part.box ?: return 0
        reach.clear()
        for (number in 0 until 8) {
            reach.add(
                if (number and 1 == 0) box.minX else box.maxX,
                if (number and 2 == 0) box.minY else box.maxY,
                if (number and 4 == 0) box.minZ else box.maxZ,
            )
        }
        return reach.region()?.size ?: 0
    }

    private val levels: Int
        get() {
            var groups = parts.size
            var levels = 1
            while (groups > SortLast.FAN_IN) {
                groups = (groups + SortLast.FAN_IN - 1) / SortLast.FAN_IN
                levels++
            }
            return levels
        }

    /** Bytes of fragments that sort-last merges. Above the first level of the tree, each has at most the picture. */
    val lastBytes: Long
        get() {
            var bytes = covered
            var groups = parts.size
            repeat(levels - 1) {
                groups = (groups + SortLast.FAN_IN - 1) / SortLast.FAN_IN
                bytes += minOf(covered, groups.toDouble() * raster.size)
            }
            return (bytes * FRAGMENT * FILLED).toLong()
        }

    /** Bytes of triangles that sort-middle sends. */
    val middleBytes: Long get() = (parts.sumOf { it.triangles } * TriangleChunk.BYTES * OVERLAP).toLong()

    /** Returns the estimates, and the choice between them, as text. */
    fun explain(choice: String): String = buildString {
        append("${parts.sumOf { it.triangles }} triangles in ${parts.size} partitions, ${raster.width} x ")
        append("${raster.height} samples.\n")
        append("sort-last: partitions reach ${covered.toLong()} samples in total, and are merged in $levels steps: ")
        append("about $lastBytes bytes of fragments.\n")
        append("sort-middle: each triangle goes to the bands that it reaches: about $middleBytes bytes of triangles.\n")
        append(choice)
    }

    private companion object {
        /** Bytes of a fragment in runs: differences of depth and index, and a colour. */
        const val FRAGMENT = 8.0

        /** The part of a partition's rectangle that its triangles cover: measured, see docs/spark.md. */
        const val FILLED = 0.1

        /** Bands that a triangle reaches. */
        const val OVERLAP = 1.1
    }
}

/**
 * Triangles are sent to the bands that they reach, and each band is drawn by a task ("sort-middle").
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994).
 */
internal class SortMiddle(private val rows: JavaRDD<Row>, private val setUp: Broadcast<PictureSetUp>) {
    /** Returns the bands that show triangles. */
    fun bands(): JavaPairRDD<Int, FinishedBand> {
        val known = setUp
        val sent = rows.mapPartitionsToPair { own ->
            val drawing = known.value().drawing()
            BandTriangles.sent(own) { drawing.part(it).byBand() }
        }
        return BandTriangles(setUp, sent).drawn(null, TriangleChunk.BYTES)
    }
}
