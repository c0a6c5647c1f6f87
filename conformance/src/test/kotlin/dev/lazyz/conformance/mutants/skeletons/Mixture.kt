package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.spi.Fragment

/** The sums of rule 5.5. */
internal open class Mixture {
    var transmittance = 1f
    var weights = 0f
    var red = 0f
    var green = 0f
    var blue = 0f
    var alpha = 0f

    open val isOpen: Boolean get() = transmittance > 0f

    open fun add(fragment: Fragment) = add(fragment.red, fragment.green, fragment.blue, opacity(fragment.alpha))

    open fun opacity(alpha: Float): Float = if (alpha > 0f) minOf(alpha, 1f) else 0f

    open fun isPassedOver(opacity: Float): Boolean = opacity == 0f

    open fun add(red: Float, green: Float, blue: Float, opacity: Float) {
        if (isPassedOver(opacity)) return
        val weight = transmittance * opacity
        this.red += weight * red
        this.green += weight * green
        this.blue += weight * blue
        weights += weight
        transmittance *= 1f - opacity
    }

    open fun end(red: Float, green: Float, blue: Float, alpha: Float) {
        if (weights == 0f) {
            this.red = red
            this.green = green
            this.blue = blue
            this.alpha = alpha
            return
        }
        if (isOpen) add(red, green, blue, opacity(alpha))
        divide()
        this.alpha = weights
    }

    open fun divide() {
        red /= weights
        green /= weights
        blue /= weights
    }
}
