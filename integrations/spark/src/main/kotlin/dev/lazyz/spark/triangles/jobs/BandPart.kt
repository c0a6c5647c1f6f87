package dev.lazyz.spark.triangles.jobs

import dev.lazyz.spark.pictures.PixelBlock
import dev.lazyz.spark.triangles.BandSamples
import dev.lazyz.spark.triangles.FragmentRuns
import dev.lazyz.spark.triangles.PictureSetUp
import java.io.Serializable
import org.apache.spark.broadcast.Broadcast

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
