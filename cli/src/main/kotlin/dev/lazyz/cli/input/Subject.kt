package dev.lazyz.cli.input

import dev.lazyz.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.Shader
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.world.Scene
import dev.lazyz.world.ToneCurve
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.Shading
import java.nio.file.Path
import java.time.Duration

/** How to render translucent materials. */
internal enum class Translucency {
    BLENDED,
    OPAQUE,
    ;

    /** Returns [scene], whose translucent materials are opaque if they are to be rendered so. */
    fun appliedTo(scene: Scene): Scene = if (this == OPAQUE) scene.withMaterials(::opaque) else scene

    /** Other shaders ignore alpha if the material is opaque; a custom one sets what it likes. */
    private fun opaque(material: Material): Material {
        if (material.alphaMode != AlphaMode.BLEND) return material
        val custom = material.shader
        val shader = custom?.let {
            Shader { fragment ->
                it.shade(fragment)
                fragment.setColor(fragment.red, fragment.green, fragment.blue)
            }
        }
        return material.withAlphaMode(AlphaMode.OPAQUE).withShader(shader)
    }
}

/** The options that determine what a picture shows; null if the user did not give the option. */
internal class Subject(
    val input: String,
    val format: SceneFormat?,
    val loading: LoadOptions,
    val timeLimit: Duration?,
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
    /** Whether no surface has smooth normals. */
    val hasFaceNormals: Boolean get() = shading == Shading.FLAT || shading == Shading.CONSTANT

    /** Whether an option changes the materials. */
    val changesMaterials: Boolean get() = shading != null || mipFilter != null

    /**
     * Checks that no output replaces a file that the options name.
     *
     * @throws Mistake otherwise
     */
    fun requireKept(outputs: OutputPlaces) {
        outputs.requireNone(listOfNotNull(Input(input, format).file), "an input")
        outputs.requireNone(listOfNotNull(texture), "the input of --texture")
        outputs.requireNone(listOfNotNull(light.matcap), "the input of --matcap")
    }

    /** The files that the options name. */
    val files: List<Path> get() = listOfNotNull(Input(input, format).file, texture, light.matcap)
}
