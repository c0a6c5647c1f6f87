package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.MetallicRoughness

/**
 * How a material reflects light (Materials and Properties Extension, version 1.2.1, chapter 7). Immutable.
 *
 * A specular colour is the reflectance at normal incidence, so it becomes the one of [Lobes.Specular]; nothing is
 * converted to metalness.
 *
 * @property metallic metalness, or the factor of its texture
 * @property roughness roughness, which is 1 minus the glossiness, or the factor of its texture
 * @property specular the specular colour, or the factor of its texture; null for a material described by metalness
 * @property glossiness the factor of the texture of glossiness
 * @property factor the factor of the texture of the base colour
 * @property textures the numbers of the textures of metalness or specular colour, and of roughness or glossiness; or
 *   null
 */
internal data class ThreeMfFinish(
    val metallic: Float = 0f,
    val roughness: Float = 1f,
    val specular: Rgba? = null,
    val glossiness: Float = 1f,
    val factor: Rgba = Rgba.WHITE,
    val textures: Pair<Int, Int>? = null,
) {
    /** Returns the model of the material, with the textures of [looks] laid as [base], the texture of its colour. */
    fun model(looks: ThreeMfLooks, base: ThreeMfTexture?, images: ThreeMfTextures): MetallicRoughness {
        val (first, second) = textures?.takeIf { base != null }?.toList()?.map { looks.textures[it] }
            ?: listOf<ThreeMfTexture?>(null, null)
        if (specular == null) {
            val map = base?.let { images.metallicRoughness(it, first, second) }
            return MetallicRoughness(metallic, roughness, map)
        }
        val colors = base?.let { images.specularColors(it, first) }
        val map = base?.let { images.roughness(it, first, second, glossiness) }
        val isPlastic = colors == null && specular == PLASTIC
        val lobe = Lobes.Specular(color = specular.scaled(1f / REFLECTANCE), colorMap = colors)
        return MetallicRoughness(0f, roughness, map, if (isPlastic) null else Lobes(lobe))
    }

    companion object {
        /** The reflectance that a factor of 1 stands for. */
        private const val REFLECTANCE = 0.04f

        /** The default specular colour, that of plastics. */
        val PLASTIC: Rgba = Rgba.ofArgb(0xFF383838.toInt())
    }
}

/** Reads display properties. Not thread safe. */
internal class ThreeMfFinishReader(private val part: PackagePart, private val looks: ThreeMfLooks) {
    /** Reads the current element if it has the properties of materials; returns false otherwise. */
    fun read(name: String): Boolean {
        val id = if (name.endsWith("displayproperties")) part.number("id") else null
        val finishes = when (name) {
            "pbmetallicdisplayproperties" -> elements("pbmetallic") {
                ThreeMfFinish(fraction("metallicness", 0f), fraction("roughness", 1f))
            }
            "pbspeculardisplayproperties" -> elements("pbspecular") {
                ThreeMfFinish(
                    roughness = 1f - fraction("glossiness", 0f),
                    specular = color("specularcolor", ThreeMfFinish.PLASTIC),
                )
            }
            "pbmetallictexturedisplayproperties" -> listOf(
                ThreeMfFinish(
                    fraction("metallicfactor", 1f), fraction("roughnessfactor", 1f),
                    factor = color("basecolorfactor", Rgba.WHITE),
                    textures = textures("metallictextureid", "roughnesstextureid"),
                ),
            )
            "pbspeculartexturedisplayproperties" -> listOf(
                ThreeMfFinish(
                    specular = color("specularfactor", Rgba.WHITE), glossiness = fraction("glossinessfactor", 1f),
                    factor = color("diffusefactor", Rgba.WHITE),
                    textures = textures("speculartextureid", "glossinesstextureid"),
                ),
            )
            else -> return false
        }
        looks.finishes[id ?: part.fail("the display properties have no id")] = finishes
        return true
    }

    private inline fun elements(element: String, finish: () -> ThreeMfFinish): List<ThreeMfFinish> {
        val all = ArrayList<ThreeMfFinish>()
        part.forEachChild {
            if (it == element) {
                part.source.loading.items(part.source, 1)
                all.add(finish())
            }
        }
        return all
    }

    private fun textures(first: String, second: String) = Pair(part.number(first) ?: -1, part.number(second) ?: -1)

    private fun fraction(name: String, missing: Float): Float {
        val number = part.float(part.attribute(name) ?: return missing)
        return if (number.isFinite()) number.coerceIn(0f, 1f) else missing
    }

    /** Returns the colour without its alpha. */
    private fun color(name: String, missing: Rgba): Rgba {
        val code = ThreeMfColor.code(part.attribute(name)) ?: return missing
        return Rgba.ofArgb((code shr 8).toInt() or (0xFF shl 24))
    }
}
