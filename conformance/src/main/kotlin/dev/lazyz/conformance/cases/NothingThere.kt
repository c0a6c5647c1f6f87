package dev.lazyz.conformance.cases

import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Spans

/**
 * A primitive that covers nothing, although its bounds are the whole raster. Throws when its depth or colour is
 * queried.
 */
internal class NothingThere(private val raster: Raster) : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = raster.height
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = raster.width

    override fun spans(y: Int, spans: Spans): Unit = Unit

    override fun depth(x: Int, y: Int): Int =
        throw AssertionError("depth was queried at ($x, $y), where nothing is covered")

    override fun shade(fragment: Fragment): Unit =
        throw AssertionError("shade was called at (${fragment.x}, ${fragment.y}), where nothing is covered")
}
