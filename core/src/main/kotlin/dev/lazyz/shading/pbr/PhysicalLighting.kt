package dev.lazyz.shading.pbr

import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.Viewer
import dev.lazyz.world.light.AmbientVisibility
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The light that a metallic-roughness surface reflects (contract rule 6.8), in single precision, in the order written.
 * Immutable and thread safe.
 *
 * Lights with a position or a direction follow glTF 2.0, appendix B, exactly. Ambient light, which is equal from all
 * directions, and the [environment] use the split sum, with the light that is reflected more than once between
 * microfacets: C. Fdez-Agüera, "A Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting", JCGT 8
 * (2019).
 */
internal class PhysicalLighting(
    private val viewer: Viewer,
    private val sources: LightSources,
    private val environment: EnvironmentView?,
    private val visibility: AmbientVisibility?,
) {
    /** The same for many fragments at a time. */
    val ofBatches: BatchPhysicalLighting = BatchPhysicalLighting(viewer, sources, environment, visibility)

    /**
     * Adds the reflected light to 0..2 of [out].
     *
     * @param surface the material at the point, see [PhysicalSurface]
     * @param occlusion factor of ambient light and of the environment
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
    ) = viewer.from(px, py, pz, normalX, normalY, normalZ) { vx, vy, vz, nx, ny, nz ->
        val along = nx * vx + ny * vy + nz * vz
        direct(surface, px, py, pz, nx, ny, nz, vx, vy, vz, abs(along), out)
        val open = if (visibility == null) 1f else visibility.at(px, py, pz, nx, ny, nz)
        indirect(
            surface, occlusion, open, nx, ny, nz, 2f * along * nx - vx, 2f * along * ny - vy, 2f * along * nz - vz,
            along, out,
        )
    }

    private fun direct(
        surface: FloatArray,
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
        val alpha = Microfacets.alpha(surface[PhysicalSurface.ROUGHNESS])
        val a2 = alpha * alpha
        sources.inFront(px, py, pz, nx, ny, nz, vx, vy, vz) { light, strength, cosineL, cosineH, sineSquare, cosineVH ->
            val lobe = Microfacets.lobe(cosineH, sineSquare, cosineL, cosineV, a2)
            addReflected(surface, light, strength, cosineL, cosineVH, lobe, out)
        }
    }

    /**
     * Adds what the surface reflects of number [light] of the lights, see [LightSources.inFront].
     *
     * @param lobe the product D * V. A light of colour 1 makes a matt white surface white, so pi is in D, and not in
     *   the diffuse part
     */
    fun addReflected(
        surface: FloatArray,
        light: Int,
        strength: Float,
        cosineL: Float,
        cosineVH: Float,
        lobe: Float,
        out: FloatArray,
    ) {
        val grazing = Microfacets.grazing(abs(cosineVH))
        val f90 = surface[PhysicalSurface.GRAZING]
        for (channel in 0 until 3) {
            val f0 = surface[PhysicalSurface.REFLECTANCE + channel]
            val reflected = reflected(f0, surface[PhysicalSurface.DIFFUSE + channel], grazing, lobe, f90)
            out[channel] += sources.color(light, channel) * strength * cosineL * reflected
        }
    }

    /**
     * Adds the reflected ambient light and that of the environment.
     *
     * @param open the part of the light that reaches the point
     * @param rx the x of the reflected direction
     * @param along the cosine between the normal and the direction to the viewer
     */
    fun indirect(
        surface: FloatArray,
        occlusion: Float,
        open: Float,
        nx: Float,
        ny: Float,
        nz: Float,
        rx: Float,
        ry: Float,
        rz: Float,
        along: Float,
        out: FloatArray,
    ) {
        val ambient = sources.ambient
        val roughness = surface[PhysicalSurface.ROUGHNESS]
        surface.fill(0f, PhysicalSurface.RADIANCE, PhysicalSurface.GRAZING)
        if (environment != null) {
            environment.radiance(rx, ry, rz, roughness, surface)
            environment.irradiance(nx, ny, nz, surface)
        }
        val f90 = surface[PhysicalSurface.GRAZING]
        DirectionalAlbedo.at(minOf(abs(along), 1f), roughness) { scale, bias ->
            for (channel in 0 until 3) {
                val radiance = surface[PhysicalSurface.RADIANCE + channel] + ambient[channel]
                val irradiance = surface[PhysicalSurface.IRRADIANCE + channel] + ambient[channel]
                val f0 = surface[PhysicalSurface.REFLECTANCE + channel]
                val diffuse = surface[PhysicalSurface.DIFFUSE + channel]
                out[channel] += gathered(f0, diffuse, scale, bias, radiance, irradiance, open, f90) * occlusion
            }
        }
    }

    companion object {
        /**
         * Returns what a surface reflects of light of brightness 1 from one direction, in one channel.
         *
         * @param f0 reflectance at normal incidence
         * @param lobe the product D * V
         * @param f90 reflectance at grazing incidence
         */
        fun reflected(f0: Float, diffuse: Float, grazing: Float, lobe: Float, f90: Float = 1f): Float {
            val fresnel = f0 + (f90 - f0) * grazing
            return (1f - fresnel) * diffuse + fresnel * lobe
        }

        /**
         * Returns what a surface reflects of the light from all sides, in one channel.
         *
         * @param f0 reflectance at normal incidence
         * @param scale see [DirectionalAlbedo]; also [bias]
         * @param radiance the light around the reflected ray
         * @param irradiance the light that a matt surface receives
         * @param f90 reflectance at grazing incidence
         */
        fun gathered(
            f0: Float,
            diffuse: Float,
            scale: Float,
            bias: Float,
            radiance: Float,
            irradiance: Float,
            f90: Float = 1f,
        ): Float {
            val once = f0 * scale + f90 * bias
            return once * radiance + rest(f0, diffuse, scale, bias, once, f90) * irradiance
        }

        /** The same in a hollow, of which the part [open] is open to the light, 0..1. */
        fun gathered(
            f0: Float,
            diffuse: Float,
            scale: Float,
            bias: Float,
            radiance: Float,
            irradiance: Float,
            open: Float,
            f90: Float,
        ): Float {
            if (open == 1f) return gathered(f0, diffuse, scale, bias, radiance, irradiance, f90)
            val once = f0 * scale + f90 * bias
            return once * open * radiance +
                rest(f0, diffuse, scale, bias, once, f90) * reflectedIn(open, diffuse) * irradiance
        }

        /** Returns what is reflected more than once between microfacets, and what a matt surface below reflects. */
        private fun rest(f0: Float, diffuse: Float, scale: Float, bias: Float, once: Float, f90: Float): Float {
            val single = scale + bias
            val lost = 1f - single

            // Base colours above 1 reflect more than all light, but between microfacets no more than that
            val mean = minOf(f0 + (f90 - f0) / 21f, 1f)
            val more = lost * once * mean / (1f - mean * lost)
            val matt = diffuse * maxOf(1f - once - more, 0f)
            return more + matt
        }

        /**
         * Returns the part of the light from all sides that reaches a point in a hollow whose walls reflect the part
         * [diffuse] of it: more than the part [open] that arrives directly. A fit to path tracing: J. Jimenez et al.,
         * "Practical Realtime Strategies for Accurate Indirect Occlusion", SIGGRAPH 2016.
         */
        private fun reflectedIn(open: Float, diffuse: Float): Float {
            val cubic = 2.0404f * diffuse - 0.3324f
            val square = 0.6417f - 4.7951f * diffuse
            val linear = 2.7552f * diffuse + 0.6903f
            return maxOf(open, ((open * cubic + square) * open + linear) * open)
        }
    }
}

/**
 * Passes each light that shines on the front of a surface to [use]: its number, the factor of its colour, N.L, N.H, the
 * square of the sine between N and H, without cancellation, and V.H. The surface is at the point ([px], [py], [pz]), N
 * is its normal, V points to the viewer, L to the light, and H halfway between them; all are unit vectors.
 */
internal inline fun LightSources.inFront(
    px: Float,
    py: Float,
    pz: Float,
    nx: Float,
    ny: Float,
    nz: Float,
    vx: Float,
    vy: Float,
    vz: Float,
    use: (
        light: Int, strength: Float, cosineL: Float, cosineH: Float, sineSquare: Float, cosineVH: Float,
    ) -> Unit,
) = halfway(px, py, pz, nx, ny, nz, vx, vy, vz) { light, strength, cosineL, _, _, _, hx, hy, hz ->
    val cosineH = nx * hx + ny * hy + nz * hz
    val cx = ny * hz - nz * hy
    val cy = nz * hx - nx * hz
    val cz = nx * hy - ny * hx
    use(light, strength, cosineL, cosineH, cx * cx + cy * cy + cz * cz, vx * hx + vy * hy + vz * hz)
}

/** As [inFront], but passes N.L and the vectors L and H. */
internal inline fun LightSources.halfway(
    px: Float,
    py: Float,
    pz: Float,
    nx: Float,
    ny: Float,
    nz: Float,
    vx: Float,
    vy: Float,
    vz: Float,
    use: (
        light: Int, strength: Float, cosineL: Float,
        lx: Float, ly: Float, lz: Float, hx: Float, hy: Float, hz: Float,
    ) -> Unit,
) {
    for (light in 0 until count) {
        from(light, px, py, pz) { lx, ly, lz, strength ->
            val cosineL = nx * lx + ny * ly + nz * lz
            if (!(cosineL > 0f)) return@from
            var hx = lx + vx
            var hy = ly + vy
            var hz = lz + vz
            val length = sqrt(hx * hx + hy * hy + hz * hz)
            hx /= length
            hy /= length
            hz /= length
            use(light, strength, cosineL, lx, ly, lz, hx, hy, hz)
        }
    }
}
