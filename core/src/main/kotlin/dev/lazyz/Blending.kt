package dev.lazyz

import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Srgb

/**
 * Blends the fragments of one sample from front to back (contract rule 5.5). All renderers that blend use these
 * operations in this order, so their results are equal bit for bit.
 *
 *     blending.clear()
 *     for each translucent fragment, from the nearest, while blending.isOpen: blending.add(fragment)
 *     blending.end(the first opaque fragment, or the background)
 *
 * The weight of a fragment is its alpha times the transmittance of the fragments in front of it. The colour is the
 * weighted mean in linear light, and alpha is the sum of the weights. State: six floats. Cost: no allocation, three
 * divisions a sample. Used by one thread.
 *
 * Source: Thomas Porter and Tom Duff, "Compositing Digital Images", SIGGRAPH 1984, the operator *over*. The paper keeps
 * colours premultiplied. Here the result is divided by its alpha once, because images have straight alpha.
 */
public class Blending {
    /** Fraction of light that passes through the fragments so far; 1 if there are none. */
    private var transmittance = 1f
    private var weights = 0f

    /** Sum of weight times component. After [end]: the colour in linear light, with straight [alpha]. */
    public var red: Float = 0f
        private set

    /** See [red]. */
    public var green: Float = 0f
        private set

    /** See [red]. */
    public var blue: Float = 0f
        private set

    /** See [red]. */
    public var alpha: Float = 0f
        private set

    /** Whether a fragment behind the fragments so far would be visible. */
    public val isOpen: Boolean get() = transmittance > 0f

    /** Starts a new sample. */
    public fun clear() {
        transmittance = 1f
        weights = 0f
        red = 0f
        green = 0f
        blue = 0f
    }

    /** Adds a translucent fragment behind the fragments so far. */
    public fun add(fragment: Fragment) {
        val opacity = clamped(fragment.alpha)
        if (opacity > 0f) add(fragment.red, fragment.green, fragment.blue, opacity)
    }

    /** Adds the opaque fragment behind all others, and computes the final colour. */
    public fun end(backdrop: Fragment) {
        end(backdrop.red, backdrop.green, backdrop.blue, backdrop.alpha)
    }

    /** Adds the background behind all fragments, and computes the final colour. */
    public fun end(background: Rgba) {
        end(background.red, background.green, background.blue, background.alpha)
    }

    /** Returns the final colour, packed to 8-bit sRGB, `0xAARRGGBB`. */
    public fun toArgb(): Int = Srgb.pack(red, green, blue, alpha)

    /**
     * Blends one sample, and returns its final colour, packed to 8-bit sRGB. The [layers] translucent fragments have
     * the numbers from 0 on, from the nearest; the opaque fragment behind them has the number [layers]. If there is
     * none ([hasBackdrop] is false), the [background] is behind them. [shade] computes the colour of the fragment with
     * a number; it is called only for fragments that are visible.
     */
    internal inline fun blend(
        layers: Int,
        hasBackdrop: Boolean,
        background: Rgba,
        shade: (number: Int) -> Fragment,
    ): Int {
        clear()
        var number = 0
        while (number < layers && isOpen) add(shade(number++))
        if (isOpen && hasBackdrop) end(shade(layers)) else end(background)
        return toArgb()
    }

    private fun add(red: Float, green: Float, blue: Float, opacity: Float) {
        val weight = transmittance * opacity
        this.red += weight * red
        this.green += weight * green
        this.blue += weight * blue
        weights += weight
        transmittance *= 1f - opacity
    }

    private fun end(red: Float, green: Float, blue: Float, alpha: Float) {
        // With nothing in front, the backdrop is unchanged
        if (weights == 0f) {
            this.red = red
            this.green = green
            this.blue = blue
            this.alpha = alpha
            return
        }
        val opacity = clamped(alpha)
        if (isOpen && opacity > 0f) add(red, green, blue, opacity)
        this.red /= weights
        this.green /= weights
        this.blue /= weights
        this.alpha = weights
    }

    private fun clamped(alpha: Float): Float = when {
        !(alpha > 0f) -> 0f
        alpha >= 1f -> 1f
        else -> alpha
    }
}

/**
 * Checks that [frame] has no translucent primitives, for a [renderer] that does not blend (contract rule 5.6). Called
 * before the rendering starts.
 *
 * @throws IllegalArgumentException if the frame has translucent primitives
 */
internal fun requireOpaque(frame: Frame, renderer: Renderer) {
    if (!frame.hasTranslucency) return
    require(!frame.isStreamed) {
        "the frame is streamed and has translucent primitives, and the renderer '${renderer.id}' does not blend: " +
            "use 'tiled', which does, or make it opaque with asOpaque()"
    }
    throw opaqueNeeded(frame.primitives.indexOfFirst { it.isTranslucent }, renderer)
}

/** The exception for a translucent primitive, with submission index [index]. */
internal fun opaqueNeeded(index: Int, renderer: Renderer) = IllegalArgumentException(
    "primitive $index is translucent and the renderer '${renderer.id}' does not blend: " +
        "use 'tiled' or 'lists', which do, or make it opaque with asOpaque()",
)

/** An opaque version of a translucent primitive: the same coverage, depth and light, with alpha 1. */
internal class OpaquePrimitive(override val whole: Primitive) :
    ChangedPrimitive,
    Primitive by whole {
    override val isTranslucent: Boolean get() = false

    override fun shade(fragment: Fragment) {
        whole.shade(fragment)
        fragment.setColor(fragment.red, fragment.green, fragment.blue)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)?.let { OpaqueCursor(it) }

    override fun toString(): String = "OpaquePrimitive($whole)"

    private class OpaqueCursor(private val whole: ShadingCursor) : ShadingCursor {
        override fun step() = whole.step()

        override fun shade(fragment: Fragment) {
            whole.shade(fragment)
            fragment.setColor(fragment.red, fragment.green, fragment.blue)
        }
    }
}
