package dev.lazyz.conformance.oracle

import dev.lazyz.Rgba

/** The colour of a sample with translucent fragments, which are added from near to far (contract rule 5.5). */
internal class BlendedSample {
    private var transmittance = 1f
    private val sums = FloatArray(4)

    /** Whether further fragments can change the colour. */
    val isOpen: Boolean get() = transmittance > 0f

    /** Whether a fragment with an alpha above 0 has been added. */
    val hasColor: Boolean get() = sums[3] != 0f

    /** The colour of the fragments so far; there must be one with an alpha above 0. */
    val color: Rgba get() = Rgba(sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3], sums[3])

    /** Adds the next fragment, or the backdrop, behind the others. */
    fun add(color: Rgba) {
        val a = if (color.alpha > 0f) minOf(color.alpha, 1f) else 0f
        if (a == 0f) return
        val w = transmittance * a
        sums[0] += w * color.red
        sums[1] += w * color.green
        sums[2] += w * color.blue
        sums[3] += w
        transmittance *= 1f - a
    }
}
