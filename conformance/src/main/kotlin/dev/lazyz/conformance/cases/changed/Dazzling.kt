package dev.lazyz.conformance.cases.changed

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.recoloured
import dev.lazyz.scenes.Tint

/**
 * Gives fragments extreme colours.
 *
 * Light may be infinite, huge, negative, tiny or NaN, and alpha is mostly exactly 0 or 1. At a quarter of the samples
 * all fragments have alpha 0, at another quarter alpha 1. Immutable and thread safe.
 *
 * @param number seed of the colours
 */
private class Dazzle(private val number: Int) : (Fragment) -> Unit {
    override fun invoke(fragment: Fragment) {
        val alpha = when (Tint.hash(ALL, fragment.x, fragment.y, 0) % 4) {
            0 -> 0f
            1 -> 1f
            else -> drawn(ALPHAS, fragment, 0)
        }
        fragment.setColor(drawn(LIGHT, fragment, 1), drawn(LIGHT, fragment, 2), drawn(LIGHT, fragment, 3), alpha)
    }

    private fun drawn(from: FloatArray, fragment: Fragment, component: Int): Float =
        from[Tint.hash(number, fragment.x, fragment.y, component) % from.size]

    private companion object {
        /** Seed for samples where all primitives have the same alpha. */
        const val ALL = -1

        val ALPHAS = floatArrayOf(0f, 0f, 0f, -0f, 1f, 1f, 0.5f, 0.25f, 1e-30f, -1f, 2f, Float.NaN)

        val LIGHT = floatArrayOf(
            0f, 0.25f, 0.5f, 1f, 2f, -1f, 1e-42f, 1e30f,
            Float.MAX_VALUE, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NaN,
        )
    }
}

/** Returns the frame with the colours of [Dazzle], on a green background with alpha 0. */
internal fun FrameCase.dazzling(): FrameCase {
    val raster = frame.raster.withBackground(Rgba(0.25f, 0.5f, 0.125f, 0f))
    return FrameCase(
        Frame(raster, frame.primitives.mapIndexed { index, it -> it.recoloured(Dazzle(index)) }, frame.region),
        "$code\n    .let { SuiteFrames.dazzling(it) }",
    )
}
