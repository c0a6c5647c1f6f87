package dev.lazyz.cli.input

import dev.lazyz.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.MipFilter
import dev.lazyz.world.Scene
import dev.lazyz.world.Shading
import dev.lazyz.world.ToneCurve
import dev.lazyz.world.UpAxis
import java.nio.file.Path

/** How to render translucent materials. */
internal enum class Translucency {
    BLENDED,
    OPAQUE,
    ;

    /** Returns [scene], whose translucent materials are opaque if they are to be rendered so. */
    fun appliedTo(scene: Scene): Scene = if (this == OPAQUE) {
        scene.withMaterials { if (it.alphaMode == AlphaMode.BLEND) it.withAlphaMode(AlphaMode.OPAQUE) else it }
    } else {
        scene
    }
}

/** The options that determine what a picture shows; null if the user did not give the option. */
internal class Subject(
    val input: String,
    val format: SceneFormat?,
    val loading: LoadOptions,
    val up: UpAxis?,
    val size: ImageSize?,
    val region: Region?,
    val antiAliasing: AntiAliasing,
    val background: Backdrop?,
    val color: Rgba?,
    val texture: Path?,
    val shading: Shading?,
    val toneCurve: ToneCurve?,
    val exposure: Double?,
    val mipFilter: MipFilter?,
    val sizes: PixelSizes,
    val translucency: Translucency,
    val depthConvention: DepthConvention?,
    val pointOfView: PointOfView,
    val lineWork: LineWork,
    val light: LightChoice,
    val style: PictureStyle?,
) {
    /** Whether an option changes the materials. */
    val changesMaterials: Boolean get() = shading != null || mipFilter != null
}
