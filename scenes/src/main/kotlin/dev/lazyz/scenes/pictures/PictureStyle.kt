package dev.lazyz.scenes.pictures

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.world.FittedViewpoint.Fit
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading

/**
 * Styles of whole pictures, see [PictureParameters.STYLE].
 *
 * @property projection the projection of a camera that shows the whole scene, or null for the usual one
 * @property margin its free part of the picture on each side, percent, or null for the usual one
 */
public enum class PictureStyle(public val projection: Fit?, public val margin: Double?) {
    /** A drawing in a manual: edges, white surfaces without light, white background, orthographic. */
    TECHNICAL(Fit.ORTHOGRAPHIC, null) {
        override fun painted(scene: Scene): Scene = scene.withMaterials(::white).withBackground(Rgba.WHITE)
    },

    /** A product in a shop: soft shadows, in its hollows and on the ground; the margin leaves room for them. */
    PRODUCT(null, 12.0) {
        override fun painted(scene: Scene): Scene = scene
    }, ;

    /** Returns [scene] with the colours of this style, before it gets its light. */
    internal abstract fun painted(scene: Scene): Scene

    internal companion object {
        private fun white(material: Material): Material =
            Material(shading = Shading.CONSTANT, sides = material.sides, name = material.name)

        /**
         * Returns the width of edges in pixels that looks the same in large and in small pictures of [raster]; in
         * [TECHNICAL] drawings they are wider.
         */
        internal fun lineWidth(raster: Raster, style: PictureStyle?): Double {
            val scale = minOf(raster.width, raster.height) / USUAL_SIDE
            return (if (style == TECHNICAL) TECHNICAL_WIDTH else 1.0) * scale.coerceIn(LEAST_SCALE, MOST_SCALE)
        }

        /** The width of lines in technical drawings, pixels in a picture of [USUAL_SIDE]; otherwise it is 1. */
        private const val TECHNICAL_WIDTH = 1.5

        /** The shorter side of a picture, pixels, and how much lines grow and shrink with it. */
        private const val USUAL_SIDE = 480.0
        private const val LEAST_SCALE = 0.5
        private const val MOST_SCALE = 8.0
    }
}
