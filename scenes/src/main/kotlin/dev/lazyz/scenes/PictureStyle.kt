package dev.lazyz.scenes

import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading

/**
 * Styles of whole pictures: those of `zcli render --style`. [PictureSettings.withStyle] applies all of a style.
 *
 * @property projection the projection of a camera that shows the whole scene, or null for the usual one
 * @property margin its free part of the picture on each side, percent, or null for the usual one
 */
public enum class PictureStyle(public val projection: Fit?, public val margin: Double?) {
    /** A drawing in a manual: edges, white surfaces without light, white background, orthographic. */
    TECHNICAL(Fit.ORTHOGRAPHIC, null) {
        override fun painted(scene: Scene): Scene = scene.withMaterials(::white).withBackground(Rgba.WHITE)

        override fun finished(scene: Scene, raster: Raster, options: RenderOptions): Scene =
            EdgeStyle(width = lineWidth(raster, this)).drawnOn(scene)
    },

    /** A product in a shop: soft shadows, in its hollows and on the ground; the margin leaves room for them. */
    PRODUCT(null, 12.0) {
        override fun painted(scene: Scene): Scene = scene

        override fun finished(scene: Scene, raster: Raster, options: RenderOptions): Scene {
            if (scene.bounds == null) return scene
            AmbientOcclusion.obstacle(scene)?.let { throw NoPictureException(it) }
            val soft = AmbientOcclusion.of(scene, options = options).on(scene)
            return GroundShadow.of(scene, options = options).on(soft)
        }
    }, ;

    /** Returns a camera that shows the whole scene from the side of [viewpoint], in this style. */
    internal fun framed(viewpoint: Viewpoint): FittedViewpoint {
        val whole = FittedViewpoint.like(viewpoint)
        return whole.withKind(projection ?: whole.kind).withMargin(margin ?: whole.margin)
    }

    /** Returns [scene] with the colours of this style. Call it before the scene gets its light. */
    public abstract fun painted(scene: Scene): Scene

    /**
     * Returns [scene], which has a camera and its light, with the lines or shadows of this style, for pictures of
     * [raster]. Uses the threads of [options].
     */
    internal abstract fun finished(scene: Scene, raster: Raster, options: RenderOptions): Scene

    public companion object {
        private fun white(material: Material): Material =
            Material(shading = Shading.CONSTANT, sides = material.sides, name = material.name)

        /**
         * Returns the width of edges in pixels that looks the same in large and in small pictures of [raster]; in
         * [TECHNICAL] drawings they are wider.
         */
        @JvmStatic
        public fun lineWidth(raster: Raster, style: PictureStyle?): Double {
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
