package dev.lazyz.shading

import dev.lazyz.shading.pbr.PhysicalSurface
import dev.lazyz.spi.Fragment
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material

/**
 * Stores the [Lobes] of a material at a fragment in its [Fragment.surface], see [PhysicalSurface]. Immutable and thread
 * safe.
 */
internal class LobeReader private constructor(lobes: Lobes, isBlended: Boolean) {
    private val specular = lobes.specular
    private val specularStrengthMap = MapReader.of(specular?.strengthMap)
    private val specularColorMap = MapReader.of(specular?.colorMap)
    private val f0 = specular?.refraction?.let { ((it - 1f) / (it + 1f)) * ((it - 1f) / (it + 1f)) } ?: 0f
    private val sheen = lobes.sheen
    private val sheenColorMap = MapReader.of(sheen?.colorMap)
    private val sheenRoughnessMap = MapReader.of(sheen?.roughnessMap)
    private val coat = lobes.clearcoat
    private val coatStrengthMap = MapReader.of(coat?.strengthMap)
    private val coatRoughnessMap = MapReader.of(coat?.roughnessMap)
    private val coatNormalMap = NormalReader.of(coat?.normalMap)
    private val glass = if (isBlended) lobes.transmission else null
    private val glassStrengthMap = MapReader.of(glass?.strengthMap)
    private val thicknessMap = MapReader.of(glass?.thicknessMap)
    private val film = lobes.iridescence
    private val filmStrengthMap = MapReader.of(film?.strengthMap)
    private val filmThicknessMap = MapReader.of(film?.thicknessMap)
    private val thickGlass = FloatArray(3) { attenuated(it, 1f) }

    /** Stores the normal of the clear coat. The normal of the [fragment] is still that of its surface. */
    fun setCoatNormal(fragment: Fragment) {
        if (coat == null) return
        val x = fragment.normalX
        val y = fragment.normalY
        val z = fragment.normalZ
        coatNormalMap?.apply(fragment)
        val surface = fragment.surface
        surface[PhysicalSurface.COAT_NORMAL] = fragment.normalX
        surface[PhysicalSurface.COAT_NORMAL + 1] = fragment.normalY
        surface[PhysicalSurface.COAT_NORMAL + 2] = fragment.normalZ
        fragment.normalX = x
        fragment.normalY = y
        fragment.normalZ = z
    }

    /** Stores all but the normal, after [PhysicalSurface.set] for the base colour ([red], [green], [blue]). */
    fun set(fragment: Fragment, red: Float, green: Float, blue: Float, metallic: Float) {
        val surface = fragment.surface
        surface[PhysicalSurface.SHEEN_ROUGHNESS] = 0f
        surface[PhysicalSurface.COAT] = 0f
        surface[PhysicalSurface.FILM] = 0f
        for (at in 0 until 3) {
            surface[PhysicalSurface.SHEEN + at] = 0f
            surface[PhysicalSurface.TRANSMITTED + at] = 0f
        }
        if (specular != null) setSpecular(fragment, specular, red, green, blue, metallic)
        if (sheen != null) setSheen(fragment, sheen)
        if (coat != null) setCoat(fragment, coat)
        if (glass != null) setGlass(fragment, glass)
        if (film != null) setFilm(fragment, film)
    }

    private fun setFilm(fragment: Fragment, film: Lobes.Iridescence) {
        val surface = fragment.surface
        surface[PhysicalSurface.FILM] = film.strength * (filmStrengthMap?.read(fragment)?.get(0) ?: 1f)
        surface[PhysicalSurface.FILM + 1] = film.refraction
        val part = filmThicknessMap?.read(fragment)?.get(1) ?: 1f
        surface[PhysicalSurface.FILM + 2] = film.leastThickness * (1f - part) + film.thickness * part
    }

    private fun setSpecular(
        fragment: Fragment,
        specular: Lobes.Specular,
        red: Float,
        green: Float,
        blue: Float,
        metallic: Float,
    ) {
        val strength = specular.strength * (specularStrengthMap?.read(fragment)?.get(3) ?: 1f)
        val texel = specularColorMap?.read(fragment)
        val surface = fragment.surface
        for (channel in 0 until 3) {
            val tint = specular.color.channel(channel) * (texel?.get(channel) ?: 1f)
            val color = when (channel) {
                0 -> red
                1 -> green
                else -> blue
            }
            surface[PhysicalSurface.REFLECTANCE + channel] =
                minOf(f0 * tint, 1f) * strength * (1f - metallic) + color * metallic
        }
        surface[PhysicalSurface.GRAZING] = strength * (1f - metallic) + metallic
    }

    private fun setSheen(fragment: Fragment, sheen: Lobes.Sheen) {
        val surface = fragment.surface
        surface[PhysicalSurface.SHEEN_ROUGHNESS] =
            sheen.roughness * (sheenRoughnessMap?.read(fragment)?.get(3) ?: 1f)
        val texel = sheenColorMap?.read(fragment)
        for (channel in 0 until 3) {
            surface[PhysicalSurface.SHEEN + channel] =
                sheen.color.channel(channel) * (texel?.get(channel) ?: 1f)
        }
    }

    private fun setCoat(fragment: Fragment, coat: Lobes.Clearcoat) {
        val surface = fragment.surface
        surface[PhysicalSurface.COAT] = coat.strength * (coatStrengthMap?.read(fragment)?.get(0) ?: 1f)
        surface[PhysicalSurface.COAT_ROUGHNESS] =
            coat.roughness * (coatRoughnessMap?.read(fragment)?.get(1) ?: 1f)
    }

    private fun setGlass(fragment: Fragment, glass: Lobes.Transmission) {
        val surface = fragment.surface
        val part = glass.strength * (glassStrengthMap?.read(fragment)?.get(0) ?: 1f)
        val depth = thicknessMap?.read(fragment)?.get(1)
        for (channel in 0 until 3) {
            val left = if (depth == null) thickGlass[channel] else attenuated(channel, depth)

            // What a surface does not reflect as diffuse light passes
            val diffuse = surface[PhysicalSurface.DIFFUSE + channel]
            surface[PhysicalSurface.TRANSMITTED + channel] = diffuse * part * left
            surface[PhysicalSurface.DIFFUSE + channel] = diffuse * (1f - part)
        }
    }

    /** Returns the part of light that passes the part [depth] of the thickness. */
    private fun attenuated(channel: Int, depth: Float): Float {
        if (glass == null || glass.thickness == 0f) return 1f
        val way = glass.thickness.toDouble() * depth / glass.attenuationDistance
        return StrictMath.pow(glass.attenuationColor.channel(channel).toDouble(), way).toFloat()
    }

    companion object {
        /** Returns a reader of the lobes of [material], or null if it has none or is no physically based material. */
        fun of(material: Material): LobeReader? {
            if (!material.isPhysical) return null
            val lobes = material.metallicRoughness?.lobes ?: return null
            return LobeReader(lobes, material.alphaMode == Material.AlphaMode.BLEND)
        }
    }
}
