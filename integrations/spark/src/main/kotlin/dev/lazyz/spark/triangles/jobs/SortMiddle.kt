package dev.lazyz.spark.triangles.jobs

import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.TriangleChunk
import org.apache.spark.api.java.JavaPairRDD
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.function.PairFlatMapFunction
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.sql.Row
import scala.Tuple2

/**
 * Triangles are sent to the bands that they reach, and each band is drawn by a task ("sort-middle").
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994).
 */
internal class SortMiddle(private val rows: JavaRDD<Row>, private val setUp: Broadcast<PictureSetUp>) {
    /** Returns the bands that show triangles. */
    fun bands(): JavaPairRDD<Int, FinishedBand> =
        BandTriangles(setUp, rows.mapPartitionsToPair(BinTriangles(setUp))).drawn(null, TriangleChunk.BYTES)
}

private class BinTriangles(private val setUp: Broadcast<PictureSetUp>) :
    PairFlatMapFunction<Iterator<Row>, Int, TriangleChunk> {
    override fun call(rows: Iterator<Row>): Iterator<Tuple2<Int, TriangleChunk>> {
        val drawing = setUp.value().drawing()
        return BandTriangles.sent(rows) { drawing.part(it).byBand() }
    }

    private companion object {
        const val serialVersionUID = 1L
    }
}
