package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.meshes.Palette
import dev.lazyz.scenes.meshes.TexturePlaces

/** The groups of colours and texture coordinates of a model part, by number, and their content. */
internal class ThreeMfLooks {
    val palette = Palette()
    val places = TexturePlaces()

    /** The textures by number. */
    val textures = HashMap<Int, ThreeMfTexture>()

    /** The groups by number. */
    val groups = HashMap<Int, Group>()

    /**
     * A group that corners can refer to: [numbers] of colours, or of texture coordinates.
     *
     * @property texture number of the texture, or -1 for colours
     */
    class Group(val texture: Int = -1) {
        val numbers = Ints()

        /** The colour on which the texture lies, or null if there is none. */
        var ground: Rgba? = null
    }
}

/**
 * A texture in the package.
 *
 * @property path name of the part that contains the image
 * @property wrapU tiling in the direction of u: `wrap`, `mirror`, `clamp` or `none`; null if not given
 * @property wrapV tiling in the direction of v; see [wrapU]
 * @property isSmooth whether texels are interpolated
 */
internal class ThreeMfTexture(val path: String, val wrapU: String?, val wrapV: String?, val isSmooth: Boolean)
