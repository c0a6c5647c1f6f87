package dev.lazyz.conformance.strangers4

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Spans

/** Renders tiles, one after the other, on one thread: decides what is visible, then shades it. */
internal class TileWorker(
    private val frame: Frame,
    private val grid: TileGrid,
    private val bins: TileBins,
    private val picture: TilePicture,
    private val fragment: Fragment,
    private val mistake: Mistake?,
) {
    val counters = Counters.Builder()
    private val test = frame.raster.depthTest
    private val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val backgroundColor = frame.raster.background.toArgb()
    private val keys = LongArray(grid.side * grid.side)
    private val veils = TileVeils(keys, mistake)
    private val blender = Blender(mistake)
    private var area = grid.region
    private var farthest = Long.MAX_VALUE
    private var flatIndex = DepthTest.BACKGROUND
    private var flatColor = 0

    fun render(tile: Int) {
        area = grid.area(tile)
        keys.fill(background, 0, area.size.toInt())
        if (mistake != Mistake.TILE_STALE_FARTHEST) farthest = background
        flatIndex = DepthTest.BACKGROUND
        veils.clear()

        // From near to far: a bound of the depth tells when the rest is hidden
        val order = LongArray(bins.size(tile)) { bound(bins.index(tile, it)) }
        order.sort()
        val spans = Spans(area)
        drawOpaque(order, spans)
        updateFarthest()
        for (bound in order) {
            if (bound >= farthest) break
            val primitive = frame.primitives[test.indexOf(bound)]
            if (primitive.isTranslucent) draw(primitive, test.indexOf(bound), spans, isVeil = true)
        }
        veils.sort(area.size.toInt())
        shade()
        counters.peakBytes = maxOf(counters.peakBytes, 8L * (keys.size + order.size) + veils.bytes)
    }

    private fun bound(index: Int): Long {
        val primitive = frame.primitives[index]
        if (mistake == Mistake.TILE_LEAST_FOR_ALL_TESTS) return test.key(primitive.leastDepth, index)
        return test.boundOf(primitive, index)
    }

    private fun drawOpaque(order: LongArray, spans: Spans) {
        var drawn = 0
        for (bound in order) {
            val primitive = frame.primitives[test.indexOf(bound)]
            if (primitive.isTranslucent) continue
            if (drawn > 0 && drawn % UPDATE == 0) updateFarthest()
            if (isHidden(bound)) break
            draw(primitive, test.indexOf(bound), spans, isVeil = false)
            drawn++
        }
    }

    private fun isHidden(bound: Long): Boolean =
        if (mistake == Mistake.TILE_TIE_IS_HIDDEN) bound ushr 32 >= farthest ushr 32 else bound >= farthest

    private fun updateFarthest() {
        var most = Long.MIN_VALUE
        for (at in 0 until area.size.toInt()) most = maxOf(most, keys[at])
        farthest = most
    }

    private fun draw(primitive: Primitive, index: Int, spans: Spans, isVeil: Boolean) {
        val top = maxOf(primitive.rowStart, area.rowStart)
        val bottom = minOf(primitive.rowEnd, area.rowEnd)
        if (top >= bottom) return
        val cursor = primitive.cursor(top)
        val form = primitive.depthForm
        for (y in top until bottom) {
            cursor.next(spans)
            for (i in 0 until spans.count) {
                val start = spans.start(i)
                val end = spans.end(i)
                counters.fragments += end - start
                counters.depthEvaluations += end - start
                var z = form?.at(start, y) ?: 0L
                var at = (y - area.rowStart) * area.width + start - area.columnStart
                for (x in start until end) {
                    val depth = if (form != null) (z shr 32).toInt() else primitive.depth(x, y)
                    if (form != null) z += form.dx
                    val key = test.key(depth, index)
                    if (isVeil) {
                        if (veils.add(at, key)) counters.depthPasses++
                    } else if (key < keys[at]) {
                        keys[at] = key
                        counters.depthPasses++
                    }
                    at++
                }
            }
        }
    }

    private fun shade() {
        var waiting = veils.count.toLong()
        for (at in 0 until area.size.toInt()) if (keys[at] != background) waiting++
        counters.peakSuspensions =
            if (mistake == Mistake.TILE_PEAK_BY_WORKER) {
                counters.peakSuspensions + waiting
            } else {
                maxOf(counters.peakSuspensions, waiting)
            }
        for (y in area.rowStart until area.rowEnd) {
            for (x in area.columnStart until area.columnEnd) {
                val at = (y - area.rowStart) * area.width + x - area.columnStart
                val to = (y - grid.region.rowStart) * grid.region.width + x - grid.region.columnStart
                val from = veils.start(at)
                picture.keys[to] = if (from < veils.end(at)) veils.key(from) else keys[at]
                picture.argb[to] = if (from < veils.end(at)) blended(x, y, at) else opaque(x, y, keys[at])
            }
        }
    }

    private fun opaque(x: Int, y: Int, key: Long): Int {
        val index = test.indexOf(key)
        if (index == DepthTest.BACKGROUND) return backgroundColor
        if (mistake == Mistake.TILE_ONE_COLOR && frame.primitives[index].shadingCursor(x, y) == null) {
            // Nothing is interpolated, so the colour is the same all over
            if (index != flatIndex) flatColor = shaded(x, y, index).toArgb()
            flatIndex = index
            return flatColor
        }
        return shaded(x, y, index).toArgb()
    }

    private fun shaded(x: Int, y: Int, index: Int): Fragment {
        counters.shadingCalls++
        counters.shadingStarts++
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        return fragment
    }

    private fun blended(x: Int, y: Int, at: Int): Int {
        blender.clear()
        var veil = veils.start(at)
        while (veil < veils.end(at) && blender.isOpen) blender.add(shaded(x, y, test.indexOf(veils.key(veil++))))
        if (!blender.isOpen && mistake != Mistake.TILE_SHADES_BEHIND) return blender.finish()
        val index = test.indexOf(keys[at])
        return if (index == DepthTest.BACKGROUND) {
            blender.finish(frame.raster.background)
        } else {
            blender.finish(shaded(x, y, index))
        }
    }

    private companion object {
        /** Primitives between two looks for the farthest sample. */
        const val UPDATE = 4
    }
}

/** The finished picture of a region, written by all threads, each in its own tiles. */
internal class TilePicture(region: Region) {
    val argb: IntArray
    val keys: LongArray

    init {
        require(region.size <= Int.MAX_VALUE - 8L) { "too many samples to hold at once: ${region.size}" }
        argb = IntArray(region.size.toInt())
        keys = LongArray(region.size.toInt())
    }

    val bytes: Long get() = 12L * argb.size
}
