package dev.lazyz.conformance.oracle

import dev.lazyz.world.material.Material
import dev.lazyz.world.material.TextureMap
import org.joml.Vector3d

/**
 * What the maps of a material contain at a sample: contract rule 6.9 in double precision. It does not know mip filters.
 *
 * @param isSame whether texture coordinate number 0 or 1 of a set is the same at all vertices, so that it is exact
 */
internal class ExactMaps(
    private val material: Material,
    private val sample: Corner,
    private val isSame: (set: Int, coordinate: Int) -> Boolean,
) {
    /** The texels of the maps at a sample; those of maps that there are not have all components 1. */
    class Texels(private val all: List<DoubleArray>) {
        /** Red, green, blue and alpha that the base colour is multiplied by. */
        val color: DoubleArray get() = all[0]

        /** The factor of roughness. */
        val roughness: Double get() = all[1][1]

        /** The factor of metalness. */
        val metallic: Double get() = all[1][2]

        val normal: DoubleArray get() = all[2]

        /** The red component of the occlusion map. */
        val occlusion: Double get() = all[3][0]
        val emission: DoubleArray get() = all[4]
    }

    /** The exact texels, and what rounding of the coordinates may give. */
    fun texels(): List<Texels> {
        val maps = listOf(
            material.textureMap, material.metallicRoughness?.map, material.normalMap?.map, material.occlusionMap?.map,
            material.emissionMap,
        )
        return maps.fold(listOf(emptyList<DoubleArray>())) { all, map ->
            val texels = map?.let(::texels) ?: listOf(DoubleArray(4) { 1.0 })
            all.flatMap { before -> texels.map { before + listOf(it) } }
        }.map { Texels(it) }
    }

    /** The texture at the sample first, then other texels around it, within the error of single precision. */
    private fun texels(map: TextureMap): List<DoubleArray> {
        val exact = ExactTexture(map.texture)
        val at = if (map.uvSet == 0) Corner.UV else Corner.UV2
        val own = List(2) { sample.n[at + it].toFloat() }
        val isExact = map.transform.isIdentity
        val turn = Math.toRadians(map.transform.rotation)
        val (us, vs) = List(2) { k ->
            val place = if (isExact) 0.0 + own[k] else transformed(map, own, turn, k)
            val scale = if (isExact) 1.0 else 2 * maxOf(1.0, map.transform.scaleU, map.transform.scaleV)
            val size = own.maxOf { Math.abs(it) } * scale
            val off = maxOf(Math.ulp(size.toFloat()).toDouble(), 1e-6 * scale)
            if (isExact && isSame(map.uvSet, k)) listOf(place) else listOf(place, place - off, place + off)
        }
        val all = us.flatMap { u -> vs.map { v -> exact.at(u, v) } }
        return all.take(1) + all.drop(1).filter { other -> all[0].indices.any { differs(all[0][it], other[it]) } }
    }

    /** Scale, then rotation from v toward u, then offset. */
    private fun transformed(map: TextureMap, own: List<Float>, turn: Double, k: Int): Double = with(map.transform) {
        val u = own[0] * scaleU
        val v = own[1] * scaleV
        if (k == 0) {
            Math.cos(turn) * u + Math.sin(turn) * v + offsetU
        } else {
            Math.cos(turn) * v - Math.sin(turn) * u + offsetV
        }
    }

    private fun differs(a: Double, b: Double) = Math.abs(a - b) > 1e-3

    /** Tangent, bitangent and normal, of unit length and at right angles. */
    private class Axes(val t: Vector3d, val b: Vector3d, val n: Vector3d)

    /** Something that may be missing. */
    class Maybe<T>(val value: T?)

    /** The axes of the surface, without a value if it has none; null where rounding decides. */
    private fun axes(): Maybe<Axes>? {
        val normal = sample.normal
        val tangent = Vector3d(sample.n[Corner.TANGENT], sample.n[Corner.TANGENT + 1], sample.n[Corner.TANGENT + 2])
        if (normal.length() == 0.0 || tangent.length() == 0.0) return Maybe(null)
        if (normal.length() < LEAST || tangent.length() < LEAST) return null
        val n = Vector3d(normal).normalize()
        val t = Vector3d(tangent).sub(Vector3d(n).mul(n.dot(tangent)))
        val sign = sample.n[Corner.TANGENT + 3]
        if (t.length() < LEAST || Math.abs(sign) < LEAST) return null
        t.normalize()
        return Maybe(Axes(t, Vector3d(n).cross(t).mul(Math.signum(sign)), n))
    }

    /** Returns the normal that a normal map makes, of any length; null where rounding decides. */
    fun normal(texels: Texels): Vector3d? {
        val map = material.normalMap ?: return sample.normal
        val axes = (axes() ?: return null).value ?: return sample.normal
        val (x, y, z) = texels.normal.map { 2 * it - 1 }
        val scale = map.scale.toDouble()
        return axes.t.mul(x * scale).add(axes.b.mul(y * scale)).add(axes.n.mul(z))
    }

    /** Returns the directions of anisotropy, without a value if there is none; null where rounding decides. */
    fun stretch(): Maybe<ExactLight.Stretch>? {
        val lobe = material.metallicRoughness?.lobes?.anisotropy ?: return Maybe(null)
        val axes = (axes() ?: return null).value ?: return Maybe(null)
        val turn = Math.toRadians(lobe.rotation.toDouble())
        val along = axes.t.mul(Math.cos(turn)).add(axes.b.mul(Math.sin(turn)))
        return Maybe(ExactLight.Stretch(along, Vector3d(axes.n).cross(along), lobe.strength.toDouble()))
    }

    private companion object {
        const val LEAST = 1e-4
    }
}
