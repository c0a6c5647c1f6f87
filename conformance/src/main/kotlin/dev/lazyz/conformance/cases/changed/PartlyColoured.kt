package dev.lazyz.conformance.cases.changed

import dev.lazyz.BatchShader
import dev.lazyz.Fragment
import dev.lazyz.FragmentBatch
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Shader
import dev.lazyz.ShadingCursor
import dev.lazyz.conformance.cases.CountingCursor
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.scenes.Tint

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
