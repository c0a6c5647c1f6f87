package dev.lazyz.scenes.gltf

import de.javagl.jgltf.impl.v2.TextureInfo

/**
 * The transform of texture coordinates by `KHR_texture_transform`: scale, then rotation, then offset.
 *
 * @property texCoordSet the set of coordinates that replaces the one given by the texture, or null
 */
internal class TextureTransform private constructor(
    private val scale: List<Double>,
    private val rotation: Double,
    private val offset: List<Double>,
    val texCoordSet: Int?,
) {
    /** Returns [uvs] transformed, or the array itself if there is no transform. */
    fun applyTo(uvs: FloatArray): FloatArray {
        if (this === NONE) return uvs
        val sine = StrictMath.sin(rotation)
        val cosine = StrictMath.cos(rotation)
        val result = FloatArray(uvs.size)
        for (i in uvs.indices step 2) {
            val u = uvs[i] * scale[0]
            val v = uvs[i + 1] * scale[1]
            result[i] = (cosine * u + sine * v + offset[0]).toFloat()
            result[i + 1] = (cosine * v - sine * u + offset[1]).toFloat()
        }
        return result
    }

    companion object {
        private val NONE = TextureTransform(listOf(1.0, 1.0), 0.0, listOf(0.0, 0.0), null)

        /** Returns the transform that a reference to a texture specifies. */
        fun of(info: TextureInfo?): TextureTransform {
            val extension = GltfExtensions.of(info, "KHR_texture_transform") ?: return NONE
            return TextureTransform(
                GltfExtensions.pair(extension, "scale", 1.0),
                GltfExtensions.number(extension, "rotation", 0.0),
                GltfExtensions.pair(extension, "offset", 0.0),
                (extension["texCoord"] as? Number)?.toInt(),
            )
        }
    }
}
