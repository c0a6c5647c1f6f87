package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.meshes.Palette
import dev.lazyz.scenes.meshes.TexturePlaces

/** The groups of colours and texture coordinates of a model part, by number, and what is in them. */
internal class ThreeMfLooks {
    val palette = Palette()
    val places = TexturePlaces()

    /** The textures by number. */
    val textures = HashMap<Int, ThreeMfTexture>()

    /** The groups by number. */
    val groups = HashMap<Int, Group>()

    /**
     * What corners can refer to: [numbers] of colours, or of texture coordinates.
     *
     * @property texture number of the texture, or -1 for colours
     */
    class Group(val texture: Int = -1) {
        val numbers = Ints()
    }
}

/**
 * A picture in the package.
 *
 * @property path the part's name
 * @property wrapU what is beyond its sides: `wrap`, `mirror`, `clamp` or `none`
 * @property wrapV what is above and below it
 * @property isSmooth whether texels are blended
 */
internal class ThreeMfTexture(val path: String, val wrapU: String?, val wrapV: String?, val isSmooth: Boolean)
