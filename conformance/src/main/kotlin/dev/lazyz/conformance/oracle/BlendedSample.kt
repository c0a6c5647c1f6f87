package dev.lazyz.conformance.oracle

import dev.lazyz.Rgba

/** The colour of a sample with translucent fragments, which are added from near to far (contract rule 5.5). */
internal class BlendedSample private constructor() {
    private var transmittance = 1f
    private val sums = FloatArray(4)

    /** Whether further fragments can change the colour. */
    private val isOpen: Boolean get() = transmittance > 0f

    /** Whether a fragment with an alpha above 0 has been added. */
    private val hasColor: Boolean get() = sums[3] != 0f

    /** The colour of the fragments so far; there must be one with an alpha above 0. */
    private val color: Rgba get() = Rgba(sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3], sums[3])

    /** Adds the next fragment, or the backdrop, behind the others. */
    private fun add(color: Rgba) {
        val a = if (color.alpha > 0f) minOf(color.alpha, 1f) else 0f
        if (a == 0f) return
        val w = transmittance * a
        sums[0] += w * color.red
        sums[1] += w * color.green
        sums[2] += w * color.blue
        sums[3] += w
        transmittance *= 1f - a
    }

    /** A fragment. Its [color] is asked for only if it shows. */
    class Layer(val isTranslucent: Boolean, val color: () -> Rgba)

    companion object {
        /** Returns what a sample shows whose fragments are [nearestFirst], before [background]. */
        fun of(nearestFirst: List<Layer>, background: Rgba): Rgba {
            val sample = BlendedSample()
            for (layer in nearestFirst) {
                if (!layer.isTranslucent) break
                if (sample.isOpen) sample.add(layer.color())
            }
            if (!sample.isOpen) return sample.color
            val backdrop = nearestFirst.firstOrNull { !it.isTranslucent }
            val behind = if (backdrop == null) background else backdrop.color()
            if (!sample.hasColor) return behind
            sample.add(behind)
            return sample.color
        }
    }
}
