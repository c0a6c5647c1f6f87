package dev.lazyz.strategies.warnock

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.raster.forEachKey

/**
 * The visibility keys of a band of rows. They are set in two ways: without comparing ([fill]), and by minimum ([draw]).
 */
internal class BandPainting(frame: Frame, bandHeight: Int, private val counters: Counters.Builder) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private var firstRow = 0

    /** The key of each sample, in rows from the top of the band. */
    val keys: LongArray = LongArray(region.width * bandHeight)

    /** Bytes held. */
    val bytes: Long get() = keys.bytes

    /** Moves to [band]. */
    fun begin(band: Region) {
        firstRow = band.rowStart
    }

    private fun at(x: Int, y: Int): Int = (y - firstRow) * region.width + (x - region.columnStart)

    /** Sets all samples of [area] to the [cover], which covers them all, or to the background, without comparing. */
    fun fill(area: Region, cover: BandCoverage?) {
        if (cover == null) {
            for (y in area.rowStart until area.rowEnd) {
                val start = at(area.columnStart, y)
                keys.fill(backgroundKey, start, start + area.width)
            }
            return
        }
        counters.depthEvaluations += area.size
        counters.depthPasses += area.size
        for (y in area.rowStart until area.rowEnd) {
            var at = at(area.columnStart, y)
            cover.primitive.forEachKey(cover.index, test, y, area.columnStart, area.columnEnd) { _, key ->
                keys[at++] = key
            }
        }
    }

    /** Scan-converts the [candidate] in [area]; each sample keeps the lesser key. */
    fun draw(area: Region, candidate: BandCoverage) {
        val box = candidate.boxIn(area)
        for (y in box.rowStart until box.rowEnd) {
            var position = candidate.firstSpan(y, box.columnStart)
            val end = candidate.endOfRow(y)
            while (position < end && candidate.start(position) < box.columnEnd) {
                val from = maxOf(candidate.start(position), box.columnStart)
                drawSpan(candidate, y, from, minOf(candidate.end(position), box.columnEnd))
                position += 2
            }
        }
    }

    private fun drawSpan(candidate: BandCoverage, y: Int, start: Int, end: Int) {
        counters.depthEvaluations += end - start
        var at = at(start, y)
        var passes = 0
        candidate.primitive.forEachKey(candidate.index, test, y, start, end) { _, key ->
            if (key < keys[at]) {
                keys[at] = key
                passes++
            }
            at++
        }
        counters.depthPasses += passes
    }
}
