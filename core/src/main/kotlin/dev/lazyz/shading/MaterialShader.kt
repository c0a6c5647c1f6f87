package dev.lazyz.shading

import dev.lazyz.BatchShader
import dev.lazyz.Fragment
import dev.lazyz.FragmentBatch
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.Material
import dev.lazyz.world.Shading

/**
 * A shader for a material and lights.
 *
 * For flat and Gouraud shading of polygons, light is evaluated during set-up: [litColor] has stored the product of base
 * colour and light in the vertex colours, and this shader only applies the texture.
 *
 * @param isPrelit whether the vertex colours come from [litColor]
 */
internal class MaterialShader(
    private val material: Material,
    private val lighting: Lighting,
    private val isPrelit: Boolean,
) : BatchShader {
    private val base = material.baseColor
    private val texture = material.texture

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
            val texel = fragment.texel
            texture.sample(fragment, texel)
            red *= texel[0]
            green *= texel[1]
            blue *= texel[2]
            alpha *= texel[3]
        }

        // Light
        if (!isPrelit && material.shading != Shading.CONSTANT) {
            val light = fragment.light
            lighting.illuminate(
                material, fragment.worldX, fragment.worldY, fragment.worldZ,
                fragment.normalX, fragment.normalY, fragment.normalZ, light,
            )
            red = red * light[0] + light[3]
            green = green * light[1] + light[4]
            blue = blue * light[2] + light[5]
        } else if (!isPrelit) {
            red += material.emission.red
            green += material.emission.green
            blue += material.emission.blue
        }
        fragment.setColor(red, green, blue, if (material.alphaMode == AlphaMode.BLEND) alpha else 1f)
    }

    override fun shade(batch: FragmentBatch) {
        val count = batch.size
        if (texture == null && (isPrelit || material.shading == Shading.CONSTANT)) {
            // Only a product and a sum: simple loops, which the JVM vectorises
            scale(batch.vertexRed, base.red, material.emission.red, batch.red, count)
            scale(batch.vertexGreen, base.green, material.emission.green, batch.green, count)
            scale(batch.vertexBlue, base.blue, material.emission.blue, batch.blue, count)
            if (material.alphaMode == AlphaMode.BLEND) scale(batch.vertexAlpha, base.alpha, 0f, batch.alpha, count)
            return
        }
        batch.shadeEach(this)
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
        if (texture != null) {
            texture.sample(fragment, fragment.texel)
            alpha *= fragment.texel[3]
        }
        return alpha
    }

    /**
     * Replaces the colour of [vertex] with the lit colour of the material there, without its texture. [light] is
     * scratch memory of 6 numbers.
     */
    fun litColor(vertices: Vertices, vertex: Int, light: FloatArray) {
        val at = vertices.stride * vertex
        val data = vertices.data
        lighting.illuminate(
            material,
            data[at + Vertices.WORLD].toFloat(),
            data[at + Vertices.WORLD + 1].toFloat(),
            data[at + Vertices.WORLD + 2].toFloat(),
            data[at + Vertices.NORMAL].toFloat(),
            data[at + Vertices.NORMAL + 1].toFloat(),
            data[at + Vertices.NORMAL + 2].toFloat(),
            light,
        )
        for (k in 0 until 3) {
            val color = data[at + Vertices.COLOR + k].toFloat() * component(k)
            data[at + Vertices.COLOR + k] = (color * light[k] + light[3 + k]).toDouble()
        }
        data[at + Vertices.COLOR + 3] = (data[at + Vertices.COLOR + 3].toFloat() * base.alpha).toDouble()
    }

    private fun component(k: Int): Float = when (k) {
        0 -> base.red
        1 -> base.green
        else -> base.blue
    }
}
