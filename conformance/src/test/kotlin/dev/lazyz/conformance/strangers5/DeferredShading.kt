package dev.lazyz.conformance.strangers5

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame

/** Shades a decided band, column by column. */
internal class DeferredShading(frame: Frame, private val lists: DeferredLists, private val mistake: Mistake?) {
    private val raster = frame.raster
    private val primitives = frame.primitives
    private val firstColumn = frame.region.columnStart
    private val width = frame.width
    private val test = raster.depthTest
    private val backgroundColor = raster.background.toArgb()
    private val fragment = Fragment()
    private val mixer = Mixer(mistake)

    /** Shades column [x] of the region. */
    fun column(x: Int, keys: LongArray, result: DeferredResult) {
        var row = 0
        while (row < result.height) {
            val at = row * width + x
            if (mistake == Mistake.DEFERRED_EQUAL_ENDS) {
                val end = runEnd(x, row, keys, result.height)
                if (end - row > 2 && fill(x, row, end, keys, result)) {
                    row = end
                    continue
                }
            }
            sample(x, row, at, keys[at], result)
            row++
        }
    }

    private fun sample(x: Int, row: Int, at: Int, key: Long, result: DeferredResult) {
        val count = translucent(at, key)
        if (count > 0) {
            blend(x, row, at, key, count, result)
            return
        }
        val index = test.indexOf(key)
        result.depths[at] = test.depthOf(key)
        result.indices[at] = index
        if (index == DepthTest.BACKGROUND) {
            result.argb[at] = backgroundColor
        } else {
            shade(x, row, index, result)
            result.argb[at] = fragment.toArgb()
        }
    }

    private fun translucent(at: Int, key: Long): Int {
        val limit = if (mistake == Mistake.DEFERRED_NO_RETEST) Long.MAX_VALUE else key
        if (mistake == Mistake.DEFERRED_SHORT_INDEX) {
            return lists.gather(at, limit) { it ushr 32 shl 16 or (it and 0xFFFF) }
        }
        if (mistake != Mistake.DEFERRED_FLOAT_ORDER) return lists.gather(at, limit) { it }
        return lists.gather(at, limit) {
            (it ushr 32).toInt().toFloat().toRawBits().toLong() shl 32 or (it and 0x7FFFFFFFL)
        }
    }

    private fun shade(x: Int, row: Int, index: Int, result: DeferredResult): Fragment {
        val counters: Counters.Builder = result.counters
        counters.shadingCalls++
        counters.shadingStarts++
        counters.peakSuspensions = maxOf(counters.peakSuspensions, result.argb.size.toLong())
        fragment.moveTo(firstColumn + x, result.top + row)
        primitives[index].shade(fragment)
        return fragment
    }

    private fun blend(x: Int, row: Int, at: Int, key: Long, count: Int, result: DeferredResult) {
        mixer.begin()
        var nearest = -1
        var i = 0
        while (i < count && mixer.isOpen) {
            mixer.add(shade(x, row, test.indexOf(lists.gathered[i]), result))
            if (nearest < 0 && (mistake != Mistake.DEFERRED_CLEAR_GLASS || fragment.alpha > 0f)) nearest = i
            i++
        }
        val index = test.indexOf(key)
        result.argb[at] = if (mixer.isOpen && index != DepthTest.BACKGROUND) {
            shade(x, row, index, result)
            mixer.finish(fragment.red, fragment.green, fragment.blue, fragment.alpha)
        } else {
            mixer.finish(raster.background)
        }
        val shown = if (nearest >= 0) lists.gathered[nearest] else key
        result.depths[at] = test.depthOf(shown)
        result.indices[at] = test.indexOf(shown)
    }

    private fun runEnd(x: Int, row: Int, keys: LongArray, height: Int): Int {
        val index = test.indexOf(keys[row * width + x])
        var end = row
        while (end < height) {
            val at = end * width + x
            if (test.indexOf(keys[at]) != index || lists.length(at) > 0) break
            end++
        }
        return if (index == DepthTest.BACKGROUND) row else end
    }

    /** Fills a run whose ends have the same colour with it. */
    private fun fill(x: Int, row: Int, end: Int, keys: LongArray, result: DeferredResult): Boolean {
        val index = test.indexOf(keys[row * width + x])
        val upper = shade(x, row, index, result).toArgb()
        val lower = shade(x, end - 1, index, result).toArgb()
        if (upper != lower) {
            result.counters.shadingCalls -= 2
            result.counters.shadingStarts -= 2
            return false
        }
        for (r in row until end) {
            val at = r * width + x
            result.argb[at] = upper
            result.depths[at] = test.depthOf(keys[at])
            result.indices[at] = index
        }
        return true
    }
}
