package dev.lazyz.scenes

import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.filter.PixelFilter
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.ShadingRate
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightMeter
import dev.lazyz.lighting.LightRig
import dev.lazyz.world.Camera
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint

/**
 * How a file is shown, with the defaults of `zcli render`: the whole model, in three quarter view, with more light for
 * dark materials, and 4 x 4 samples a pixel.
 *
 * ```
 * val frame = PictureSettings(640, 480).frame(Scenes.load(path))
 * frame.render(Tiled()).writePng(output)
 * ```
 *
 * Each property that is null has a default, which can depend on the file. Immutable and thread safe.
 *
 * @property size width and height of the picture
 * @property viewpoint the camera; by default a model is shown as a whole, also if it has cameras, and a scene file from
 *   its own camera
 * @property up the axis of the model that points up; by default that of the format, [SceneFormat.usualUp]
 * @property light the lights; by default those of the file, or a studio ([LightRig.STUDIO]) if it has none
 * @property lightIntensity the factor of all light, 0 or more; by default what [LightMeter] finds for models, and
 *   that of a scene file
 * @property background the colour around the surfaces; by default that of the file
 * @property sampling the samples of a pixel; by default [USUAL_FACTOR] x [USUAL_FACTOR], or one where that is not
 *   possible, see [SuperSampling.obstacle]; with [PictureStyle.PRODUCT] a pixel is shaded once, else each sample
 * @property style what `zcli render --style` does; null for none. The [viewpoint] and the [background] take precedence
 */
public class PictureSettings private constructor(
    public val size: ImageSize,
    public val viewpoint: Viewpoint?,
    public val up: UpAxis?,
    public val light: LightRig?,
    public val lightIntensity: Float?,
    public val background: Rgba?,
    public val sampling: SuperSampling?,
    public val style: PictureStyle?,
) {
    /**
     * @param width number of columns, 1..[dev.lazyz.Raster.MAX_SIDE]
     * @param height number of rows, in the same range
     * @throws IllegalArgumentException if a side is out of range
     */
    public constructor(width: Int, height: Int) :
        this(ImageSize(width, height), null, null, null, null, null, null, null)

    public fun withSize(size: ImageSize): PictureSettings = copy(size = size)

    public fun withViewpoint(viewpoint: Viewpoint?): PictureSettings = copy(viewpoint = viewpoint)

    public fun withUp(up: UpAxis?): PictureSettings = copy(up = up)

    public fun withLight(light: LightRig?): PictureSettings = copy(light = light)

    /** @throws IllegalArgumentException if [intensity] is negative or not finite */
    public fun withLightIntensity(intensity: Float): PictureSettings {
        require(intensity in 0f..Float.MAX_VALUE) { "intensity must be 0 or more: $intensity" }
        return copy(lightIntensity = intensity)
    }

    /** Returns these settings with the default intensity of light, see [lightIntensity]. */
    public fun withDefaultLightIntensity(): PictureSettings = copy(lightIntensity = null)

    public fun withBackground(background: Rgba?): PictureSettings = copy(background = background)

    public fun withSampling(sampling: SuperSampling?): PictureSettings = copy(sampling = sampling)

    public fun withStyle(style: PictureStyle?): PictureSettings = copy(style = style)

    private fun copy(
        size: ImageSize = this.size,
        viewpoint: Viewpoint? = this.viewpoint,
        up: UpAxis? = this.up,
        light: LightRig? = this.light,
        lightIntensity: Float? = this.lightIntensity,
        background: Rgba? = this.background,
        sampling: SuperSampling? = this.sampling,
        style: PictureStyle? = this.style,
    ) = PictureSettings(size, viewpoint, up, light, lightIntensity, background, sampling, style)

    /**
     * Sets up the picture of [loaded].
     *
     * @param options the threads of set-up, see [Scene.frame]
     * @throws NoPictureException if no camera shows the model, because its numbers would be beyond their range, or if
     *   the chosen [sampling] is not possible
     * @throws UnsupportedOperationException if the scene cannot be rotated, see [Scene.withUpAxis]
     * @throws InterruptedException as [Scene.frame], and while shadows of a [style] are computed
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(loaded: LoadedScene, options: RenderOptions = RenderOptions()): SampledFrame {
        val upright = upright(loaded)
        val seen = seen(upright)
        val lit = loaded.lit(style?.painted(seen) ?: seen, light, lightIntensity)
        val raster = loaded.depth.raster(size.width, size.height, background ?: lit.background)
        val finished = style?.finished(lit, raster, options) ?: lit

        // Of a camera that is no rule, the planes stay where they are
        val scene = if (upright.viewpoint is Camera) finished.withViewpoint(upright.viewpoint) else finished
        if (sampling != null) {
            sampling.obstacle(scene, raster)?.let { throw NoPictureException(it) }
            return sampling.frame(scene, raster, options)
        }
        // Occlusion makes shading expensive, so that a pixel is shaded once
        val isExpensive = style == PictureStyle.PRODUCT
        val usual = if (isExpensive) SuperSampling(USUAL_FACTOR, PixelFilter.BOX, ShadingRate.PIXEL) else USUAL_SAMPLING
        return (if (usual.obstacle(scene, raster) == null) usual else SuperSampling.NONE).frame(scene, raster, options)
    }

    /**
     * Returns the pictures of a turn around [loaded] in equal [steps]. The [viewpoint] chooses the side at which it
     * begins.
     *
     * @throws NoPictureException if the scene is given on the screen
     * @throws IllegalArgumentException if [steps] is below 1
     * @throws UnsupportedOperationException if the scene cannot be rotated, see [Scene.withUpAxis]
     */
    public fun turntable(loaded: LoadedScene, steps: Int): Turntable = Turntable(this, loaded, steps)

    /** Returns the scene of [loaded], in which y points up, with the viewpoint of these settings. */
    internal fun upright(loaded: LoadedScene): Scene {
        if (loaded.scene.isOnScreen) return loaded.scene
        val own = if (loaded.cameras.isEmpty()) loaded.scene.viewpoint else Camera.fit()
        val upright = loaded.scene.withViewpoint(viewpoint ?: own).withUpAxis(up ?: loaded.usualUp)
        if (viewpoint != null || style == null) return upright
        return upright.withViewpoint(style.framed(upright.viewpoint))
    }

    /** Returns [upright] with its camera. */
    private fun seen(upright: Scene): Scene {
        if (upright.isOnScreen) return upright
        val camera = try {
            upright.camera(size.width, size.height)
        } catch (e: IllegalArgumentException) {
            throw NoPictureException("there is no such camera: ${e.message}", e)
        }
        return upright.withViewpoint(camera)
    }

    override fun toString(): String = "PictureSettings($size)"

    public companion object {
        /** Samples a pixel in each direction, if [sampling] is null. */
        public const val USUAL_FACTOR: Int = 4

        private val USUAL_SAMPLING = SuperSampling(USUAL_FACTOR)
    }
}

/**
 * A model that cannot be shown with the [PictureSettings]: no camera shows it, or the sampling is not possible. The
 * message says why.
 */
public class NoPictureException internal constructor(message: String, cause: Throwable? = null) :
    IllegalArgumentException(message, cause)
