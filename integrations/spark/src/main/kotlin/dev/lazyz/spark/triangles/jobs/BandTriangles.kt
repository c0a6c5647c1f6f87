package dev.lazyz.spark.triangles.jobs

import dev.lazyz.spark.pictures.PixelBlock
import dev.lazyz.spark.triangles.BandSamples
import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.TriangleChunk
import org.apache.spark.Partitioner
import org.apache.spark.api.java.JavaPairRDD
import org.apache.spark.api.java.function.PairFlatMapFunction
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.sql.Row
import scala.Tuple2

/**
 * Triangles on their way to the bands that they reach. A task draws a band while the triangles arrive: it never has all
 * of them.
 */
internal class BandTriangles(
    private val setUp: Broadcast<PictureSetUp>,
    private val triangles: JavaPairRDD<Int, TriangleChunk>,
) {
    /**
     * Draws the bands that triangles reach.
     *
     * @param before what it took so far, by band; null for nothing
     * @param bytes bytes that each triangle has moved
     */
    fun drawn(before: Broadcast<VisibleTriangles>?, bytes: Int): JavaPairRDD<Int, FinishedBand> =
        triangles.partitionBy(ByBand(setUp.value().bands)).mapPartitionsToPair(DrawBand(setUp, before, bytes))

    companion object {
        /** Returns the triangles in [rows], a chunk at a time, with the bands to which [byBand] sends them. */
        fun sent(
            rows: Iterator<Row>,
            byBand: (TriangleChunk) -> Map<Int, TriangleChunk>,
        ): Iterator<Tuple2<Int, TriangleChunk>> = TriangleChunk.chunks(rows)
            .flatMap { chunk -> byBand(chunk).map { (band, some) -> Tuple2(band, some) } }.iterator()
    }
}

/** A task for each band. */
private class ByBand(private val bands: Int) : Partitioner() {
    override fun numPartitions(): Int = bands

    override fun getPartition(key: Any): Int = key as Int

    override fun equals(other: Any?): Boolean = other is ByBand && bands == other.bands

    override fun hashCode(): Int = bands
}

/** Draws a band with colours. */
private class DrawBand(
    private val setUp: Broadcast<PictureSetUp>,
    private val before: Broadcast<VisibleTriangles>?,
    private val bytes: Int,
) : PairFlatMapFunction<Iterator<Tuple2<Int, TriangleChunk>>, Int, FinishedBand> {
    override fun call(arriving: Iterator<Tuple2<Int, TriangleChunk>>): Iterator<Tuple2<Int, FinishedBand>> {
        if (!arriving.hasNext()) return emptyList<Tuple2<Int, FinishedBand>>().iterator()
        val first = arriving.next()
        val band = first._1()
        val known = setUp.value()
        val drawing = known.drawing()
        val samples = BandSamples(drawing.raster, known.region(band))
        val cost = before?.value()?.cost(band)
        var moved = cost?.moved ?: 0L
        for (chunk in TriangleChunk.merged((sequenceOf(first) + arriving.asSequence()).map { it._2() }.iterator())) {
            drawing.part(chunk).draw(samples, isShaded = true)
            moved += chunk.size.toLong() * bytes
        }
        val work = BandPart.sum(listOfNotNull(cost?.work, PixelBlock.work(drawing.work())))
        return listOf(Tuple2(band, FinishedBand.of(samples, moved, work))).iterator()
    }
}
