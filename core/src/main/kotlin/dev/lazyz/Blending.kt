package dev.lazyz

/**
 * Blends the fragments of one sample, nearest first (contract rule 5.5): all renderers that blend use these operations,
 * in this order, so that they agree to the bit.
 *
 *     blending.clear()
 *     for each translucent fragment, from the nearest, while blending.isOpen: blending.add(fragment)
 *     blending.end(the first opaque fragment, or the background)
 *
 * Each fragment weighs its alpha times what the nearer ones let through; the colour is the weighted mean, in linear
 * light, and alpha the sum of the weights. Four numbers of state, no allocation, one division a sample. Belongs to one
 * thread.
 *
 * Source: Thomas Porter and Tom Duff, "Compositing Digital Images", SIGGRAPH 1984, the operator *over*. There colours are
 * premultiplied and stay so; here the result is divided by its alpha once, because pictures have straight alpha.
 */
internal class Blending {
    /** Light let through by the fragments so far; 1 with none. */
    private var transmittance = 1f
    private var weights = 0f

    /** Sums of weight times component; after [end] the colour, linear light with straight [alpha]. */
    var red: Float = 0f
        private set
    var green: Float = 0f
        private set
    var blue: Float = 0f
        private set
    var alpha: Float = 0f
        private set

    /** Whether anything behind the fragments so far can still be seen. */
    val isOpen: Boolean get() = transmittance > 0f

    /** Begins a sample. */
    fun clear() {
        transmittance = 1f
        weights = 0f
        red = 0f
        green = 0f
        blue = 0f
    }

    /** Adds a translucent fragment behind those so far. */
    fun add(fragment: Fragment) {
        val opacity = clamped(fragment.alpha)
        if (opacity > 0f) add(fragment.red, fragment.green, fragment.blue, opacity)
    }

    /** Puts an opaque fragment behind all, and finishes the colour. */
    fun end(backdrop: Fragment) {
        end(backdrop.red, backdrop.green, backdrop.blue, backdrop.alpha)
    }

    /** Puts the background behind all, and finishes the colour. */
    fun end(background: Rgba) {
        end(background.red, background.green, background.blue, background.alpha)
    }

    /** Returns the finished colour, packed to 8-bit sRGB. */
    fun toArgb(): Int = Srgb.pack(red, green, blue, alpha)

    private fun add(red: Float, green: Float, blue: Float, opacity: Float) {
        val weight = transmittance * opacity
        this.red += weight * red
        this.green += weight * green
        this.blue += weight * blue
        weights += weight
        transmittance *= 1f - opacity
    }

    private fun end(red: Float, green: Float, blue: Float, alpha: Float) {
        // With nothing in front the backdrop is left as it is
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
