package dev.lazyz.conformance.oracle

import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Spans

/**
 * The picture of a frame of opaque primitives as exact surfaces say it should be: the oracle of the whole path from
 * vertices to pixels.
 *
 * Three things are decided here, each by the contract's words. Which primitives cover a sample: exactly, by
 * [surfaces]; spans that say otherwise are a fault, and are believed only where a surface is [Coverage.OPEN]. How deep
 * they are: a primitive's own integer, because ties are decided on that, but only after it has been found within rule
 * 4.4's unit of the exact depth.
 * Who is visible: by comparing all of them (rule 5). So what remains on trust is the colour alone, which is what the
 * visible primitive says it is (rule 6.1). [ReferenceRenderer] on the other hand trusts primitives, and is fast enough
 * for every rule; it is held to this class, and renderers to it. Immutable and thread safe.
 *
 * Cost: samples x primitives, in arbitrary precision.
 *
 * @param frame what was set up
 * @param surfaces for each primitive of [frame] what it should be, null for what covers nothing (rules 9.4 and 9.5)
 * @throws IllegalArgumentException if there are not as many surfaces as primitives, or one is translucent
 */
public class ExactPicture(private val frame: Frame, private val surfaces: List<ExactSurface?>) {
    init {
        require(surfaces.size == frame.primitives.size) {
            "there must be a surface for each of ${frame.primitives.size} primitives: ${surfaces.size}"
        }
        require(!frame.hasTranslucency) { "primitives must be opaque" }
    }

    /**
     * Returns what is wrong with [image], a picture of the whole frame, at its first wrong sample; null if nothing is.
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
            val isCovered = hasInSpans(primitive, x, y)
            when (surface?.coverage(x, y) ?: Coverage.UNCOVERED) {
                Coverage.COVERED -> if (!isCovered) return "primitive $i must cover it, and does not"
                Coverage.UNCOVERED -> if (isCovered) return "primitive $i covers it, and must not"
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

    /** Rules 5.1 to 5.3: less or greater depth; if equal, who came first or last; the background came before all. */
    private fun isBetter(depth: Int, index: Int, thanDepth: Int, thanIndex: Int): Boolean {
        val test = frame.raster.depthTest
        val isLess = test == DepthTest.LESS || test == DepthTest.LESS_OR_EQUAL
        if (depth != thanDepth) return if (isLess) depth < thanDepth else depth > thanDepth
        val isLast = test == DepthTest.LESS_OR_EQUAL || test == DepthTest.GREATER_OR_EQUAL
        return if (isLast) index > thanIndex else index < thanIndex
    }

    override fun toString(): String = "ExactPicture($frame, ${surfaces.size} surfaces)"

    private companion object {
        fun hasInSpans(primitive: Primitive, x: Int, y: Int): Boolean {
            val spans = Spans().also { primitive.spans(y, it) }
            return (0 until spans.count).any { x >= spans.start(it) && x < spans.end(it) }
        }
    }
}
