package dev.lazyz.shading.pbr

import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.Viewer
import dev.lazyz.world.light.AmbientVisibility
import kotlin.math.abs

/**
 * The light of a surface with lobes (contract rule 6.16), in single precision, in the order written: what [base]
 * reflects, or [AnisotropicLighting], and what layers add to it and keep away from it. Immutable and thread safe.
 *
 * Sources: the specifications of `KHR_materials_sheen`, `KHR_materials_clearcoat` and `KHR_materials_transmission`,
 * Khronos Group.
 */
internal class LobeLighting(
    private val viewer: Viewer,
    private val sources: LightSources,
    private val environment: EnvironmentView?,
    private val visibility: AmbientVisibility?,
    private val base: PhysicalLighting,
) {
    private val stretched = AnisotropicLighting(viewer, sources, visibility, base)

    /**
     * Replaces the emission in 0..2 of [out] by all light that leaves the surface toward the viewer, and stores in
     * [surface] which part of the light from behind passes. The parameters are those of [PhysicalLighting.illuminate].
     */
    fun illuminate(
        surface: FloatArray,
        occlusion: Float,
        px: Float,
        py: Float,
        pz: Float,
        normalX: Float,
        normalY: Float,
        normalZ: Float,
        out: FloatArray,
    ) {
        val red = out[0]
        val green = out[1]
        val blue = out[2]
        out.fill(0f, 0, 3)
        if (surface[PhysicalSurface.FILM] > 0f) {
            viewer.from(px, py, pz, normalX, normalY, normalZ) { vx, vy, vz, nx, ny, nz ->
                ThinFilm.cover(
                    surface, PhysicalSurface.REFLECTANCE, surface[PhysicalSurface.FILM],
                    surface[PhysicalSurface.FILM + 1], surface[PhysicalSurface.FILM + 2],
                    minOf(abs(nx * vx + ny * vy + nz * vz), 1f),
                )
            }
        }
        if (surface[PhysicalSurface.ANISOTROPY] > 0f) {
            stretched.illuminate(surface, occlusion, px, py, pz, normalX, normalY, normalZ, out)
        } else {
            base.illuminate(surface, occlusion, px, py, pz, normalX, normalY, normalZ, out)
        }
        viewer.from(px, py, pz, normalX, normalY, normalZ) { vx, vy, vz, nx, ny, nz ->
            val cosineV = abs(nx * vx + ny * vy + nz * vz)
            val open = occlusion * (visibility?.at(px, py, pz, nx, ny, nz) ?: 1f)
            transmit(surface, cosineV, vx, vy, vz, out)
            if (mostOf(surface, PhysicalSurface.SHEEN) > 0f) {
                sheen(surface, open, px, py, pz, nx, ny, nz, vx, vy, vz, cosineV, out)
            }
            out[0] += red
            out[1] += green
            out[2] += blue
            if (surface[PhysicalSurface.COAT] > 0f) coat(surface, open, px, py, pz, out)
        }
    }

    /**
     * Stores which part of the light from behind passes: a number between the least and the mean of the three colours,
     * so that the glass keeps its hue and still shows what is behind. Colours of which more passes glow.
     */
    private fun transmit(surface: FloatArray, cosineV: Float, vx: Float, vy: Float, vz: Float, out: FloatArray) {
        surface[PhysicalSurface.PASSED] = 0f
        if (!(mostOf(surface, PhysicalSurface.TRANSMITTED) > 0f)) return
        val at = PhysicalSurface.TRANSMITTED
        DirectionalAlbedo.at(minOf(cosineV, 1f), surface[PhysicalSurface.ROUGHNESS]) { scale, bias ->
            for (channel in 0 until 3) {
                val once = surface[PhysicalSurface.REFLECTANCE + channel] * scale +
                    surface[PhysicalSurface.GRAZING] * bias
                surface[at + channel] *= maxOf(1f - once, 0f)
            }
        }
        val mean = (surface[at] + surface[at + 1] + surface[at + 2]) / 3f
        val least = minOf(surface[at], surface[at + 1], surface[at + 2])
        val passed = minOf(0.5f * (mean + least), MOST_PASSED)
        irradiance(surface, -vx, -vy, -vz)
        for (channel in 0 until 3) {
            out[channel] += maxOf(surface[at + channel] - passed, 0f) * surface[PhysicalSurface.IRRADIANCE + channel]
        }
        surface[PhysicalSurface.PASSED] = passed
    }

    private fun sheen(
        surface: FloatArray,
        open: Float,
        px: Float,
        py: Float,
        pz: Float,
        nx: Float,
        ny: Float,
        nz: Float,
        vx: Float,
        vy: Float,
        vz: Float,
        cosineV: Float,
        out: FloatArray,
    ) {
        val roughness = surface[PhysicalSurface.SHEEN_ROUGHNESS]
        val albedo = Fibres.albedo(minOf(cosineV, 1f), roughness)
        cover(surface, maxOf(1f - mostOf(surface, PhysicalSurface.SHEEN) * albedo, 0f), out)
        irradiance(surface, nx, ny, nz)
        for (channel in 0 until 3) {
            out[channel] += surface[PhysicalSurface.SHEEN + channel] * albedo *
                surface[PhysicalSurface.IRRADIANCE + channel] * open
        }
        sources.inFront(px, py, pz, nx, ny, nz, vx, vy, vz) { light, strength, cosineL, _, sineSquare, _ ->
            val lobe = Fibres.distribution(sineSquare, roughness) * Fibres.visibility(cosineL, cosineV)
            for (channel in 0 until 3) {
                out[channel] += sources.color(light, channel) * strength * cosineL *
                    (surface[PhysicalSurface.SHEEN + channel] * lobe)
            }
        }
    }

    private fun coat(surface: FloatArray, open: Float, px: Float, py: Float, pz: Float, out: FloatArray) {
        val at = PhysicalSurface.COAT_NORMAL
        viewer.from(px, py, pz, surface[at], surface[at + 1], surface[at + 2]) { vx, vy, vz, nx, ny, nz ->
            val along = nx * vx + ny * vy + nz * vz
            val cosineV = abs(along)
            val roughness = surface[PhysicalSurface.COAT_ROUGHNESS]
            val fresnel = Microfacets.DIELECTRIC + (1f - Microfacets.DIELECTRIC) * Microfacets.grazing(cosineV)
            val weight = surface[PhysicalSurface.COAT] * fresnel
            cover(surface, 1f - weight, out)
            surface.fill(0f, PhysicalSurface.RADIANCE, PhysicalSurface.RADIANCE + 3)
            environment?.radiance(
                2f * along * nx - vx, 2f * along * ny - vy, 2f * along * nz - vz, roughness, surface,
            )
            for (channel in 0 until 3) {
                out[channel] += weight * (surface[PhysicalSurface.RADIANCE + channel] + sources.ambient[channel]) * open
            }
            val alpha = Microfacets.alpha(roughness)
            val a2 = alpha * alpha
            sources.inFront(px, py, pz, nx, ny, nz, vx, vy, vz) { light, strength, cosineL, cosineH, sineSquare, _ ->
                val lobe = Microfacets.lobe(cosineH, sineSquare, cosineL, cosineV, a2)
                for (channel in 0 until 3) {
                    out[channel] += sources.color(light, channel) * strength * cosineL * (weight * lobe)
                }
            }
        }
    }

    /** Multiplies what comes from below a layer by the part [kept] that passes it. */
    private fun cover(surface: FloatArray, kept: Float, out: FloatArray) {
        for (channel in 0 until 3) out[channel] *= kept
        surface[PhysicalSurface.PASSED] *= kept
    }

    /** Stores the light from all sides around the direction (x, y, z) in [surface]. */
    private fun irradiance(surface: FloatArray, x: Float, y: Float, z: Float) {
        surface.fill(0f, PhysicalSurface.IRRADIANCE, PhysicalSurface.IRRADIANCE + 3)
        environment?.irradiance(x, y, z, surface)
        for (channel in 0 until 3) surface[PhysicalSurface.IRRADIANCE + channel] += sources.ambient[channel]
    }

    private fun mostOf(surface: FloatArray, at: Int): Float =
        maxOf(surface[at], maxOf(surface[at + 1], surface[at + 2]))

    private companion object {
        /** The most that passes, so that highlights on clear glass, which are divided by the rest, stay finite. */
        const val MOST_PASSED = 0.98f
    }
}

/**
 * The reflection of fibres, `KHR_materials_sheen`: the distribution of A. Conty Estevez and C. Kulla, "Production
 * Friendly Microfacet Sheen BRDF", 2017, and the visibility of D. Neubelt and M. Pettineo, "Crafting a Next-Gen
 * Material Pipeline for The Order: 1886", 2013.
 */
internal object Fibres {
    private const val SIZE = 16
    private const val STRATA = 32
    private const val LEAST_ALPHA = 1f / 512f
    private val albedos = SquareTable(SIZE)

    init {
        for (row in 0 until SIZE) {
            for (column in 0 until SIZE) {
                albedos.numbers[row * SIZE + column] = integral(column / (SIZE - 1.0), row / (SIZE - 1f))
            }
        }
    }

    /** Returns pi times D, the distribution of fibres of a perceptual [roughness]. */
    fun distribution(sineSquare: Float, roughness: Float): Float {
        val inverse = 1f / maxOf(roughness * roughness, LEAST_ALPHA)
        val power = StrictMath.pow(minOf(sineSquare, 1f).toDouble(), 0.5 * inverse).toFloat()
        return (2f + inverse) * 0.5f * power
    }

    /** Returns V for N.L above 0 and N.V. */
    fun visibility(cosineL: Float, cosineV: Float): Float = 1f / (4f * (cosineL + cosineV - cosineL * cosineV))

    /** Returns how much of uniform light is reflected at N.V, for a perceptual [roughness], each in 0..1. */
    fun albedo(cosine: Float, roughness: Float): Float = albedos.at(cosine, roughness)

    /** Returns the mean of D V N.L over the hemisphere, times 2 pi, at most 1. */
    private fun integral(cosineV: Double, roughness: Float): Float {
        val sineV = StrictMath.sqrt(1.0 - cosineV * cosineV)
        var sum = 0.0
        for (i in 0 until STRATA) {
            val cosineL = (i + 0.5) / STRATA
            val sineL = StrictMath.sqrt(1.0 - cosineL * cosineL)
            for (k in 0 until STRATA) {
                // The square of N.H is (N.L + N.V)^2 / |L + V|^2
                val between = sineL * sineV * StrictMath.cos(StrictMath.PI * (k + 0.5) / STRATA) + cosineL * cosineV
                val cosineH = (cosineL + cosineV) * (cosineL + cosineV) / (2.0 + 2.0 * between)
                val lobe = distribution(maxOf(1.0 - cosineH, 0.0).toFloat(), roughness) *
                    visibility(cosineL.toFloat(), cosineV.toFloat())
                sum += lobe * cosineL
            }
        }
        return minOf(2.0 * sum / (STRATA * STRATA), 1.0).toFloat()
    }
}
