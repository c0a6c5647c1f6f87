package dev.lazyz.shading

import dev.lazyz.FragmentBatch
import dev.lazyz.Rgba
import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.Viewer
import dev.lazyz.world.AmbientVisibility
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import kotlin.math.sqrt

/**
 * The formula of [Lighting.illuminate] for many fragments at a time, in short loops over arrays, which the JVM
 * vectorises. The operations of a fragment and their order are the same, and so are all bits: a light that does not
 * reach a fragment adds +0 here, and nothing there.
 *
 * That does not hold for numbers that are not finite; [illuminate] and [apply] return false where one occurs, and the
 * caller has to shade the fragments one by one. Immutable and thread safe.
 */
internal class BatchLighting(
    private val viewer: Viewer,
    private val sources: LightSources,
    private val visibility: AmbientVisibility?,
) {
    /**
     * Computes the light at the fragments of [batch], whose normals (of any length) and occlusion are in the scratch
     * memory, see [NORMAL] and [OCCLUSION]. Returns false if a normal has no length.
     */
    fun illuminate(batch: FragmentBatch, material: Material, emission: Rgba): Boolean {
        val count = batch.size
        val scratch = batch.scratch(ARRAYS)
        if (!normalize(scratch, count)) return false
        visibility?.let { occlude(batch, scratch, it) }
        for (channel in 0 until 3) {
            product(scratch[OCCLUSION], sources.ambient[channel], scratch[DIFFUSE + channel], count)
        }
        scratch[ADDED].fill(emission.red, 0, count)
        scratch[ADDED + 1].fill(emission.green, 0, count)
        scratch[ADDED + 2].fill(emission.blue, 0, count)
        val specular = material.specular
        val isShiny = specular.red > 0f || specular.green > 0f || specular.blue > 0f
        if (isShiny) view(batch, scratch)
        for (light in 0 until sources.count) {
            direct(batch, scratch, light)
            cosines(scratch, count)
            for (channel in 0 until 3) {
                val color = sources.color(light, channel)
                add(scratch[DIFFUSE + channel], color, scratch[STRENGTH], scratch[LIT], count)
            }
            if (!isShiny) continue
            if (material.shading == Shading.PHONG) reflections(scratch, count) else halfways(scratch, count)
            raise(scratch, material.shininess, count)
            for (channel in 0 until 3) {
                val color = sources.color(light, channel)
                val factor = if (channel == 0) {
                    specular.red
                } else if (channel == 1) {
                    specular.green
                } else {
                    specular.blue
                }
                add(scratch[ADDED + channel], color, scratch[STRENGTH], factor, scratch[POWER], count)
            }
        }
        return true
    }

    /**
     * Multiplies the colours of [batch] by the light that [illuminate] has computed, and adds the highlights. Returns
     * false if one is not a number.
     */
    fun apply(batch: FragmentBatch): Boolean {
        val count = batch.size
        val scratch = batch.scratch(ARRAYS)
        light(batch.red, scratch[DIFFUSE], scratch[ADDED], count)
        light(batch.green, scratch[DIFFUSE + 1], scratch[ADDED + 1], count)
        light(batch.blue, scratch[DIFFUSE + 2], scratch[ADDED + 2], count)
        for (i in 0 until count) if ((batch.red[i] + batch.green[i] + batch.blue[i]).isNaN()) return false
        return true
    }

    private fun light(color: FloatArray, factor: FloatArray, summand: FloatArray, count: Int) {
        for (i in 0 until count) color[i] = color[i] * factor[i] + summand[i]
    }

    private fun normalize(scratch: Array<FloatArray>, count: Int): Boolean {
        val x = scratch[NORMAL]
        val y = scratch[NORMAL + 1]
        val z = scratch[NORMAL + 2]
        val length = scratch[LENGTH]
        lengths(x, y, z, length, count)
        for (i in 0 until count) if (!(length[i] > 0f)) return false
        for (axis in 0 until 3) divide(scratch[NORMAL + axis], length, count)
        return true
    }

    private fun lengths(x: FloatArray, y: FloatArray, z: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i])
    }

    private fun divide(a: FloatArray, by: FloatArray, count: Int) {
        for (i in 0 until count) a[i] = a[i] / by[i]
    }

    private fun occlude(batch: FragmentBatch, scratch: Array<FloatArray>, visibility: AmbientVisibility) {
        val occlusion = scratch[OCCLUSION]
        for (i in 0 until batch.size) {
            occlusion[i] *= visibility.at(
                batch.worldX[i], batch.worldY[i], batch.worldZ[i],
                scratch[NORMAL][i], scratch[NORMAL + 1][i], scratch[NORMAL + 2][i],
            )
        }
    }

    private fun product(from: FloatArray, factor: Float, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = factor * from[i]
    }

    /** Stores the unit vectors to the viewer. */
    private fun view(batch: FragmentBatch, scratch: Array<FloatArray>) {
        val count = batch.size
        val x = scratch[VIEW]
        val y = scratch[VIEW + 1]
        val z = scratch[VIEW + 2]
        if (viewer.isPerspective) {
            towards(viewer.eyeX, batch.worldX, x, count)
            towards(viewer.eyeY, batch.worldY, y, count)
            towards(viewer.eyeZ, batch.worldZ, z, count)
            lengths(x, y, z, scratch[LENGTH], count)
            for (axis in 0 until 3) divide(scratch[VIEW + axis], scratch[LENGTH], count)
        } else {
            x.fill(viewer.backX, 0, count)
            y.fill(viewer.backY, 0, count)
            z.fill(viewer.backZ, 0, count)
        }
    }

    private fun towards(target: Float, from: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = target - from[i]
    }

    /** Stores the unit vectors to a light, and its strength, as [LightSources.from] has them. */
    private fun direct(batch: FragmentBatch, scratch: Array<FloatArray>, light: Int) {
        val count = batch.size
        val numbers = sources.numbers
        val at = LightSources.STRIDE * light
        val x = scratch[LIGHT]
        val y = scratch[LIGHT + 1]
        val z = scratch[LIGHT + 2]
        val strength = scratch[STRENGTH]
        val kind = numbers[at + LightSources.KIND]
        if (kind == LightSources.VARYING) {
            for (i in 0 until count) {
                sources.from(light, batch.worldX[i], batch.worldY[i], batch.worldZ[i]) { lx, ly, lz, factor ->
                    x[i] = lx
                    y[i] = ly
                    z[i] = lz
                    strength[i] = factor
                }
            }
            return
        }
        strength.fill(1f, 0, count)
        if (kind == LightSources.UNIFORM) {
            towards(numbers[at], batch.worldX, x, count)
            towards(numbers[at + 1], batch.worldY, y, count)
            towards(numbers[at + 2], batch.worldZ, z, count)
            lengths(x, y, z, scratch[LENGTH], count)
            for (axis in 0 until 3) divide(scratch[LIGHT + axis], scratch[LENGTH], count)
        } else {
            x.fill(numbers[at], 0, count)
            y.fill(numbers[at + 1], 0, count)
            z.fill(numbers[at + 2], 0, count)
        }
    }

    /** Stores the cosines between normals and the light, and which of them are above 0. */
    private fun cosines(scratch: Array<FloatArray>, count: Int) {
        val cosine = scratch[COSINE]
        dot(scratch, NORMAL, LIGHT, cosine, count)
        positive(cosine, scratch[LIT], count)
    }

    private fun dot(scratch: Array<FloatArray>, a: Int, b: Int, out: FloatArray, count: Int) =
        dot(scratch[a], scratch[a + 1], scratch[a + 2], scratch[b], scratch[b + 1], scratch[b + 2], out, count)

    private fun dot(
        ax: FloatArray,
        ay: FloatArray,
        az: FloatArray,
        bx: FloatArray,
        by: FloatArray,
        bz: FloatArray,
        out: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) out[i] = ax[i] * bx[i] + ay[i] * by[i] + az[i] * bz[i]
    }

    private fun positive(from: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = maxOf(from[i], 0f)
    }

    private fun add(to: FloatArray, color: Float, strength: FloatArray, cosine: FloatArray, count: Int) {
        for (i in 0 until count) to[i] = to[i] + color * strength[i] * cosine[i]
    }

    private fun add(
        to: FloatArray,
        color: Float,
        strength: FloatArray,
        factor: Float,
        power: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) to[i] = to[i] + color * strength[i] * factor * power[i]
    }

    /** Stores the cosines between the reflected rays and the viewer: Phong's highlight. */
    private fun reflections(scratch: Array<FloatArray>, count: Int) {
        dot(scratch, NORMAL, VIEW, scratch[HALFWAY], count)
        dot(scratch, LIGHT, VIEW, scratch[HALFWAY + 1], count)
        reflect(scratch[COSINE], scratch[HALFWAY], scratch[HALFWAY + 1], scratch[HIGHLIGHT], count)
    }

    private fun reflect(
        cosine: FloatArray,
        normalView: FloatArray,
        lightView: FloatArray,
        out: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) out[i] = 2f * cosine[i] * normalView[i] - lightView[i]
    }

    /** Stores the cosines between the normals and the halfway vectors: Blinn's highlight. */
    private fun halfways(scratch: Array<FloatArray>, count: Int) {
        for (axis in 0 until 3) sum(scratch[LIGHT + axis], scratch[VIEW + axis], scratch[HALFWAY + axis], count)
        lengths(scratch[HALFWAY], scratch[HALFWAY + 1], scratch[HALFWAY + 2], scratch[LENGTH], count)
        dot(scratch, NORMAL, HALFWAY, scratch[HIGHLIGHT], count)
        divide(scratch[HIGHLIGHT], scratch[LENGTH], count)
    }

    private fun sum(a: FloatArray, b: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = a[i] + b[i]
    }

    /** Stores the powers of highlights that are above 0 where the light's cosine is, too; 0 elsewhere. */
    private fun raise(scratch: Array<FloatArray>, exponent: Int, count: Int) {
        val square = scratch[HIGHLIGHT]
        val power = scratch[POWER]
        mask(square, scratch[LIT], count)
        power.fill(1f, 0, count)
        var rest = exponent
        while (true) {
            if (rest and 1 != 0) multiply(power, square, count)
            rest = rest ushr 1
            if (rest == 0) return
            multiply(square, square, count)
        }
    }

    /** Replaces what is not above 0 by 0, and what has a [cosine] of 0: any other, times 2^254, is at least 1. */
    private fun mask(values: FloatArray, cosine: FloatArray, count: Int) {
        for (i in 0 until count) values[i] = maxOf(values[i], 0f) * minOf(cosine[i] * LARGE * LARGE, 1f)
    }

    private fun multiply(a: FloatArray, b: FloatArray, count: Int) {
        for (i in 0 until count) a[i] = a[i] * b[i]
    }

    companion object {
        /** Normals, three arrays: the caller sets them, to any length. */
        const val NORMAL: Int = 0

        /** The factor of ambient light; set by the caller. */
        const val OCCLUSION: Int = 3

        /** The light that colours are multiplied by, and the light that is added to the product. */
        private const val DIFFUSE = 4
        private const val ADDED = 7

        /** Unit vectors to the viewer and to a light; halfway vectors. */
        private const val VIEW = 10
        private const val LIGHT = 13
        private const val HALFWAY = 16
        private const val STRENGTH = 19

        /** Cosines between normal and light, and the same with 0 for those below 0. */
        private const val COSINE = 20
        private const val LIT = 21
        private const val HIGHLIGHT = 22
        private const val POWER = 23
        private const val LENGTH = 24

        /** Number of arrays of scratch memory. */
        const val ARRAYS: Int = 25

        private const val LARGE = 1.7014118346046923e38f

        /** Fewer fragments are faster one by one. */
        const val FEWEST: Int = 8
    }
}
