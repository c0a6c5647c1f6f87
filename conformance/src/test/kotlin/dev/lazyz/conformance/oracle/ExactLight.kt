package dev.lazyz.conformance.oracle

import dev.lazyz.Rgba
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Light as contract rules 6.5, 6.8, 6.10 and 6.13 define it, in double precision: an oracle for the library's own
 * light. It does not know ambient light and the studio on metallic-roughness materials.
 *
 * @param classical the lights of other materials
 * @param physical the lights of metallic-roughness materials
 * @param intensity factor of all lights
 * @param visibility which part of ambient light reaches a point, or null
 * @param surroundings what metallic-roughness materials reflect, or null
 */
internal class ExactLight(
    private val camera: Camera,
    private val classical: List<Light>,
    private val physical: List<Light>,
    private val intensity: Double,
    private val visibility: AmbientVisibility?,
    private val surroundings: ExactEnvironment?,
) {
    private val isPerspective = camera.projection is Projection.Perspective

    /** Factor of a surface's own colour, and what is added to it; red, green, blue. */
    class Sum(val factor: DoubleArray, val summand: DoubleArray)

    /** A point of a surface; its normal may have any length. */
    class Place(val point: Vector3dc, val normal: Vector3dc)

    /** Directions at right angles on a surface, along which highlights are longer by the [strength], and across. */
    class Stretch(val along: Vector3d, val across: Vector3d, val strength: Double)

    /** A light as seen from a point: the unit vector to it, and the factor of its colour. */
    private class Beam(val color: DoubleArray, val direction: Vector3d)

    /** Returns the vector from [point] to the viewer, of any length. */
    fun toViewer(point: Vector3dc): Vector3d =
        if (isPerspective) Vector3d(camera.eye).sub(point) else camera.toWorldDirection(0.0, 0.0, 1.0)

    /**
     * Returns the light at a place, or null where rounding decides: a normal of almost no length, a light at the point.
     *
     * @param emission what the summand begins with
     * @param occlusion factor of ambient light
     * @param isPhong whether the highlight is Phong's instead of Blinn's
     * @param graze the cosine above which a light shines: about 0
     */
    fun at(
        material: Material,
        emission: DoubleArray,
        occlusion: Double,
        place: Place,
        isPhong: Boolean,
        graze: Double,
    ): Sum? {
        val v = toViewer(place.point).normalize()
        val n = unitNormal(place.normal, v) ?: return null
        val factor = DoubleArray(3)
        val summand = emission.copyOf()
        val open = occlusion * visible(place.point, n)
        for (light in classical) {
            if (light is Light.Ambient) {
                for (k in 0 until 3) factor[k] += parts(light.color)[k] * intensity * open
                continue
            }
            val beam = beam(light, place.point) ?: return null
            val l = beam.direction
            val cosine = n.dot(l)
            if (!(cosine > graze)) continue
            for (k in 0 until 3) factor[k] += beam.color[k] * cosine
            val specular = parts(material.specular)
            if (specular.all { it == 0.0 }) continue
            val h = Vector3d(l).add(v)
            if (h.length() < LEAST) return null
            val highlight = if (isPhong) 2 * cosine * n.dot(v) - l.dot(v) else n.dot(h) / h.length()
            if (!(highlight > 0.0)) continue
            val strength = Math.pow(highlight, material.shininess.toDouble())
            for (k in 0 until 3) summand[k] += beam.color[k] * specular[k] * strength
        }
        return Sum(factor, summand)
    }

    /**
     * Returns the light that a metallic-roughness surface of the base colour [color] reflects: rules 6.8 and 6.10. Null
     * where rounding decides.
     *
     * @param occlusion factor of the surroundings
     * @param graze as in [at]
     */
    fun reflected(
        color: DoubleArray,
        metallic: Double,
        roughness: Double,
        specular: Lobes.Specular?,
        stretch: Stretch?,
        place: Place,
        occlusion: Double,
        graze: Double,
    ): DoubleArray? {
        val strength = specular?.strength?.toDouble() ?: 1.0
        val tint = specular?.let { parts(it.color) } ?: doubleArrayOf(1.0, 1.0, 1.0)
        val atNormal = specular?.refraction?.toDouble()?.let { Math.pow((it - 1) / (it + 1), 2.0) } ?: 0.04
        val f90 = strength * (1 - metallic) + metallic
        val f0 = DoubleArray(3) {
            minOf(atNormal * tint[it], 1.0) * strength * (1 - metallic) + color[it] * metallic
        }
        val diffuse = DoubleArray(3) { color[it] * (1 - metallic) }
        val sum = fromLights(DoubleArray(3), place, roughness, graze, stretch) { k, grazing, lobe ->
            val f = f0[k] + (f90 - f0[k]) * grazing
            (1 - f) * diffuse[k] + f * lobe
        }
        if (sum == null || surroundings == null) return sum
        val v = toViewer(place.point).normalize()
        val n = unitNormal(place.normal, v) ?: return null
        val r = mirrored(v, if (stretch == null) n else bent(n, v, roughness, stretch))
        val open = visible(place.point, n)
        val around = surroundings.reflected(f0, diffuse, f90, roughness, n, r, Math.abs(n.dot(v)), open)
        return DoubleArray(3) { sum[it] + occlusion * around[it] }
    }

    private fun mirrored(v: Vector3d, n: Vector3d) = Vector3d(n).mul(2 * n.dot(v)).sub(v)

    /** The normal of rule 6.16 that mirrors the light of the surroundings. */
    private fun bent(n: Vector3d, v: Vector3d, roughness: Double, stretch: Stretch): Vector3d {
        val along = Vector3d(v).sub(Vector3d(stretch.across).mul(stretch.across.dot(v)))
        val k = Math.pow(1 - stretch.strength * (1 - roughness), 4.0)
        return along.mul(1 - k).add(Vector3d(n).mul(k)).normalize()
    }

    /**
     * Returns the light [below] a clear coat and that of the coat: rule 6.16. The parameters are as in [reflected].
     *
     * @param base the normal below the coat
     */
    fun coated(
        below: DoubleArray,
        coat: Lobes.Clearcoat,
        place: Place,
        base: Vector3dc,
        occlusion: Double,
        graze: Double,
    ): DoubleArray? {
        val v = toViewer(place.point).normalize()
        val n = unitNormal(place.normal, v) ?: return null
        val weight = coat.strength * (0.04 + 0.96 * Math.pow(1 - minOf(1.0, Math.abs(n.dot(v))), 5.0))
        val around = if (surroundings == null) {
            DoubleArray(3)
        } else {
            val open = occlusion * visible(place.point, unitNormal(base, v) ?: return null)
            surroundings.radiance(mirrored(v, n), coat.roughness.toDouble()).map { it * open }.toDoubleArray()
        }
        val rest = DoubleArray(3) { below[it] * (1 - weight) + weight * around[it] }
        return fromLights(rest, place, coat.roughness.toDouble(), graze, null) { _, _, lobe -> weight * lobe }
    }

    /**
     * Adds to [sum] the light of all lights that a surface reflects. [reflected] is how much of it in a channel, from
     * (1 - V.H)^5 and the product D V. Returns null where rounding decides.
     */
    private inline fun fromLights(
        sum: DoubleArray,
        place: Place,
        roughness: Double,
        graze: Double,
        stretch: Stretch?,
        reflected: (k: Int, grazing: Double, lobe: Double) -> Double,
    ): DoubleArray? {
        val v = toViewer(place.point).normalize()
        val n = unitNormal(place.normal, v) ?: return null
        for (light in physical) {
            if (light is Light.Ambient) error("the oracle does not know ambient light on metallic-roughness materials")
            val beam = beam(light, place.point) ?: return null
            val l = beam.direction
            val cosine = n.dot(l)
            if (!(cosine > graze)) continue
            val h = Vector3d(l).add(v)
            if (h.length() < LEAST) return null
            h.normalize()
            val lobe = if (stretch == null) lobe(n, l, v, h, roughness) else lobe(n, l, v, h, roughness, stretch)
            val grazing = Math.pow(1 - minOf(1.0, Math.abs(v.dot(h))), 5.0)
            for (k in 0 until 3) sum[k] += beam.color[k] * cosine * reflected(k, grazing, lobe)
        }
        return sum
    }

    /** The product D V of rule 6.8. */
    private fun lobe(n: Vector3d, l: Vector3d, v: Vector3d, h: Vector3d, roughness: Double): Double {
        if (!(n.dot(h) > 0.0)) return 0.0
        val alpha = maxOf(roughness * roughness, 1.0 / 512)
        val across = Vector3d(n).cross(h).lengthSquared()
        val width = n.dot(h) * n.dot(h) * alpha * alpha + across
        return alpha * alpha / (width * width) / (smith(n.dot(l), alpha) * smith(Math.abs(n.dot(v)), alpha))
    }

    /** The product D V of rule 6.16. */
    private fun lobe(n: Vector3d, l: Vector3d, v: Vector3d, h: Vector3d, roughness: Double, stretch: Stretch): Double {
        if (!(n.dot(h) > 0.0)) return 0.0
        val narrow = maxOf(roughness * roughness, 1.0 / 512)
        val wide = narrow + (1 - narrow) * stretch.strength * stretch.strength
        val (t, b) = stretch.along to stretch.across
        val slope = Math.pow(t.dot(h) / wide, 2.0) + Math.pow(b.dot(h) / narrow, 2.0) + Math.pow(n.dot(h), 2.0)
        val (fromLight, toViewer) = listOf(l, v).map {
            Math.abs(n.dot(it)) + Vector3d(wide * t.dot(it), narrow * b.dot(it), n.dot(it)).length()
        }
        return 1 / (wide * narrow * slope * slope) / (fromLight * toViewer)
    }

    private fun smith(cosine: Double, alpha: Double) =
        cosine + Math.sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine)

    /** The visibility at a point with the unit normal [n]. It is a function of numbers in single precision. */
    private fun visible(point: Vector3dc, n: Vector3d): Double {
        val (x, y, z) = listOf(point.x(), point.y(), point.z()).map { it.toFloat() }
        val open = visibility?.at(x, y, z, n.x.toFloat(), n.y.toFloat(), n.z.toFloat()) ?: 1f
        return open.toDouble()
    }

    private fun unitNormal(normal: Vector3dc, v: Vector3d): Vector3d? = when (val length = normal.length()) {
        0.0 -> v
        else -> if (length < LEAST) null else Vector3d(normal).div(length)
    }

    /** Null where rounding decides: at the light. */
    private fun beam(light: Light, point: Vector3dc): Beam? {
        val (position, falloff) = when (light) {
            is Light.Directional -> return beam(light, 1.0, Vector3d(light.direction).negate())
            is Light.Point -> light.position to light.falloff
            is Light.Spot -> light.position to light.falloff
            is Light.Ambient -> error("ambient light comes from no direction")
        }
        val to = Vector3d(position).sub(point)
        val distance = to.length()
        if (distance < LEAST) return null
        to.div(distance)
        var strength = decrease(falloff, distance)
        if (light is Light.Spot) strength *= edge(light, -to.dot(light.direction))
        return beam(light, strength, to)
    }

    private fun beam(light: Light, strength: Double, direction: Vector3d) =
        Beam(DoubleArray(3) { parts(light.color)[it] * strength * intensity }, direction)

    private fun decrease(falloff: Falloff, distance: Double): Double {
        if (falloff == Falloff.NONE) return 1.0
        return maxOf(0.0, 1 - Math.pow(distance / falloff.range, 4.0)) / (distance * distance)
    }

    /** The part of a spot's light that reaches a point in a direction whose cosine with its axis is [cosine]. */
    private fun edge(spot: Light.Spot, cosine: Double): Double {
        val outer = Math.cos(Math.toRadians(spot.outerAngle))
        val inner = Math.cos(Math.toRadians(spot.innerAngle))
        val part = ((cosine - outer) / maxOf(0.001, inner - outer)).coerceIn(0.0, 1.0)
        return part * part
    }

    companion object {
        private const val LEAST = 1e-4

        fun parts(color: Rgba): DoubleArray =
            doubleArrayOf(color.red.toDouble(), color.green.toDouble(), color.blue.toDouble())

        /** Whether light is computed by the metallic-roughness model. */
        fun isPhysical(material: Material): Boolean =
            material.metallicRoughness != null && material.shading != Shading.CONSTANT

        /** Whether emission is below a clear coat. */
        fun hasLobes(material: Material): Boolean =
            isPhysical(material) && material.metallicRoughness?.lobes != null

        /** Whether light is evaluated at the vertices. */
        fun isAtVertices(material: Material): Boolean =
            !isPhysical(material) && (material.shading == Shading.FLAT || material.shading == Shading.GOURAUD)
    }
}
