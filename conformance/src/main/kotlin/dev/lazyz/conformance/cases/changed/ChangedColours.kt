package dev.lazyz.conformance.cases.changed

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.CountingCursor
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.recoloured
import dev.lazyz.scenes.Tint
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor

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

/**
 * Gives fragments one colour, except one sample in five, which has another. Most runs of samples therefore have equal
 * colours at both ends, but another one in between. Immutable and thread safe.
 *
 * @param number seed of the colours and flecks
 */
private class Flecks(private val number: Int) : (Fragment) -> Unit {
    private val light = 0.125f * (1 + number % 4)

    override fun invoke(fragment: Fragment) {
        val isFleck = Tint.hash(number, fragment.x, fragment.y, 0) % 5 == 0
        fragment.setColor(light, if (isFleck) 0.75f else light, 0.5f, fragment.alpha)
    }
}

/** A primitive without a shading cursor. */
private class WithoutCursor(whole: Primitive) : Primitive by whole {
    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
}

/** Returns the frame with [Flecks], and every other primitive [WithoutCursor]. */
internal fun FrameCase.flecked(): FrameCase {
    val primitives = frame.primitives.mapIndexed { index, it ->
        (if (index % 2 == 0) WithoutCursor(it) else it).recoloured(Flecks(index))
    }
    return FrameCase(
        Frame(frame.raster, primitives, frame.region),
        "$code\n    .let { SuiteFrames.flecked(it) }",
    )
}

/**
 * Sets a colour at one sample in three, adds to the green of the initial colour at another, and does nothing at the
 * third. Immutable and thread safe.
 *
 * @param number seed of the samples and colours
 */
private class PartialTint(private val number: Int) : Shader {
    private val tint = Tint(number)

    override fun shade(fragment: Fragment) {
        when (choice(number, fragment.x, fragment.y)) {
            0 -> tint.shade(fragment)
            1 -> fragment.setColor(fragment.red, fragment.green + ADDED, fragment.blue, fragment.alpha)
        }
    }
}

/** As [PartialTint], for many fragments, and with one colour. */
private class PartialBatchTint(private val number: Int) : BatchShader {
    override fun shade(batch: FragmentBatch) {
        for (i in 0 until batch.size) {
            when (choice(number, batch.x[i], batch.y[i])) {
                0 -> batch.red[i] = 1f
                1 -> batch.green[i] += ADDED
            }
        }
    }
}

/** A primitive with the colours of [shader]. */
private class WithShader(private val whole: Primitive, private val shader: Shader) : Primitive by whole {
    override fun shade(fragment: Fragment): Unit = shader.shade(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor = CountingCursor(shader, x, y)
}

private const val ADDED = 0.25f

private fun choice(number: Int, x: Int, y: Int): Int = Tint.hash(number, x, y, 2) % 3

/** Returns shader [number]: of the two sorts in turn. */
private fun partial(number: Int): Shader = if (number % 2 == 0) PartialTint(number) else PartialBatchTint(number)

/**
 * Returns the frame with shaders that set colours at some samples only: those of the materials, if it is the frame of a
 * scene, and those of its primitives otherwise.
 */
internal fun FrameCase.partlyColoured(): FrameCase {
    var number = 0
    val changed = scene?.withMaterials { it.withShader(partial(number++)) }?.frame(frame.raster)
        ?: Frame(frame.raster, frame.primitives.mapIndexed { i, it -> WithShader(it, partial(i)) }, frame.region)
    return FrameCase(changed, "$code\n    .let { SuiteFrames.partlyColoured(it) }")
}
