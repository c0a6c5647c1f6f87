package dev.lazyz.conformance.oracle

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.spi.Fragment

/**
 * The oracle of selectors: lists the fragments of each sample as contract rule 5 defines, and chooses one.
 *
 * @property selector the selector that the renderer gets
 * @param shown the expected result for a sample's fragments, nearest first: the fragment whose depth and primitive are
 *   shown and its colour, or null for the background
 */
internal class Selection(val selector: Selector, private val shown: (List<Seen>) -> Pair<Seen, Int>?) {
    /** A fragment of a sample. */
    class Seen(private val frame: Frame, val x: Int, val y: Int, val index: Int) {
        val depth: Int = frame.primitives[index].depth(x, y)

        val isTranslucent: Boolean get() = frame.primitives[index].isTranslucent

        /** Linear light. */
        val background: Rgba get() = frame.raster.background

        /** Linear light. */
        val color: Rgba by lazy {
            val fragment = Fragment()
            fragment.moveTo(x, y)
            frame.primitives[index].shade(fragment)
            Rgba(fragment.red, fragment.green, fragment.blue, fragment.alpha)
        }
    }

    /** Returns the expected picture of [frame] with [selector]. */
    fun of(frame: Frame): Image {
        val region = frame.region
        val size = region.size.toInt()
        val argb = IntArray(size) { frame.raster.background.toArgb() }
        val depth = IntArray(size) { frame.raster.backgroundDepth }
        val primitive = IntArray(size) { DepthTest.BACKGROUND }
        for (i in 0 until size) {
            val x = region.columnStart + i % region.width
            val y = region.rowStart + i / region.width
            val fragments = frame.fragments(x, y).map { Seen(frame, x, y, it) }
            val (seen, color) = (if (fragments.isEmpty()) null else shown(fragments)) ?: continue
            argb[i] = color
            depth[i] = seen.depth
            primitive[i] = seen.index
        }
        return Image(region, argb, depth, primitive, Counters.NONE)
    }

    companion object {
        private const val LAYER = 2

        /** The colours of [Selector.count], as documented there, for 1, 2, 3, 4, 5 to 8 ... fragments. */
        private val ramp =
            listOf(0x440154, 0x46327E, 0x365C8D, 0x277F8E, 0x1FA187, 0x4AC16D, 0xA0DA39, 0xFDE725).map { it or OPAQUE }

        private const val OPAQUE = 0xFF shl 24

        private fun heat(count: Int): Int =
            ramp[listOf(1, 2, 3, 4, 8, 16, 32).indexOfFirst { count <= it }.let { if (it < 0) 7 else it }]

        /** Uses the position of the cell, and the depth and primitive of another fragment. */
        val byPlace: Selection = Selection(
            { cell ->
                val i = (cell.x + 3 * cell.y) % cell.size
                val other = cell.size - 1 - i
                cell.show(i, cell.depth(other) % 256 / 255f, cell.primitive(other) % 8 / 7f, 0f, 1f)
            },
        ) { seen ->
            val i = (seen[0].x + 3 * seen[0].y) % seen.size
            val other = seen[seen.size - 1 - i]
            seen[i] to Rgba(other.depth % 256 / 255f, other.index % 8 / 7f, 0f, 1f).toArgb()
        }

        /** Selectors by name: built-in and custom ones. */
        val all: Map<String, Selection> = mapOf(
            "nearest" to Selection(Selector.nearest()) { it.first().plain() },
            "farthest" to Selection(Selector.farthest()) { it.last().plain() },
            "number $LAYER" to Selection(Selector.kthNearest(LAYER)) { it.getOrNull(LAYER - 1)?.plain() },
            "blend" to Selection(Selector.blend()) { seen -> seen.first() to blended(seen).toArgb() },
            "count" to Selection(Selector.count()) { it.first() to heat(it.size) },
            "the last if it is red" to lastIfRed(),
            "every other one as a mean" to mean(),
            "one chosen by place, in a colour by depth" to byPlace,
            "the last of several calls" to lastCall(),
            "the last of several calls, in a colour" to lastCallInColor(),
            "the nearest before the background" to beforeTheBackground(),
            "the farthest, brighter than white" to brighterThanWhite(),
        )

        private fun blended(seen: List<Seen>): Rgba {
            val layers = seen.map { layer -> BlendedSample.Layer(layer.isTranslucent) { layer.color } }
            return BlendedSample.of(layers, seen.first().background)
        }

        private fun Seen.plain() = this to color.toArgb()

        /** Evaluates a colour before it decides, and shows the background where a sample has only one fragment. */
        private fun lastIfRed() = Selection(
            { cell ->
                val last = cell.size - 1
                if (last > 0) cell.show(if (cell.shade(last).red > 0.5f) last else 0)
            },
        ) { seen ->
            if (seen.size == 1) null else (if (seen.last().color.red > 0.5f) seen.last() else seen.first()).plain()
        }

        /** Calls `show` for several fragments, with and without colours, and finally for the one in the middle. */
        private fun lastCall() = Selection(
            { cell ->
                for (i in 0 until cell.size) if (i % 2 == 0) cell.show(i) else cell.show(i, 1f, 0f, 1f, 1f)
                cell.show(cell.size / 2)
            },
        ) { seen -> seen[seen.size / 2].plain() }

        /** Calls `show` for all fragments from the back, and finally for the nearest in green. */
        private fun lastCallInColor() = Selection(
            { cell ->
                for (i in cell.size - 1 downTo 0) cell.show(i)
                cell.show(0, 0f, 1f, 0f, 0.5f)
            },
        ) { seen -> seen.first() to Rgba(0f, 1f, 0f, 0.5f).toArgb() }

        /** Shows whether the background's colour is exact, and the nearest fragment's blue. */
        private fun beforeTheBackground() = Selection(
            { cell ->
                val behind = cell.background
                cell.show(0, fine(behind.red), fine(behind.green), cell.shade(0).blue, fine(behind.alpha))
            },
        ) { seen ->
            val behind = seen[0].background
            seen[0] to Rgba(fine(behind.red), fine(behind.green), seen[0].color.blue, fine(behind.alpha)).toArgb()
        }

        /** Returns a number in 0..1 that depends on all bits of [value]. */
        private fun fine(value: Float): Float {
            val bits = value.toRawBits()
            return (bits xor (bits shr 8) xor (bits shr 16) xor (bits shr 24) and 0xFF) / 255f
        }

        /** Uses components outside of 0..1, by very little and by much. */
        private fun brighterThanWhite() = Selection(
            { cell -> cell.show(cell.size - 1, 1e9f, -1f, Float.NaN, 1f + (cell.x % 3) / 256f) },
        ) { seen -> seen.last() to Rgba(1f, 0f, 0f, 1f).toArgb() }

        /** Mixes the colours of several fragments, and shows the depth of the farthest. */
        private fun mean() = Selection(
            { cell ->
                var red = 0f
                var blue = 0f
                for (i in 0 until cell.size step 2) {
                    val fragment = cell.shade(i)
                    red += fragment.red / cell.size
                    blue += fragment.blue / cell.size
                }
                cell.show(cell.size - 1, red, 0f, blue, 1f)
            },
        ) { seen ->
            var red = 0f
            var blue = 0f
            for (i in seen.indices step 2) {
                red += seen[i].color.red / seen.size
                blue += seen[i].color.blue / seen.size
            }
            seen.last() to Rgba(red, 0f, blue, 1f).toArgb()
        }
    }
}
