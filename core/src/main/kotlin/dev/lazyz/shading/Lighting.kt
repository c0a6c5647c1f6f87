package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.shading.light.LightSources
import dev.lazyz.shading.light.Viewer
import dev.lazyz.shading.pbr.EnvironmentView
import dev.lazyz.shading.pbr.LobeLighting
import dev.lazyz.shading.pbr.PhysicalLighting
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import kotlin.math.sqrt

/**
 * The light of a scene, and the formula of classical materials (contract rule 6.5): ambient light, Lambert's law, and a
 * highlight.
 *
 * All arithmetic is in single precision, in the order written. Sources: Bui Tuong Phong, "Illumination for Computer
 * Generated Pictures", Communications of the ACM 18 (1975); James Blinn, "Models of Light Reflection for Computer
 * Synthesized Pictures", SIGGRAPH 1977.
 */
internal class Lighting(light: SceneLight, camera: Camera) {
    private val viewer = Viewer(camera)
    private val sources = LightSources(light.classical)
    private val visibility = light.visibility

    /** The same for many fragments at a time. */
    val ofBatches: BatchLighting = BatchLighting(viewer, sources, visibility)

    private val physicalSources = LightSources(light.physical)
    private val environment = EnvironmentView.of(light.environment, camera)

    /** The light of physically based materials. */
    val physical: PhysicalLighting = PhysicalLighting(viewer, physicalSources, environment, visibility)

    /** The light of those with lobes. */
    val lobes: LobeLighting = LobeLighting(viewer, physicalSources, environment, visibility, physical)

    /** What becomes of colours at the end; null if they stay as they are. */
    val toneMapper: ToneMapper? = ToneMapper.of(light.toneMapping)

    /**
     * Computes the light at a point. [out] receives in 0..2 the light that the surface's colour is multiplied by, and
     * in 3..5 the light that is added to the product, which begins with [emission]. The normal can have any length; a
     * normal of length 0 is replaced by the direction to the viewer. Ambient light is multiplied by [occlusion].
     */
    fun illuminate(
        material: Material,
        emission: Rgba,
        occlusion: Float,
        px: Float,
        py: Float,
        pz: Float,
        normalX: Float,
        normalY: Float,
        normalZ: Float,
        out: FloatArray,
    ) = viewer.from(px, py, pz, normalX, normalY, normalZ) { vx, vy, vz, nx, ny, nz ->
        // Add up the lights in their order
        val numbers = sources.numbers
        val open = if (visibility == null) occlusion else occlusion * visibility.at(px, py, pz, nx, ny, nz)
        for (channel in 0 until 3) out[channel] = sources.ambient[channel] * open
        out[3] = emission.red
        out[4] = emission.green
        out[5] = emission.blue
        val specular = material.specular
        val isShiny = specular.red > 0f || specular.green > 0f || specular.blue > 0f
        for (light in 0 until sources.count) {
            sources.from(light, px, py, pz) { lx, ly, lz, strength ->
                val cosine = nx * lx + ny * ly + nz * lz
                if (!(cosine > 0f)) return@from
                val at = LightSources.STRIDE * light + LightSources.COLOR
                val red = numbers[at] * strength
                val green = numbers[at + 1] * strength
                val blue = numbers[at + 2] * strength
                out[0] += red * cosine
                out[1] += green * cosine
                out[2] += blue * cosine
                if (!isShiny) return@from

                // Cosine for the highlight. Phong: between the reflected ray and the viewer; otherwise between the
                // normal and the halfway vector
                val highlight = if (material.shading == Shading.PHONG) {
                    2f * cosine * (nx * vx + ny * vy + nz * vz) - (lx * vx + ly * vy + lz * vz)
                } else {
                    val hx = lx + vx
                    val hy = ly + vy
                    val hz = lz + vz
                    (nx * hx + ny * hy + nz * hz) / sqrt(hx * hx + hy * hy + hz * hz)
                }
                if (!(highlight > 0f)) return@from
                val power = power(highlight, material.shininess)
                out[3] += red * specular.red * power
                out[4] += green * specular.green * power
                out[5] += blue * specular.blue * power
            }
        }
    }

    private companion object {
        /** Raises [base] to a positive integer by squaring, from the exponent's lowest bit up (rule 6.3). */
        fun power(base: Float, exponent: Int): Float {
            var result = 1f
            var square = base
            var rest = exponent
            while (true) {
                if (rest and 1 != 0) result *= square
                rest = rest ushr 1
                if (rest == 0) return result
                square *= square
            }
        }
    }
}
