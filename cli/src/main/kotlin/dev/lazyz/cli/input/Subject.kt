package dev.lazyz.cli.input

import dev.lazyz.DepthConvention
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.Shader
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.filter.PixelFilter
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.ShadingRate
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.VerticalGradient
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
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
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

/**
 * What is behind the surfaces.
 *
 * @property color the background of the frame; transparent if there is a gradient
 * @property gradient the gradient, or null
 */
internal class Backdrop private constructor(val color: Rgba, val gradient: VerticalGradient?) {
    constructor(color: Rgba) : this(color, null)

    constructor(gradient: VerticalGradient) : this(Rgba.TRANSPARENT, gradient)
}

/**
 * Sizes from the command line that replace those of the input.
 *
 * @property point size of points, pixels; null keeps the sizes of the input
 * @property line width of lines, pixels; null keeps the widths of the input
 */
internal class PixelSizes(private val point: Double?, private val line: Double?) {
    fun applyTo(scene: Scene): Scene {
        if (point == null && line == null) return scene
        return scene.withSurfaces(scene.surfaces.map { sized(it) })
    }

    private fun sized(surface: Surface): Surface = when {
        surface is Points && point != null -> surface.withSize(point)
        surface is Lines && line != null -> surface.withWidth(line)
        else -> surface
    }
}

/**
 * The options of anti-aliasing.
 *
 * @property factor samples a pixel in each direction; null means [usual], or 1 where that is not possible
 * @property rate how often primitives are shaded; null means [usualRate], or each sample where that is not possible
 */
internal class AntiAliasing(
    private val factor: Int?,
    private val usual: Int,
    private val filter: PixelFilter,
    private val rate: ShadingRate?,
    private val usualRate: ShadingRate,
) {
    /** Samples a pixel in each direction, unless that is not possible. */
    val wanted: Int get() = factor ?: usual

    /** An option that needs the whole model in memory, or null. */
    val wholeModel: String? get() = if (rate == ShadingRate.PIXEL) "--shading-rate pixel" else null

    /** Sets up [scene] for the samples of the pixels of [raster]. */
    fun frame(scene: Scene, raster: Raster, options: RenderOptions): SampledFrame {
        val wish = SuperSampling(wanted, filter)
        val obstacle = wish.obstacle(scene, raster)
        if (obstacle != null && factor != null) throw Mistake("--aa $factor: $obstacle; use --aa 1")
        val sampling = if (obstacle == null) wish else SuperSampling(1, filter)
        val sampled = sampling.frame(scene, raster, options)
        if ((rate ?: usualRate) == ShadingRate.SAMPLE) return sampled
        if (!sampled.frame.hasTranslucency) {
            return SuperSampling(sampling.factor, filter, ShadingRate.PIXEL).of(sampled.frame)
        }
        if (rate == null) return sampled
        throw Mistake("--shading-rate pixel: the scene is translucent; use --shading-rate sample, or --opaque")
    }
}
