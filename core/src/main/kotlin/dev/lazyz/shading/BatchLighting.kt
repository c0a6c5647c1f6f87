package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.LightVectors
import dev.lazyz.shading.light.Loops
import dev.lazyz.shading.light.Viewer
import dev.lazyz.shading.light.hasNumbers
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading

/**
 * The formula of [Lighting.illuminate] for many fragments at a time, in short loops over arrays, which the JVM
 * vectorises. The operations of a fragment and their order are the same, and so are all bits: a light that does not
 * reach a fragment adds +0 here, and nothing there.
 *
 * That does not hold for numbers that are not finite; [illuminate] returns false where one occurs, and the caller has
 * to shade the fragments one by one. Immutable and thread safe.
 */
internal class BatchLighting(viewer: Viewer, private val sources: LightSources, visibility: AmbientVisibility?) {
    private val vectors = LightVectors(viewer, sources, visibility)

    /**
     * Multiplies the colours of [batch] by the light at its fragments, and adds highlights and [emission]. The normals
     * (of any length) and the occlusion are in the scratch memory, see [LightVectors]. Returns false if a normal has no
     * length, or a colour is not a number.
     */
    fun illuminate(batch: FragmentBatch, material: Material, emission: Rgba): Boolean {
        val count = batch.size
        val scratch = batch.scratch(ARRAYS)
        if (!vectors.toUnitNormals(scratch, count)) return false
        val occlusion = scratch[LightVectors.OCCLUSION]
        vectors.occlude(batch, scratch, occlusion)
        for (channel in 0 until 3) {
            Loops.product(occlusion, sources.ambient[channel], scratch[DIFFUSE + channel], count)
        }
        scratch[ADDED].fill(emission.red, 0, count)
        scratch[ADDED + 1].fill(emission.green, 0, count)
        scratch[ADDED + 2].fill(emission.blue, 0, count)
        val specular = material.specular
        val isShiny = specular.red > 0f || specular.green > 0f || specular.blue > 0f
        if (isShiny) vectors.view(batch, scratch)
        val strength = scratch[LightVectors.STRENGTH]
        for (light in 0 until sources.count) {
            vectors.light(batch, scratch, light)
            for (channel in 0 until 3) {
                val color = sources.color(light, channel)
                add(scratch[DIFFUSE + channel], color, strength, scratch[LightVectors.LIT], count)
            }
            if (!isShiny) continue
            if (material.shading == Shading.PHONG) reflections(scratch, count) else halfways(scratch, count)
            raise(scratch, material.shininess, count)
            add(scratch[ADDED], sources.color(light, 0), strength, specular.red, scratch[POWER], count)
            add(scratch[ADDED + 1], sources.color(light, 1), strength, specular.green, scratch[POWER], count)
            add(scratch[ADDED + 2], sources.color(light, 2), strength, specular.blue, scratch[POWER], count)
        }
        light(batch.red, scratch[DIFFUSE], scratch[ADDED], count)
        light(batch.green, scratch[DIFFUSE + 1], scratch[ADDED + 1], count)
        light(batch.blue, scratch[DIFFUSE + 2], scratch[ADDED + 2], count)
        return batch.hasNumbers()
    }

    private fun light(color: FloatArray, factor: FloatArray, summand: FloatArray, count: Int) {
        for (i in 0 until count) color[i] = color[i] * factor[i] + summand[i]
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
        Loops.dot(scratch, LightVectors.NORMAL, LightVectors.VIEW, scratch[HALFWAY], count)
        Loops.dot(scratch, LightVectors.LIGHT, LightVectors.VIEW, scratch[HALFWAY + 1], count)
        val cosine = scratch[LightVectors.COSINE]
        reflect(cosine, scratch[HALFWAY], scratch[HALFWAY + 1], scratch[HIGHLIGHT], count)
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
        for (axis in 0 until 3) {
            val to = scratch[HALFWAY + axis]
            Loops.sum(scratch[LightVectors.LIGHT + axis], scratch[LightVectors.VIEW + axis], to, count)
        }
        val length = scratch[LightVectors.LENGTH]
        Loops.lengths(scratch, HALFWAY, length, count)
        Loops.dot(scratch, LightVectors.NORMAL, HALFWAY, scratch[HIGHLIGHT], count)
        Loops.divide(scratch[HIGHLIGHT], length, count)
    }

    /** Stores the powers of highlights that are above 0 where the light's cosine is, too; 0 elsewhere. */
    private fun raise(scratch: Array<FloatArray>, exponent: Int, count: Int) {
        val square = scratch[HIGHLIGHT]
        val power = scratch[POWER]
        mask(square, scratch[LightVectors.LIT], count)
        power.fill(1f, 0, count)
        var rest = exponent
        while (true) {
            if (rest and 1 != 0) Loops.multiply(power, square, count)
            rest = rest ushr 1
            if (rest == 0) return
            Loops.multiply(square, square, count)
        }
    }

    /** Replaces what is not above 0 by 0, and what has a [cosine] of 0. */
    private fun mask(values: FloatArray, cosine: FloatArray, count: Int) {
        for (i in 0 until count) values[i] = maxOf(values[i], 0f) * Loops.step(cosine[i])
    }

    companion object {
        /** The light that colours are multiplied by, and the light that is added to the product. */
        private const val DIFFUSE = LightVectors.COUNT
        private const val ADDED = DIFFUSE + 3
        private const val HALFWAY = ADDED + 3
        private const val HIGHLIGHT = HALFWAY + 3
        private const val POWER = HIGHLIGHT + 1

        /** Number of arrays of scratch memory. */
        const val ARRAYS: Int = POWER + 1

        /** Fewer fragments are faster one by one. */
        const val FEWEST: Int = 8
    }
}
