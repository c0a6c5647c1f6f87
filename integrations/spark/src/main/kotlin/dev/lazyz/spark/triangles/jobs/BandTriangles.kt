package dev.lazyz.spark.triangles.jobs

import dev.lazyz.spark.pictures.PixelBlock
import dev.lazyz.spark.triangles.BandSamples
import dev.lazyz.spark.triangles.FragmentRuns
import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.TriangleChunk
import java.io.Serializable
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

/**
 * The triangles that are visible in each band. Immutable. Memory: 8 bytes for each triangle and band, at most one for
 * each sample.
 */
internal class VisibleTriangles(bands: List<OfBand>) : Serializable {
    /** The triangles of a band, and what it took to find them. */
    class OfBand(val band: Int, val indices: IntArray, val cost: Cost) : Serializable

    /**
     * What it took to find the triangles of a band.
     *
     * @property moved bytes that have crossed from task to task
     * @property work counters, as [BandPart.work]
     */
    class Cost(val moved: Long, val work: LongArray) : Serializable

    /** Index and band of each visible triangle, in ascending order. */
    private val places = LongArray(bands.sumOf { it.indices.size })
    private val costs: Map<Int, Cost> = bands.associate { it.band to it.cost }

    init {
        var count = 0
        for (of in bands) for (index in of.indices) places[count++] = place(index, of.band)
        places.sort()
    }

    /** Returns what it took to find the triangles of [band]. */
    fun cost(band: Int): Cost = costs.getValue(band)

    /** Returns the triangles of [chunk] that are visible in each band, by the number of the band. */
    fun byBand(chunk: TriangleChunk): Map<Int, TriangleChunk> {
        val numbers = HashMap<Int, ArrayList<Int>>()
        val found = places.binarySearch(place(chunk.index(0), 0))
        var next = if (found < 0) -found - 1 else found
        var number = 0
        while (next < places.size && number < chunk.size) {
            val index = (places[next] ushr Int.SIZE_BITS).toInt()
            when {
                chunk.index(number) < index -> number++
                chunk.index(number) > index -> next++
                else -> numbers.getOrPut(places[next++].toInt()) { ArrayList() } += number
            }
        }
        return numbers.mapValues { (_, some) -> chunk.select(some.toIntArray()) }
    }

    private companion object {
        fun place(index: Int, band: Int): Long = index.toLong() shl Int.SIZE_BITS or band.toLong()
    }
}

/** A part of a band: [group] is the number of the partition, or of some partitions that were merged. */
internal data class BandKey(val band: Int, val group: Int) : Serializable

/**
 * The nearest fragments of some triangles in a band, and what it took to find them.
 *
 * @property moved bytes that have crossed from task to task so far
 * @property work counters so far, as [PixelBlock.work]
 */
internal class BandPart(val runs: FragmentRuns, val moved: Long, val work: LongArray) : Serializable {
    companion object {
        /** Returns the sums, and the greatest peak. */
        fun sum(all: List<LongArray>): LongArray = LongArray(PEAK + 1) { i ->
            if (i == PEAK) all.maxOfOrNull { it[i] } ?: 0 else all.sumOf { it[i] }
        }

        private const val PEAK = 5
    }
}

/** A finished band. */
internal class FinishedBand(val pixels: PixelBlock, val moved: Long) : Serializable {
    companion object {
        /** Returns the band of [samples], all of them with colours. */
        fun of(samples: BandSamples, moved: Long, work: LongArray): FinishedBand {
            val block = PixelBlock.Builder(samples.region, planes = 3)
            samples.forEachRow { _, argb, depth, primitive ->
                block.add(argb)
                block.add(depth)
                block.add(primitive)
            }
            return FinishedBand(block.build(PixelBlock.counters(work)), moved)
        }
    }
}

/** Merges parts of a band by the minimum of their keys. */
internal class MergeParts(private val setUp: Broadcast<PictureSetUp>, private val isShaded: Boolean) : Serializable {
    /** Returns the samples of a band, and what it took. */
    fun merged(band: Int, parts: Iterable<BandPart>): Merged {
        val known = setUp.value()
        val samples = BandSamples(known.drawing().raster, known.region(band))
        var moved = 0L
        val work = ArrayList<LongArray>()
        for (part in parts) {
            samples.add(part.runs)
            moved += part.moved + part.runs.size
            work += part.work
        }
        return Merged(samples, moved, BandPart.sum(work))
    }

    /** Returns the merged part, to be merged with others. */
    fun part(band: Int, parts: Iterable<BandPart>): BandPart =
        with(merged(band, parts)) { BandPart(samples.toRuns(isShaded), moved, work) }

    class Merged(val samples: BandSamples, val moved: Long, val work: LongArray)
}
