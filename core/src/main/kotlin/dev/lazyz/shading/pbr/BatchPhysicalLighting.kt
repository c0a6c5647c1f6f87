package dev.lazyz.shading.pbr

import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.LightVectors
import dev.lazyz.shading.light.Loops
import dev.lazyz.shading.light.Viewer
import dev.lazyz.shading.light.hasNumbers
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.world.light.AmbientVisibility
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The formula of [PhysicalLighting.illuminate] for many fragments at a time, in short loops over arrays, which the JVM
 * vectorises. The operations of a fragment and their order are the same, and so are all bits: a light or a soft box
 * that does not reach a fragment adds 0 here, and nothing there.
 *
 * That does not hold for numbers that are not finite; [illuminate] returns false where one occurs, and the caller has
 * to shade the fragments one by one. Immutable and thread safe.
 */
internal class BatchPhysicalLighting(
    viewer: Viewer,
    private val sources: LightSources,
    private val environment: EnvironmentView?,
    private val visibility: AmbientVisibility?,
) {
    private val vectors = LightVectors(viewer, sources, visibility)

    /**
     * Adds the reflected light to the colours of [batch]. The normals (of any length) and the occlusion are in the
     * scratch memory, see [LightVectors], and so is the material, see [DIFFUSE], [REFLECTANCE] and [ROUGHNESS]. Returns
     * false if a normal has no length, or a colour is not a number.
     */
    fun illuminate(batch: FragmentBatch): Boolean {
        val count = batch.size
        val scratch = batch.scratch(ARRAYS)
        if (!vectors.toUnitNormals(scratch, count)) return false
        vectors.view(batch, scratch)
        Loops.dot(scratch, LightVectors.NORMAL, LightVectors.VIEW, scratch[NORMAL_DOT_VIEW], count)
        direct(batch, scratch)
        indirect(batch, scratch)
        return batch.hasNumbers()
    }

    private fun direct(batch: FragmentBatch, scratch: Array<FloatArray>) {
        val count = batch.size
        if (sources.count == 0) return
        squares(scratch[ROUGHNESS], scratch[ALPHA_SQUARE], count)
        for (light in 0 until sources.count) {
            vectors.light(batch, scratch, light)
            halfways(scratch, count)
            grazing(scratch, count)
            sines(scratch, count)
            lobe(scratch, count)
            reflect(batch.red, scratch, 0, sources.color(light, 0), count)
            reflect(batch.green, scratch, 1, sources.color(light, 1), count)
            reflect(batch.blue, scratch, 2, sources.color(light, 2), count)
        }
    }

    private fun squares(roughness: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) {
            val alpha = Microfacets.alpha(roughness[i])
            out[i] = alpha * alpha
        }
    }

    /** Stores the unit vectors halfway between light and viewer. */
    private fun halfways(scratch: Array<FloatArray>, count: Int) {
        for (axis in 0 until 3) {
            val to = scratch[HALFWAY + axis]
            Loops.sum(scratch[LightVectors.LIGHT + axis], scratch[LightVectors.VIEW + axis], to, count)
        }
        Loops.toUnit(scratch, HALFWAY, scratch[LightVectors.LENGTH], count)
    }

    private fun grazing(scratch: Array<FloatArray>, count: Int) {
        val out = scratch[GRAZING]
        Loops.dot(scratch, LightVectors.VIEW, HALFWAY, out, count)
        for (i in 0 until count) out[i] = Microfacets.fifth(maxOf(1f - abs(out[i]), 0f))
    }

    /** Stores the squares of the sines between normals and halfway vectors. */
    private fun sines(scratch: Array<FloatArray>, count: Int) {
        val sine = scratch[SINE]
        val part = scratch[PART]
        for (axis in 0 until 3) {
            val next = (axis + 1) % 3
            val last = (axis + 2) % 3
            cross(
                scratch[LightVectors.NORMAL + next], scratch[HALFWAY + last],
                scratch[LightVectors.NORMAL + last], scratch[HALFWAY + next], part, count,
            )
            Loops.multiply(part, part, count)
            if (axis == 0) part.copyInto(sine, 0, 0, count) else Loops.sum(sine, part, sine, count)
        }
    }

    private fun cross(a: FloatArray, b: FloatArray, c: FloatArray, d: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = a[i] * b[i] - c[i] * d[i]
    }

    private fun lobe(scratch: Array<FloatArray>, count: Int) {
        Loops.dot(scratch, LightVectors.NORMAL, HALFWAY, scratch[PART], count)
        val out = scratch[LOBE]
        distribution(scratch[PART], scratch[SINE], scratch[ALPHA_SQUARE], out, count)
        shadow(scratch[LightVectors.LIT], scratch[NORMAL_DOT_VIEW], scratch[ALPHA_SQUARE], out, count)
        for (i in 0 until count) scratch[PART][i] = Loops.step(scratch[PART][i])
        Loops.multiply(out, scratch[PART], count)
    }

    private fun distribution(cosine: FloatArray, sine: FloatArray, a2: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = Microfacets.distribution(cosine[i], sine[i], a2[i])
    }

    private fun shadow(cosine: FloatArray, along: FloatArray, a2: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = out[i] * Microfacets.visibility(cosine[i], abs(along[i]), a2[i])
    }

    private fun reflect(out: FloatArray, scratch: Array<FloatArray>, channel: Int, color: Float, count: Int) = reflect(
        out, scratch[REFLECTANCE + channel], scratch[DIFFUSE + channel], scratch[GRAZING], scratch[LOBE],
        scratch[LightVectors.STRENGTH], scratch[LightVectors.LIT], color, count,
    )

    private fun reflect(
        out: FloatArray,
        reflectance: FloatArray,
        diffuse: FloatArray,
        grazing: FloatArray,
        lobe: FloatArray,
        strength: FloatArray,
        cosine: FloatArray,
        color: Float,
        count: Int,
    ) {
        for (i in 0 until count) {
            val reflected = PhysicalLighting.reflected(reflectance[i], diffuse[i], grazing[i], lobe[i])
            out[i] = out[i] + color * strength[i] * cosine[i] * reflected
        }
    }

    private fun indirect(batch: FragmentBatch, scratch: Array<FloatArray>) {
        val count = batch.size
        if (environment == null) {
            for (array in RADIANCE until RADIANCE + 6) scratch[array].fill(0f, 0, count)
        } else {
            store(environment, scratch, batch.surface, count)
        }
        split(scratch[NORMAL_DOT_VIEW], scratch[ROUGHNESS], scratch[SCALE], scratch[BIAS], count)
        val open = if (visibility == null) null else scratch[OPEN]
        if (open != null) {
            open.fill(1f, 0, count)
            vectors.occlude(batch, scratch, open)
        }
        gather(batch.red, scratch, 0, open, count)
        gather(batch.green, scratch, 1, open, count)
        gather(batch.blue, scratch, 2, open, count)
    }

    /** Stores the light of the environment, fragment by fragment: loops over arrays take as long. */
    private fun store(environment: EnvironmentView, scratch: Array<FloatArray>, surface: FloatArray, count: Int) {
        val (nx, ny, nz) = List(3) { scratch[LightVectors.NORMAL + it] }
        val (vx, vy, vz) = List(3) { scratch[LightVectors.VIEW + it] }
        for (i in 0 until count) {
            val twice = 2f * scratch[NORMAL_DOT_VIEW][i]
            environment.radiance(
                twice * nx[i] - vx[i], twice * ny[i] - vy[i], twice * nz[i] - vz[i], scratch[ROUGHNESS][i], surface,
            )
            environment.irradiance(nx[i], ny[i], nz[i], surface)
            for (k in 0 until 6) scratch[RADIANCE + k][i] = surface[PhysicalSurface.RADIANCE + k]
        }
    }

    private fun split(along: FloatArray, roughness: FloatArray, scale: FloatArray, bias: FloatArray, count: Int) {
        for (i in 0 until count) {
            DirectionalAlbedo.at(minOf(abs(along[i]), 1f), roughness[i]) { s, b ->
                scale[i] = s
                bias[i] = b
            }
        }
    }

    private fun gather(out: FloatArray, scratch: Array<FloatArray>, channel: Int, open: FloatArray?, count: Int) {
        val f0 = scratch[REFLECTANCE + channel]
        val diffuse = scratch[DIFFUSE + channel]
        val radiance = scratch[RADIANCE + channel]
        val irradiance = scratch[IRRADIANCE + channel]
        add(radiance, sources.ambient[channel], count)
        add(irradiance, sources.ambient[channel], count)
        if (open == null) {
            gather(f0, diffuse, scratch[SCALE], scratch[BIAS], radiance, irradiance, count)
        } else {
            gather(f0, diffuse, scratch[SCALE], scratch[BIAS], radiance, irradiance, open, count)
        }
        Loops.multiply(radiance, scratch[LightVectors.OCCLUSION], count)
        Loops.sum(out, radiance, out, count)
    }

    private fun add(to: FloatArray, summand: Float, count: Int) {
        for (i in 0 until count) to[i] = to[i] + summand
    }

    /** Replaces the radiance by what is reflected. */
    private fun gather(
        f0: FloatArray,
        diffuse: FloatArray,
        scale: FloatArray,
        bias: FloatArray,
        radiance: FloatArray,
        irradiance: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) {
            radiance[i] =
                PhysicalLighting.gathered(f0[i], diffuse[i], scale[i], bias[i], radiance[i], irradiance[i])
        }
    }

    private fun gather(
        f0: FloatArray,
        diffuse: FloatArray,
        scale: FloatArray,
        bias: FloatArray,
        radiance: FloatArray,
        irradiance: FloatArray,
        open: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) {
            radiance[i] =
                PhysicalLighting.gathered(f0[i], diffuse[i], scale[i], bias[i], radiance[i], irradiance[i], open[i], 1f)
        }
    }

    companion object {
        /** The material, see [PhysicalSurface]: the caller sets it. */
        const val DIFFUSE: Int = LightVectors.COUNT
        const val REFLECTANCE: Int = DIFFUSE + 3
        const val ROUGHNESS: Int = REFLECTANCE + 3

        /** Cosines between normals and viewer. */
        const val NORMAL_DOT_VIEW: Int = ROUGHNESS + 1

        /** The light of the environment around the reflected ray, and on a matt surface. */
        const val RADIANCE: Int = NORMAL_DOT_VIEW + 1
        const val IRRADIANCE: Int = RADIANCE + 3

        private const val HALFWAY = IRRADIANCE + 3
        private const val GRAZING = HALFWAY + 3
        private const val SINE = GRAZING + 1
        private const val PART = SINE + 1
        private const val LOBE = PART + 1
        private const val ALPHA_SQUARE = LOBE + 1
        private const val SCALE = ALPHA_SQUARE + 1
        private const val BIAS = SCALE + 1
        private const val OPEN = BIAS + 1

        /** Number of arrays of scratch memory. */
        const val ARRAYS: Int = OPEN + 1
    }
}
