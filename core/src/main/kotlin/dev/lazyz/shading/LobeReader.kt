package dev.lazyz.shading

import dev.lazyz.shading.pbr.PhysicalSurface
import dev.lazyz.spi.Fragment
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import kotlin.math.sqrt

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
    private val anisotropy = lobes.anisotropy?.let { AnisotropyReader(it) }
    private val thickGlass = FloatArray(3) { attenuated(it, 1f) }

    /** Stores the directions of the surface, while the normal of the [fragment] is still that of the vertices. */
    fun setDirections(fragment: Fragment) {
        fragment.surface[PhysicalSurface.ANISOTROPY] = 0f
        anisotropy?.set(fragment)
        if (coat != null) setCoatNormal(fragment)
    }

    private fun setCoatNormal(fragment: Fragment) {
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

    /** Stores all but the directions, after [PhysicalSurface.set] for the base colour ([red], [green], [blue]). */
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

/** Stores the strength and the directions of anisotropy at a fragment (contract rule 6.16). Immutable. */
private class AnisotropyReader(private val anisotropy: Lobes.Anisotropy) {
    private val map = MapReader.of(anisotropy.map)
    private val sine = StrictMath.sin(anisotropy.rotation * (StrictMath.PI / 180.0)).toFloat()
    private val cosine = StrictMath.cos(anisotropy.rotation * (StrictMath.PI / 180.0)).toFloat()

    /** Stores them, or nothing if the [fragment] has no tangent or its texel no direction. */
    fun set(fragment: Fragment) {
        var right = 1f
        var up = 0f
        var strength = anisotropy.strength
        if (map != null) {
            val texel = map.read(fragment)
            right = 2f * texel[0] - 1f
            up = 2f * texel[1] - 1f
            strength *= texel[2]
        }
        val x0 = cosine * right - sine * up
        val y0 = sine * right + cosine * up
        val length = sqrt(x0 * x0 + y0 * y0)
        if (!(length > 0f)) return
        val along = x0 / length
        val across = y0 / length * (if (fragment.tangentW < 0f) -1f else 1f)
        TangentFrame.of(
            fragment.normalX, fragment.normalY, fragment.normalZ,
            fragment.tangentX, fragment.tangentY, fragment.tangentZ,
        ) { nx, ny, nz, tx, ty, tz ->
            val x = along * tx + across * (ny * tz - nz * ty)
            val y = along * ty + across * (nz * tx - nx * tz)
            val z = along * tz + across * (nx * ty - ny * tx)
            val surface = fragment.surface
            surface[PhysicalSurface.ANISOTROPY] = strength
            surface[PhysicalSurface.ALONG] = x
            surface[PhysicalSurface.ALONG + 1] = y
            surface[PhysicalSurface.ALONG + 2] = z
            surface[PhysicalSurface.ACROSS] = ny * z - nz * y
            surface[PhysicalSurface.ACROSS + 1] = nz * x - nx * z
            surface[PhysicalSurface.ACROSS + 2] = nx * y - ny * x
        }
    }
}
