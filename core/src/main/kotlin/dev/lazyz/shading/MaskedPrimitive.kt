package dev.lazyz.shading

import dev.lazyz.ChangedPrimitive
import dev.lazyz.Primitive
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans

/**
 * A primitive with an alpha mask: it covers the samples whose alpha reaches the cutoff (contract rule 2.7).
 *
 * The mask is part of coverage, not of shading, so renderers need no code for masks: a masked-out sample is never
 * compared by depth. Cost: one texture lookup for each covered sample of each requested row.
 */
internal class MaskedPrimitive(
    override val whole: AttributedPrimitive,
    private val shader: MaterialShader,
    private val cutoff: Float,
) : ChangedPrimitive {
    override val rowStart: Int get() = whole.rowStart
    override val rowEnd: Int get() = whole.rowEnd
    override val columnStart: Int get() = whole.columnStart
    override val columnEnd: Int get() = whole.columnEnd
    override val depthForm: LinearForm? get() = whole.depthForm
    override val leastDepth: Int get() = whole.leastDepth
    override val greatestDepth: Int get() = whole.greatestDepth
    override val heldBytes: Long get() = whole.heldBytes
    override val shadingStartCost: Int get() = whole.shadingStartCost

    override fun spans(y: Int, spans: Spans) {
        val uncut = Spans(spans.columnStart, spans.columnEnd)
        whole.spans(y, uncut)
        val fragment = Fragment()
        for (i in 0 until uncut.count) {
            for (x in uncut.start(i) until uncut.end(i)) {
                fragment.moveTo(x, y)
                whole.attributes(fragment)
                if (shader.reaches(fragment, cutoff)) spans.add(x, x + 1)
            }
        }
    }

    override fun depth(x: Int, y: Int): Int = whole.depth(x, y)

    override fun shade(fragment: Fragment): Unit = whole.shade(fragment)

    override fun geometry(fragment: Fragment): Unit = whole.geometry(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)

    override fun toString(): String = "MaskedPrimitive($whole)"
}

/** A primitive whose interpolated attributes can be computed without a shading call. */
internal interface AttributedPrimitive : Primitive {
    /** Computes the colour from the [attributes]. */
    val shader: Shader

    /** Sets the attributes of [fragment] that shading needs to those at its sample. */
    fun attributes(fragment: Fragment)

    override fun shade(fragment: Fragment) {
        attributes(fragment)
        shader.shade(fragment)
    }

    override fun geometry(fragment: Fragment): Unit = attributes(fragment)
}
