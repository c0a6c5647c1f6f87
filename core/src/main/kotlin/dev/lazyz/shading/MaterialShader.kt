package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.shading.light.LightVectors
import dev.lazyz.shading.pbr.BatchPhysicalLighting
import dev.lazyz.shading.pbr.PhysicalSurface
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading

/**
 * A shader for a material and lights.
 *
 * For flat and Gouraud shading of polygons, light is evaluated during set-up: [litColor] has stored the product of base
 * colour and light in the vertex colours, and this shader only applies the texture and the emission map.
 *
 * @param isPrelit whether the vertex colours come from [litColor]
 */
internal class MaterialShader(
    private val material: Material,
    private val lighting: Lighting,
    private val isPrelit: Boolean,
) : BatchShader {
    private val base = material.baseColor
    private val texture = MapReader.of(material.textureMap)
    private val emissionMap = MapReader.of(material.emissionMap)
    private val isLit = !isPrelit && material.shading != Shading.CONSTANT
    private val normalMap = if (isLit) NormalReader.of(material.normalMap) else null
    private val occlusionMap = if (isLit) MapReader.of(material.occlusionMap?.map) else null
    private val occlusionStrength = material.occlusionMap?.strength ?: 0f

    /** The model of a physically based material; null for a classical one. */
    private val model = if (material.isPhysical) material.metallicRoughness else null
    private val modelMap = MapReader.of(model?.map)
    private val lobes = if (isLit) LobeReader.of(material) else null
    private val toneMapper = lighting.toneMapper

    /** What the formula of light adds. With a map, emission is added later. */
    private val emission: Rgba get() = if (emissionMap == null) material.emission else Rgba.BLACK

    /** Whether a colour stays as it is after light. */
    private val isFinished = emissionMap == null && toneMapper == null && lobes == null

    /** Whether a colour is only a product and a sum. */
    private val isSimple = texture == null && isFinished && !isLit

    /** Whether the light of many fragments can be computed together. */
    private val hasMaps = texture != null || normalMap != null || occlusionMap != null || !model?.maps.isNullOrEmpty()

    /**
     * Whether colours change little within a pixel: there are no maps, and no highlights that may be narrower than a
     * pixel (contract rule 6.12).
     */
    val isSmooth: Boolean = !hasMaps && emissionMap == null && (!isLit || hasWideHighlights())

    private fun hasWideHighlights(): Boolean = when {
        model != null -> minOf(model.roughness, model.lobes?.clearcoat?.roughness ?: 1f) >= LEAST_ROUGHNESS
        else -> material.specular == Rgba.BLACK || material.shininess <= MOST_SHININESS
    }

    override fun shade(fragment: Fragment) {
        // Base colour x vertex colour x texture
        var red = fragment.vertexRed
        var green = fragment.vertexGreen
        var blue = fragment.vertexBlue
        var alpha = fragment.vertexAlpha
        if (!isPrelit) {
            red *= base.red
            green *= base.green
            blue *= base.blue
            alpha *= base.alpha
        }
        if (texture != null) {
            val texel = texture.read(fragment)
            red *= texel[0]
            green *= texel[1]
            blue *= texel[2]
            alpha *= texel[3]
        }

        // Light
        if (isLit) {
            lobes?.setDirections(fragment)
            normalMap?.apply(fragment)
            val occlusion = if (occlusionMap == null) 1f else occlusion(occlusionMap.read(fragment))
            val light = fragment.light
            if (model != null) {
                reflect(fragment, red, green, blue, occlusion)
                red = light[0]
                green = light[1]
                blue = light[2]
            } else {
                lighting.illuminate(
                    material, emission, occlusion, fragment.worldX, fragment.worldY, fragment.worldZ,
                    fragment.normalX, fragment.normalY, fragment.normalZ, light,
                )
                red = red * light[0] + light[3]
                green = green * light[1] + light[4]
                blue = blue * light[2] + light[5]
            }
        } else if (!isPrelit) {
            red += emission.red
            green += emission.green
            blue += emission.blue
        }
        val opacity = if (material.alphaMode == AlphaMode.BLEND) alpha else 1f
        if (isFinished) {
            fragment.setColor(red, green, blue, opacity)
        } else {
            finish(fragment, red, green, blue, opacity)
        }
    }

    /**
     * Adds the emission of the map, applies the tone mapping, and sets the colour of [fragment]. Glass has the whole
     * light although a part of it is what shines through, so its colour is divided by the rest.
     */
    private fun finish(fragment: Fragment, red: Float, green: Float, blue: Float, opacity: Float) {
        val color = fragment.light
        color[0] = red
        color[1] = green
        color[2] = blue
        if (lobes == null) addEmission(fragment, color)
        toneMapper?.apply(color)
        if (lobes == null) return fragment.setColor(color[0], color[1], color[2], opacity)
        val rest = 1f - fragment.surface[PhysicalSurface.PASSED]
        fragment.setColor(color[0] / rest, color[1] / rest, color[2] / rest, opacity * rest)
    }

    /** Adds the emission of the map, if there is one, to [color]. */
    private fun addEmission(fragment: Fragment, color: FloatArray) {
        val texel = emissionMap?.read(fragment) ?: return
        color[0] += material.emission.red * texel[0]
        color[1] += material.emission.green * texel[1]
        color[2] += material.emission.blue * texel[2]
    }

    /** Stores the light that the fragment reflects, and its emission, in 0..2 of its [Fragment.light]. */
    private fun reflect(fragment: Fragment, red: Float, green: Float, blue: Float, occlusion: Float) {
        var metallic = model!!.metallic
        var roughness = model.roughness
        if (modelMap != null) {
            val texel = modelMap.read(fragment)
            roughness *= texel[1]
            metallic *= texel[2]
        }
        PhysicalSurface.set(fragment.surface, red, green, blue, metallic, roughness)
        val light = fragment.light
        light[0] = emission.red
        light[1] = emission.green
        light[2] = emission.blue
        if (lobes != null) return reflectLobes(lobes, fragment, red, green, blue, metallic, occlusion)
        lighting.physical.illuminate(
            fragment.surface, occlusion, fragment.worldX, fragment.worldY, fragment.worldZ,
            fragment.normalX, fragment.normalY, fragment.normalZ, light,
        )
    }

    /** The same for a material with lobes. A clear coat also covers the emission, so that of the map is added here. */
    private fun reflectLobes(
        lobes: LobeReader,
        fragment: Fragment,
        red: Float,
        green: Float,
        blue: Float,
        metallic: Float,
        occlusion: Float,
    ) {
        val light = fragment.light
        addEmission(fragment, light)
        lobes.set(fragment, red, green, blue, metallic)
        lighting.lobes.illuminate(
            fragment.surface, occlusion, fragment.worldX, fragment.worldY, fragment.worldZ,
            fragment.normalX, fragment.normalY, fragment.normalZ, light,
        )
    }

    private fun occlusion(texel: FloatArray): Float = 1f + occlusionStrength * (texel[0] - 1f)

    override fun shade(batch: FragmentBatch) {
        val count = batch.size
        if (isSimple) {
            // Only a product and a sum: simple loops, which the JVM vectorises
            scale(batch.vertexRed, base.red, material.emission.red, batch.red, count)
            scale(batch.vertexGreen, base.green, material.emission.green, batch.green, count)
            scale(batch.vertexBlue, base.blue, material.emission.blue, batch.blue, count)
            if (material.alphaMode == AlphaMode.BLEND) scale(batch.vertexAlpha, base.alpha, 0f, batch.alpha, count)
            return
        }
        if (!isLit || lobes != null || count < BatchLighting.FEWEST || !shadeTogether(batch)) batch.shadeEach(this)
    }

    /** Shades the fragments of [batch] together. Returns false if that cannot give the same bits as one by one. */
    private fun shadeTogether(batch: FragmentBatch): Boolean {
        val count = batch.size
        val scratch = batch.scratch(if (model == null) BatchLighting.ARRAYS else ARRAYS)
        batch.normalX.copyInto(scratch[LightVectors.NORMAL], 0, 0, count)
        batch.normalY.copyInto(scratch[LightVectors.NORMAL + 1], 0, 0, count)
        batch.normalZ.copyInto(scratch[LightVectors.NORMAL + 2], 0, 0, count)
        scratch[LightVectors.OCCLUSION].fill(1f, 0, count)
        if (model != null) {
            scratch[BatchPhysicalLighting.ROUGHNESS].fill(model.roughness, 0, count)
            scratch[METALLIC].fill(model.metallic, 0, count)
        }
        scale(batch.vertexRed, base.red, batch.red, count)
        scale(batch.vertexGreen, base.green, batch.green, count)
        scale(batch.vertexBlue, base.blue, batch.blue, count)
        if (material.alphaMode == AlphaMode.BLEND) scale(batch.vertexAlpha, base.alpha, batch.alpha, count)
        if (hasMaps) readMaps(batch, scratch)
        if (model == null) {
            if (!lighting.ofBatches.illuminate(batch, material, emission)) return false
        } else {
            setSurfaces(batch, scratch)
            if (!lighting.physical.ofBatches.illuminate(batch)) return false
        }
        if (emissionMap != null) addEmission(batch, emissionMap)
        if (toneMapper != null) mapTones(batch, toneMapper)
        return true
    }

    /** Reads the maps at each fragment: multiplies colours by the texture, changes normals, and stores occlusion. */
    private fun readMaps(batch: FragmentBatch, scratch: Array<FloatArray>) {
        val texel = batch.texel
        if (texture != null) {
            val blends = material.alphaMode == AlphaMode.BLEND
            for (i in 0 until batch.size) {
                texture.read(batch, i, texel)
                batch.red[i] *= texel[0]
                batch.green[i] *= texel[1]
                batch.blue[i] *= texel[2]
                if (blends) batch.alpha[i] *= texel[3]
            }
        }
        if (normalMap != null) {
            val x = scratch[LightVectors.NORMAL]
            val y = scratch[LightVectors.NORMAL + 1]
            val z = scratch[LightVectors.NORMAL + 2]
            for (i in 0 until batch.size) normalMap.apply(batch, i, x, y, z, texel)
        }
        if (occlusionMap != null) {
            for (i in 0 until batch.size) {
                occlusionMap.read(batch, i, texel)
                scratch[LightVectors.OCCLUSION][i] = occlusion(texel)
            }
        }
        if (modelMap != null) {
            for (i in 0 until batch.size) {
                modelMap.read(batch, i, texel)
                scratch[BatchPhysicalLighting.ROUGHNESS][i] *= texel[1]
                scratch[METALLIC][i] *= texel[2]
            }
        }
    }

    /** Stores the materials of the fragments, and replaces their colours by the emission. */
    private fun setSurfaces(batch: FragmentBatch, scratch: Array<FloatArray>) {
        setSurfaces(batch.red, emission.red, scratch, 0, batch.size)
        setSurfaces(batch.green, emission.green, scratch, 1, batch.size)
        setSurfaces(batch.blue, emission.blue, scratch, 2, batch.size)
    }

    private fun setSurfaces(
        color: FloatArray,
        emission: Float,
        scratch: Array<FloatArray>,
        channel: Int,
        count: Int,
    ) {
        val metallic = scratch[METALLIC]
        val diffuse = scratch[BatchPhysicalLighting.DIFFUSE + channel]
        val reflectance = scratch[BatchPhysicalLighting.REFLECTANCE + channel]
        for (i in 0 until count) diffuse[i] = PhysicalSurface.diffuse(color[i], metallic[i])
        for (i in 0 until count) reflectance[i] = PhysicalSurface.reflectance(color[i], metallic[i])
        color.fill(emission, 0, count)
    }

    private fun addEmission(batch: FragmentBatch, map: MapReader) {
        val texel = batch.texel
        for (i in 0 until batch.size) {
            map.read(batch, i, texel)
            batch.red[i] += material.emission.red * texel[0]
            batch.green[i] += material.emission.green * texel[1]
            batch.blue[i] += material.emission.blue * texel[2]
        }
    }

    private fun mapTones(batch: FragmentBatch, toneMapper: ToneMapper) {
        val color = batch.texel
        for (i in 0 until batch.size) {
            color[0] = batch.red[i]
            color[1] = batch.green[i]
            color[2] = batch.blue[i]
            toneMapper.apply(color)
            batch.red[i] = color[0]
            batch.green[i] = color[1]
            batch.blue[i] = color[2]
        }
    }

    private fun scale(from: FloatArray, factor: Float, to: FloatArray, count: Int) {
        for (i in 0 until count) to[i] = from[i] * factor
    }

    private fun scale(from: FloatArray, factor: Float, emission: Float, to: FloatArray, count: Int) {
        if (isPrelit) {
            from.copyInto(to, 0, 0, count)
        } else {
            for (i in 0 until count) to[i] = from[i] * factor + emission
        }
    }

    /** Returns the opacity at the fragment, 0..1, before the alpha mode is applied. */
    fun alphaAt(fragment: Fragment): Float {
        var alpha = fragment.vertexAlpha
        if (!isPrelit) alpha *= base.alpha
        if (texture != null) alpha *= texture.read(fragment)[3]
        return alpha
    }

    /** Whether the opacity at the fragment reaches [cutoff] (contract rule 2.7). */
    fun reaches(fragment: Fragment, cutoff: Float): Boolean = alphaAt(fragment) >= cutoff * (1f - FILTER_ROUNDING)

    /**
     * Replaces the colour of [vertex] with the lit colour of the material at the position [world], without its texture.
     * [light] is scratch memory of 6 numbers.
     */
    fun litColor(vertices: Vertices, vertex: Int, world: DoubleArray, light: FloatArray) {
        val at = vertices.stride * vertex
        val data = vertices.data
        lighting.illuminate(
            material,
            emission,
            1f,
            world[0].toFloat(),
            world[1].toFloat(),
            world[2].toFloat(),
            data[at + Vertices.NORMAL].toFloat(),
            data[at + Vertices.NORMAL + 1].toFloat(),
            data[at + Vertices.NORMAL + 2].toFloat(),
            light,
        )
        for (k in 0 until 3) {
            val color = data[at + Vertices.COLOR + k].toFloat() * base.channel(k)
            data[at + Vertices.COLOR + k] = (color * light[k] + light[3 + k]).toDouble()
        }
        data[at + Vertices.COLOR + 3] = (data[at + Vertices.COLOR + 3].toFloat() * base.alpha).toDouble()
    }

    private companion object {
        /** Scratch memory of a batch for metallicness, after that of [BatchPhysicalLighting]. */
        const val METALLIC = BatchPhysicalLighting.ARRAYS
        const val ARRAYS = METALLIC + 1

        /** Bounds of the highlights that one fragment may stand for. */
        const val LEAST_ROUGHNESS = 0.25f
        const val MOST_SHININESS = 64

        /** The part of an opacity by which the filter of a texture may round it: 2^-18. */
        const val FILTER_ROUNDING = 1f / (1 shl 18)
    }
}
