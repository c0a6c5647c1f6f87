package dev.lazyz.shading

import dev.lazyz.Fragment
import dev.lazyz.world.material.NormalMap
import kotlin.math.sqrt

/** Changes the normal of a fragment by a normal map (contract rule 6.9). Immutable and thread safe. */
internal class NormalReader private constructor(private val map: MapReader, private val scale: Float) {
    fun apply(fragment: Fragment) {
        // Unit normal, and the unit tangent at a right angle to it
        var nx = fragment.normalX
        var ny = fragment.normalY
        var nz = fragment.normalZ
        val length = sqrt(nx * nx + ny * ny + nz * nz)
        nx /= length
        ny /= length
        nz /= length
        val along = nx * fragment.tangentX + ny * fragment.tangentY + nz * fragment.tangentZ
        var tx = fragment.tangentX - along * nx
        var ty = fragment.tangentY - along * ny
        var tz = fragment.tangentZ - along * nz
        val extent = sqrt(tx * tx + ty * ty + tz * tz)
        if (!(length > 0f && extent > 0f)) return
        tx /= extent
        ty /= extent
        tz /= extent

        // The normal of the map, in the space of tangent, bitangent and normal
        val texel = map.read(fragment)
        val right = (2f * texel[0] - 1f) * scale
        val up = (2f * texel[1] - 1f) * scale * (if (fragment.tangentW < 0f) -1f else 1f)
        val out = 2f * texel[2] - 1f
        fragment.normalX = right * tx + up * (ny * tz - nz * ty) + out * nx
        fragment.normalY = right * ty + up * (nz * tx - nx * tz) + out * ny
        fragment.normalZ = right * tz + up * (nx * ty - ny * tx) + out * nz
    }

    companion object {
        fun of(normalMap: NormalMap?): NormalReader? =
            normalMap?.let { NormalReader(MapReader.of(it.map)!!, it.scale) }
    }
}
