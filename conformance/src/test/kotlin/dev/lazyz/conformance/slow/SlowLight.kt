package dev.lazyz.conformance.slow

import dev.lazyz.Rgba
import dev.lazyz.conformance.slow.SlowRenderer.Companion.parts
import dev.lazyz.world.Scene
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import org.joml.Vector3dc

/** A vector in double precision. */
internal data class Vec(val x: Double, val y: Double, val z: Double) {
    operator fun plus(o: Vec) = Vec(x + o.x, y + o.y, z + o.z)

    operator fun minus(o: Vec) = Vec(x - o.x, y - o.y, z - o.z)

    operator fun times(k: Double) = Vec(x * k, y * k, z * k)

    infix fun dot(o: Vec) = x * o.x + y * o.y + z * o.z

    fun cross(o: Vec) = Vec(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x)

    fun length() = Math.sqrt(this dot this)

    fun unit() = this * (1 / length())
}

internal fun Vector3dc.slow() = Vec(x(), y(), z())

/**
 * The light that a surface reflects, by appendix B of the specification of glTF 2.0, and by the texts of
 * `KHR_lights_punctual`, `KHR_materials_specular`, `KHR_materials_ior` and `KHR_materials_clearcoat`; see also
 * [SlowLobes]. The appendix permits to mix the parameters of a metal and a dielectric instead of their light.
 * Light from all sides is a sum over a grid of directions.
 *
 * A light of colour 1 stands for pi lux, so that it makes a white matt surface white.
 *
 * @param right the direction to the right of the picture, which is level
 * @param backward the direction to the viewer
 */
internal class SlowLight(private val scene: Scene, private val right: Vec, private val backward: Vec) {
    /** A point of a surface: [smooth] is the normal without a normal map, [along] the direction of anisotropy. */
    class Surface(
        val base: DoubleArray,
        val metallic: Double,
        val roughness: Double,
        val normal: Vec,
        val smooth: Vec,
        val along: Vec?,
        val lobes: Lobes?,
    )

    /** A point of a surface and its normal. */
    class Place(val point: Vec, val normal: Vec)

    private val environment = scene.environment
        ?: if (scene.lights.isEmpty()) Environment.USUAL else Environment.FAINT
    private val albedos = HashMap<Pair<Double, Double>, Double>()

    fun of(surface: Surface, point: Vec, v: Vec, emission: DoubleArray): DoubleArray {
        val below = DoubleArray(3)
        val above = DoubleArray(3)
        fun add(l: Vec, color: DoubleArray, factor: Double) {
            val (own, coat) = reflected(surface, l, v)
            for (k in 0 until 3) below[k] += own[k] * color[k] * factor
            for (k in 0 until 3) above[k] += coat * color[k] * factor
        }
        for (light in scene.lights) {
            val (l, strength) = beam(light, point) ?: continue
            add(l, parts(light.color), Math.PI * strength)
        }
        if (environment != Environment.NONE) {
            val several = Several(surface, v)
            for ((l, color) in studio) {
                if ((l dot surface.normal) <= 0 && (l dot surface.smooth) <= 0) continue
                val part = environment.intensity * 4 * Math.PI / studio.size
                add(l, color, part)
                for (k in 0 until 3) below[k] += several.reflected(l, k) * color[k] * part
            }
        }
        val coat = coat(surface, v)
        return mapped(DoubleArray(3) { (below[it] + emission[it]) * (1 - coat) + above[it] })
    }

    /**
     * The light of a material without a model of metals, as in textbooks: Lambert's cosine, and Phong's highlight or
     * Blinn's. The [occlusion] is a factor of ambient light.
     */
    fun classical(material: Material, base: DoubleArray, at: Place, v: Vec, occlusion: Double, emission: DoubleArray) =
        mapped(
            DoubleArray(3) { k ->
                emission[k] + scene.lights.sumOf { light ->
                    val color = parts(light.color)[k]
                    val (l, strength) = beam(light, at.point) ?: return@sumOf base[k] * color * occlusion
                    val cosine = at.normal dot l
                    if (cosine <= 0) return@sumOf 0.0
                    val isPhong = material.shading == Shading.PHONG
                    val near = if (isPhong) (at.normal * (2 * cosine) - l) dot v else at.normal dot (l + v).unit()
                    val highlight = Math.pow(Math.max(near, 0.0), material.shininess.toDouble())
                    color * strength * (base[k] * cosine + parts(material.specular)[k] * highlight)
                }
            },
        )

    /** The direction to a light, and its strength at a point; null for ambient light. */
    private fun beam(light: Light, point: Vec): Pair<Vec, Double>? {
        val (to, falloff) = when (light) {
            is Light.Directional -> return light.direction.slow() * -1.0 to 1.0
            is Light.Point -> light.position.slow() - point to light.falloff
            is Light.Spot -> light.position.slow() - point to light.falloff
            is Light.Ambient -> return null
        }
        val distance = to.length()
        var strength = 1.0
        if (falloff.isInverseSquare) {
            strength = Math.max(Math.min(1 - Math.pow(distance / falloff.range, 4.0), 1.0), 0.0) / (distance * distance)
        }
        if (light is Light.Spot) {
            val outer = Math.cos(Math.toRadians(light.outerAngle))
            val scale = 1 / Math.max(0.001, Math.cos(Math.toRadians(light.innerAngle)) - outer)
            val cosine = light.direction.slow() dot to.unit() * -1.0
            val angular = (cosine * scale - outer * scale).coerceIn(0.0, 1.0)
            strength *= angular * angular
        }
        return to.unit() to strength
    }

    /** What is reflected of light from [l]: below the clear coat, and by it. Includes the cosine. */
    private fun reflected(surface: Surface, l: Vec, v: Vec): Pair<DoubleArray, Double> {
        val cosine = Math.max(surface.normal dot l, 0.0)
        val h = (l + v).unit()
        val metallic = surface.metallic
        val specular = surface.lobes?.specular ?: Lobes.Specular()
        val index = specular.refraction.toDouble()
        val normal = Math.pow((index - 1) / (index + 1), 2.0)
        val grazing = Math.pow(1 - Math.abs(v dot h), 5.0)
        val stretch = surface.lobes?.anisotropy
        val microfacets = if (stretch == null) {
            SlowLobes.ggx(surface.normal, l, v, h, surface.roughness)
        } else {
            val strength = stretch.strength.toDouble()
            SlowLobes.stretched(surface.normal, surface.along!!, l, v, h, surface.roughness, strength)
        }
        val tint = parts(specular.color)
        val film = surface.lobes?.iridescence
        val fresnel = DoubleArray(3) {
            val f0 = Math.min(normal * tint[it], 1.0) * specular.strength * (1 - metallic) + surface.base[it] * metallic
            val f90 = specular.strength * (1 - metallic) + metallic
            val bare = f0 + (f90 - f0) * grazing
            val part = film?.strength?.toDouble() ?: 0.0
            bare * (1 - part) + (film?.let { film -> SlowLobes.film(f0, it, film, Math.abs(v dot h)) * part } ?: 0.0)
        }

        // A coloured reflection takes its largest part from all colours
        val isColored = specular.color != Rgba.WHITE || film != null
        val matt = 1 - metallic - (1 - metallic) * passing(surface)
        val own = DoubleArray(3) {
            val kept = 1 - if (isColored) fresnel.max() else fresnel[it]
            kept * surface.base[it] * matt / Math.PI + fresnel[it] * microfacets
        }
        val sheen = surface.lobes?.sheen
        if (sheen != null) {
            val color = parts(sheen.color)
            val fibres = SlowLobes.fibres(surface.normal, l, v, h, sheen.roughness.toDouble())
            val kept = 1 - color.take(3).max() * sheenAlbedo(surface.normal dot v, sheen.roughness.toDouble())
            for (k in 0 until 3) own[k] = own[k] * kept + color[k] * fibres
        }
        for (k in 0 until 3) own[k] *= cosine
        val lacquer = surface.lobes?.clearcoat ?: return own to 0.0
        val coat =
            SlowLobes.ggx(surface.smooth, l, v, h, lacquer.roughness.toDouble()) * Math.max(surface.smooth dot l, 0.0)
        return own to coat * coat(surface, v)
    }

    /** Which part of the light that is not reflected passes a dielectric: `KHR_materials_transmission`. */
    private fun passing(surface: Surface) = surface.lobes?.transmission?.strength?.toDouble() ?: 0.0

    /**
     * Which part of the light from straight behind passes, in each channel: the part of `KHR_materials_transmission`
     * that is not blurred, times what is left by `KHR_materials_volume`.
     */
    fun passed(surface: Surface, v: Vec): DoubleArray {
        val glass = surface.lobes?.transmission ?: return DoubleArray(3)
        val left = parts(glass.attenuationColor)
        val way = glass.thickness.toDouble() / glass.attenuationDistance
        val reflected = 0.04 + 0.96 * Math.pow(1 - Math.abs(surface.normal dot v), 5.0)
        return DoubleArray(3) {
            passing(surface) * (1 - surface.metallic) * (1 - reflected) * surface.base[it] * Math.pow(left[it], way)
        }
    }

    /** Which part of the light a clear coat reflects, from the viewer's side. */
    private fun coat(surface: Surface, v: Vec): Double {
        val strength = surface.lobes?.clearcoat?.strength ?: return 0.0
        return strength * (0.04 + 0.96 * Math.pow(1 - Math.abs(surface.smooth dot v), 5.0))
    }

    /** What fibres reflect of a uniform light of 1. */
    private fun sheenAlbedo(cosine: Double, roughness: Double) = albedos.getOrPut(cosine to roughness) {
        albedo(cosine) { n, l, v -> SlowLobes.fibres(n, l, v, (l + v).unit(), roughness) }
    }

    /** The part of a uniform light that a surface reflects to a viewer at an angle with the given cosine. */
    private fun albedo(cosine: Double, reflected: (n: Vec, l: Vec, v: Vec) -> Double): Double {
        val n = Vec(0.0, 1.0, 0.0)
        val v = Vec(Math.sqrt(Math.max(1 - cosine * cosine, 0.0)), cosine, 0.0)
        return COARSE.sumOf { if (it.y > 0) it.y * reflected(n, it, v) else 0.0 } * 4 * Math.PI / COARSE.size
    }

    /**
     * Light from all sides that microfacets reflect more than once, which appendix B leaves out: C. Kulla and A. Conty,
     * "Revisiting Physically Based Shading at Imageworks", SIGGRAPH course 2017.
     */
    private inner class Several(private val surface: Surface, v: Vec) {
        private val lost = LOST.getOrPut(surface.roughness) {
            DoubleArray(17) { i ->
                1 -
                    albedo(Math.max(i / 16.0, 0.01)) { n, l, v ->
                        SlowLobes.ggx(n, l, v, (l + v).unit(), surface.roughness)
                    }
            }
        }
        private val mean = (0 until 16).sumOf { (lost[it] + lost[it + 1]) / 2 * (2 * it + 1) / 256 }
        private val ofViewer = at(surface.normal dot v)
        private val colors = DoubleArray(3) { k ->
            val f0 = 0.04 * (1 - surface.metallic) + surface.base[k] * surface.metallic
            val fresnel = f0 + (1 - f0) / 21
            fresnel * fresnel * (1 - mean) / (1 - fresnel * mean)
        }

        private fun at(cosine: Double): Double {
            val place = Math.min(Math.abs(cosine), 1.0) * 16
            val left = Math.min(place.toInt(), 15)
            return lost[left] + (lost[left + 1] - lost[left]) * (place - left)
        }

        fun reflected(l: Vec, channel: Int): Double {
            val cosine = Math.max(surface.normal dot l, 0.0)
            return colors[channel] * ofViewer * at(cosine) / (Math.PI * mean) * cosine
        }
    }

    /** The light of the studio in a grid of directions. */
    private val studio by lazy { grid(128).map { it to studio(it) } }

    /** The light of the studio in a direction: its walls and soft boxes; its front is on the viewer's side. */
    private fun studio(direction: Vec): DoubleArray {
        val front = Vec(backward.x, 0.0, backward.z).unit()
        val at = Vec(direction dot right, direction.y, direction dot front)
        val wall = 0.30 + 0.12 * at.y + 0.04 * (at.y * at.y - 1.0 / 3)
        val sum = DoubleArray(3) { wall }
        for (box in BOXES) {
            val toward = Vec(box[0], box[1], box[2]).unit()
            val across = Vec(toward.z, 0.0, -toward.x).unit()
            val distance = at dot toward
            if (distance <= 0.01) continue
            val covered = inside((at dot across) / distance, box[3]) *
                inside((at dot toward.cross(across)) / distance, box[4])
            for (k in 0 until 3) sum[k] += covered * box[5 + k]
        }
        return sum
    }

    /** A step from 1 to 0 at the distance [half] on both sides, with a soft edge. */
    private fun inside(at: Double, half: Double): Double {
        fun edge(x: Double) = x / Math.sqrt(1 + x * x)
        return (edge((at + half) / 0.2) - edge((at - half) / 0.2)) / 2
    }

    private fun mapped(light: DoubleArray): DoubleArray {
        val exposed = DoubleArray(3) { light[it] * Math.pow(2.0, scene.effectiveToneMapping.exposure) }
        return if (scene.effectiveToneMapping.curve == ToneMapping.Curve.NEUTRAL) neutral(exposed) else exposed
    }

    /** The Khronos PBR Neutral tone mapper. */
    private fun neutral(color: DoubleArray): DoubleArray {
        val least = color.min()
        val offset = if (least < 0.08) least - 6.25 * least * least else 0.04
        for (k in 0 until 3) color[k] -= offset
        val peak = color.max()
        if (peak < 0.8 - 0.04) return color
        val d = 1 - (0.8 - 0.04)
        val newPeak = 1 - d * d / (peak + d - (0.8 - 0.04))
        val gray = 1 - 1 / (0.15 * (peak - newPeak) + 1)
        return DoubleArray(3) { color[it] * newPeak / peak * (1 - gray) + newPeak * gray }
    }

    private companion object {
        /** Soft boxes: direction, half width and height at distance 1, light. */
        val BOXES = listOf(
            doubleArrayOf(-0.75, 0.70, 0.75, 0.55, 0.50, 3.1, 3.0, 2.9),
            doubleArrayOf(1.0, 0.20, 0.45, 0.28, 0.75, 1.35, 1.4, 1.45),
            doubleArrayOf(0.05, 1.0, -0.1, 0.70, 0.45, 1.35, 1.35, 1.35),
            doubleArrayOf(-0.9, 0.25, -0.8, 0.30, 0.70, 1.8, 1.85, 1.95),
            doubleArrayOf(0.8, 0.35, -0.9, 0.35, 0.60, 1.4, 1.4, 1.4),
            doubleArrayOf(-0.10, 0.12, 1.0, 0.42, 0.34, 0.62, 0.62, 0.62),
        )

        /** A grid of directions, each for an equal part of the sphere. */
        fun grid(rows: Int): List<Vec> = (0 until 2 * rows * rows).map {
            val y = 1 - 2 * (it / (2 * rows) + 0.5) / rows
            val level = Math.sqrt(1 - y * y)
            val angle = Math.PI * (it % (2 * rows) + 0.5) / rows
            Vec(level * Math.cos(angle), y, level * Math.sin(angle))
        }

        val COARSE = grid(64)

        /** By roughness: what is lost where the cosine is a 16th, two 16ths and so on. */
        val LOST = HashMap<Double, DoubleArray>()
    }
}
