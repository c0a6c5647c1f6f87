package dev.lazyz.strategies.warnock

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.LinearForm
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.raster.VisibilityOrder

/**
 * The visibility keys of a band of rows. They are set in two ways: without comparing ([fill]), and by minimum ([draw]).
 */
internal class BandPainting(frame: Frame, bandHeight: Int, private val counters: Counters.Builder) {
    private val region = frame.region
    private val order = VisibilityOrder(frame.raster.depthTest)
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
        val form = cover.primitive.depthForm
        for (y in area.rowStart until area.rowEnd) {
            if (form == null) fillRow(area, y, cover) else fillRow(area, y, cover.index, form)
        }
    }

    private fun fillRow(area: Region, y: Int, cover: BandCoverage) {
        var at = at(area.columnStart, y)
        for (x in area.columnStart until area.columnEnd) {
            keys[at++] = test.key(cover.primitive.depth(x, y), cover.index)
        }
    }

    /** Where depth is linear, each sample takes one addition. */
    private fun fillRow(area: Region, y: Int, index: Int, form: LinearForm) {
        var at = at(area.columnStart, y)
        var z = form.at(area.columnStart, y)
        for (x in area.columnStart until area.columnEnd) {
            keys[at++] = order.key(z, index)
            z += form.dx
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
        val primitive = candidate.primitive
        val form = primitive.depthForm
        var z = form?.at(start, y) ?: 0L
        val step = form?.dx ?: 0L
        var at = at(start, y)
        var passes = 0
        for (x in start until end) {
            // Where depth is linear, each sample takes one addition
            val depth = if (form != null) (z shr 32).toInt() else primitive.depth(x, y)
            z += step
            val key = test.key(depth, candidate.index)
            if (key < keys[at]) {
                keys[at] = key
                passes++
            }
            at++
        }
        counters.depthPasses += passes
    }
}
