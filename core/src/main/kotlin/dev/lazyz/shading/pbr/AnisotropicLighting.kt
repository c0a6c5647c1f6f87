package dev.lazyz.shading.pbr

import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.Viewer
import dev.lazyz.world.light.AmbientVisibility
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The light that a metallic-roughness surface with anisotropy reflects (contract rule 6.16), in single precision, in
 * the order written. Immutable and thread safe.
 *
 * Sources: the specification of `KHR_materials_anisotropy`, Khronos Group, and for the environment its reference
 * renderer; the masking and shadowing is that of [Microfacets], so that a strength of 0 changes nothing.
 */
internal class AnisotropicLighting(
    private val viewer: Viewer,
    private val sources: LightSources,
    private val visibility: AmbientVisibility?,
    private val base: PhysicalLighting,
) {
    /** As [PhysicalLighting.illuminate], for a surface with the directions of [PhysicalSurface.ALONG]. */
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
        val cosine = nx * vx + ny * vy + nz * vz
        direct(surface, px, py, pz, nx, ny, nz, vx, vy, vz, abs(cosine), out)
        val open = if (visibility == null) 1f else visibility.at(px, py, pz, nx, ny, nz)
        bent(surface, nx, ny, nz, vx, vy, vz) { bx, by, bz ->
            val along = bx * vx + by * vy + bz * vz
            base.indirect(
                surface, occlusion, open, nx, ny, nz, 2f * along * bx - vx, 2f * along * by - vy,
                2f * along * bz - vz, cosine, out,
            )
        }
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
        // Highlights are as narrow as those of the material across the direction, and wider along it
        val across = Microfacets.alpha(surface[PhysicalSurface.ROUGHNESS])
        val anisotropy = surface[PhysicalSurface.ANISOTROPY]
        val along = across + (1f - across) * (anisotropy * anisotropy)
        val shadowV = shadow(surface, vx, vy, vz, cosineV, along, across)
        sources.halfway(px, py, pz, nx, ny, nz, vx, vy, vz) { light, strength, cosineL, lx, ly, lz, hx, hy, hz ->
            val cosineH = nx * hx + ny * hy + nz * hz
            val lobe = if (cosineH > 0f) {
                distribution(surface, hx, hy, hz, cosineH, along, across) /
                    (shadow(surface, lx, ly, lz, cosineL, along, across) * shadowV)
            } else {
                0f
            }
            base.addReflected(surface, light, strength, cosineL, vx * hx + vy * hy + vz * hz, lobe, out)
        }
    }

    /** Returns pi times D for the halfway vector. */
    private fun distribution(
        surface: FloatArray,
        hx: Float,
        hy: Float,
        hz: Float,
        cosineH: Float,
        along: Float,
        across: Float,
    ): Float {
        val a2 = along * across
        val t = across * dot(surface, PhysicalSurface.ALONG, hx, hy, hz)
        val b = along * dot(surface, PhysicalSurface.ACROSS, hx, hy, hz)
        val n = a2 * cosineH
        val width = a2 / (t * t + b * b + n * n)
        return a2 * (width * width)
    }

    /** Returns the factor of 1 / V for one direction, whose cosine with the normal is [cosine]. */
    private fun shadow(
        surface: FloatArray,
        x: Float,
        y: Float,
        z: Float,
        cosine: Float,
        along: Float,
        across: Float,
    ): Float {
        val t = along * dot(surface, PhysicalSurface.ALONG, x, y, z)
        val b = across * dot(surface, PhysicalSurface.ACROSS, x, y, z)
        return cosine + sqrt(t * t + b * b + cosine * cosine)
    }

    private fun dot(surface: FloatArray, at: Int, x: Float, y: Float, z: Float): Float =
        surface[at] * x + surface[at + 1] * y + surface[at + 2] * z

    /**
     * Passes the normal whose mirror shows the middle of the stretched reflection to [use]: between the normal and the
     * direction to the viewer without its part across.
     */
    private inline fun bent(
        surface: FloatArray,
        nx: Float,
        ny: Float,
        nz: Float,
        vx: Float,
        vy: Float,
        vz: Float,
        use: (x: Float, y: Float, z: Float) -> Unit,
    ) {
        val bend = 1f - surface[PhysicalSurface.ANISOTROPY] * (1f - surface[PhysicalSurface.ROUGHNESS])
        val kept = bend * bend * (bend * bend)
        val part = dot(surface, PhysicalSurface.ACROSS, vx, vy, vz)
        val x = (vx - part * surface[PhysicalSurface.ACROSS]) * (1f - kept) + nx * kept
        val y = (vy - part * surface[PhysicalSurface.ACROSS + 1]) * (1f - kept) + ny * kept
        val z = (vz - part * surface[PhysicalSurface.ACROSS + 2]) * (1f - kept) + nz * kept
        val length = sqrt(x * x + y * y + z * z)
        val isBent = length > 0f
        use(if (isBent) x / length else nx, if (isBent) y / length else ny, if (isBent) z / length else nz)
    }
}
