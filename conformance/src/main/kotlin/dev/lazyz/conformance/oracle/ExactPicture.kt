package dev.lazyz.conformance.oracle

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.spi.Fragment

/**
 * The correct picture of a frame of opaque primitives, according to exact surfaces: an oracle for the whole path from
 * vertices to pixels.
 *
 * It decides three things, each according to the contract. Which primitives cover a sample: exactly, by [surfaces];
 * different spans are a fault, and are trusted only where a surface is [Coverage.OPEN]. How deep they are: by the
 * primitive's own integer, because ties are decided with that, but only after checking that it is within one unit of
 * the exact depth (rule 4.4). Which one is visible: by comparing all of them (rule 5). Only the colour is trusted: it
 * is the one that the visible primitive computes (rule 6.1). In contrast, [ReferenceRenderer] trusts primitives and is
 * fast enough for every rule; it is tested against this class, and other renderers are tested against it. Immutable and
 * thread safe.
 *
 * Cost: samples x primitives, in arbitrary precision.
 *
 * @param frame the frame after set-up
 * @param surfaces the exact surface of each primitive of [frame], null for a primitive that must cover nothing (rules
 *   9.4 and 9.5)
 * @throws IllegalArgumentException if the numbers of surfaces and primitives differ, or a primitive is translucent
 */
public class ExactPicture(private val frame: Frame, private val surfaces: List<ExactSurface?>) {
    init {
        require(surfaces.size == frame.primitives.size) {
            "there must be a surface for each of ${frame.primitives.size} primitives: ${surfaces.size}"
        }
        require(!frame.hasTranslucency) { "primitives must be opaque" }
    }

    /**
     * Describes the fault at the first wrong sample of [image], a picture of the whole frame; null if there is none.
     */
    public fun fault(image: Image): String? {
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            for (x in frame.region.columnStart until frame.region.columnEnd) {
                val at = (y - frame.region.rowStart) * image.width + x - frame.region.columnStart
                fault(image, at, x, y)?.let { return "sample ($x, $y): $it" }
            }
        }
        return null
    }

    private fun fault(image: Image, at: Int, x: Int, y: Int): String? {
        var index = DepthTest.BACKGROUND
        var depth = frame.raster.backgroundDepth
        for ((i, surface) in surfaces.withIndex()) {
            val primitive = frame.primitives[i]
            val isCovered = primitive.covers(x, y)
            when (surface?.coverage(x, y) ?: Coverage.UNCOVERED) {
                Coverage.COVERED -> if (!isCovered) return "primitive $i must cover it, but does not"
                Coverage.UNCOVERED -> if (isCovered) return "primitive $i covers it, but must not"
                Coverage.OPEN -> Unit
            }
            if (surface == null || !isCovered) continue
            val own = primitive.depth(x, y)
            val error = surface.depthError(x, y, own)
            if (error > 1.0) return "primitive $i has depth $own, which is $error units off"
            if (isBetter(own, i, depth, index)) {
                depth = own
                index = i
            }
        }
        val shown = image.primitive[at]
        if (shown != index) return "primitive $index is visible, but $shown is shown"
        if (image.depth[at] != depth) return "depth is $depth, but ${image.depth[at]} is shown"
        val color = if (index == DepthTest.BACKGROUND) frame.raster.background.toArgb() else color(index, x, y)
        return if (image.argb[at] == color) null else "colour is not that of primitive $index"
    }

    private fun color(index: Int, x: Int, y: Int): Int {
        val fragment = Fragment().also { it.moveTo(x, y) }
        frame.primitives[index].shade(fragment)
        return fragment.toArgb()
    }

    /**
     * Rules 5.1 to 5.3: less or greater depth; at equal depth, the first or last index; the background counts as first.
     */
    private fun isBetter(depth: Int, index: Int, thanDepth: Int, thanIndex: Int): Boolean {
        val test = frame.raster.depthTest
        val isLess = test == DepthTest.LESS || test == DepthTest.LESS_OR_EQUAL
        if (depth != thanDepth) return if (isLess) depth < thanDepth else depth > thanDepth
        val isLast = test == DepthTest.LESS_OR_EQUAL || test == DepthTest.GREATER_OR_EQUAL
        return if (isLast) index > thanIndex else index < thanIndex
    }

    override fun toString(): String = "ExactPicture($frame, ${surfaces.size} surfaces)"
}
