package dev.lazyz.testing

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Scene
import org.opentest4j.AssertionFailedError

/**
 * A golden test of a scene that is rendered at a given size. Created by [SceneAssertion.at]. Methods `with...` return a
 * changed copy. Immutable and thread safe.
 */
public class RenderingAssertion private constructor(
    private val scene: Scene,
    private val raster: Raster,
    private val goldens: Goldens,
    private val renderer: Renderer?,
    private val options: RenderOptions,
    private val antiAliasing: SuperSampling,
    private val threshold: Double,
) {
    internal constructor(scene: Scene, raster: Raster, goldens: Goldens) :
        this(scene, raster, goldens, null, RenderOptions(), SuperSampling.NONE, 0.0)

    /**
     * Renders with [renderer]. The default is the first of [Renderers.builtIn] that supports what the scene and the
     * options need. The picture is the same with any.
     */
    public fun withRenderer(renderer: Renderer): RenderingAssertion = copy(renderer = renderer)

    /** Renders with these [options]. */
    public fun withOptions(options: RenderOptions): RenderingAssertion = copy(options = options)

    /** Renders several samples a pixel. The default is one, `zcli render --aa 1`; zcli's default is 4 x 4. */
    public fun withAntiAliasing(antiAliasing: SuperSampling): RenderingAssertion = copy(antiAliasing = antiAliasing)

    /**
     * Accepts small differences, see [PictureAssertion.withThreshold].
     *
     * @throws IllegalArgumentException if [codes] is not in 0..255
     */
    public fun withThreshold(codes: Double): RenderingAssertion =
        copy(threshold = PictureAssertion.validThreshold(codes))

    /**
     * Renders the scene, and compares the picture with the file [golden], see [PictureAssertion.matches].
     *
     * @throws AssertionFailedError if the pictures differ, if there is no file, or if the thread is interrupted
     * @throws IllegalArgumentException if the scene cannot be rendered like this, for example because the renderer does
     *   not support an option; or as [PictureAssertion.matches]
     */
    public fun matches(golden: String) {
        PictureAssertion(goldens) {
            val image = render()
            ActualPicture(Picture.of(image)) { image.toPng() }
        }.withThreshold(threshold).matches(golden)
    }

    private fun render(): Image {
        try {
            val sampled = antiAliasing.frame(scene, raster, options)
            return sampled.render(rendererFor(sampled.frame))
        } catch (interrupt: InterruptedException) {
            Thread.currentThread().interrupt()
            throw AssertionFailedError("the rendering was interrupted", interrupt)
        }
    }

    private fun rendererFor(frame: Frame): Renderer {
        val needs = options.needs + setOfNotNull(Capability.TRANSPARENCY.takeIf { frame.hasTranslucency })
        val usual = Renderers.builtIn.firstOrNull { it.capabilities.containsAll(needs) } ?: Renderers.builtIn.first()
        return (renderer ?: usual).configured(options)
    }

    private fun copy(
        renderer: Renderer? = this.renderer,
        options: RenderOptions = this.options,
        antiAliasing: SuperSampling = this.antiAliasing,
        threshold: Double = this.threshold,
    ) = RenderingAssertion(scene, raster, goldens, renderer, options, antiAliasing, threshold)
}

/** A golden test of a scene, whose size is not known yet. Created by [assertThat]. Immutable and thread safe. */
public class SceneAssertion internal constructor(private val scene: Scene, private val goldens: Goldens) {
    /**
     * Returns the test of a picture of [width] x [height] pixels, with the background of the scene.
     *
     * @throws IllegalArgumentException if a side is not in 1..[Raster.MAX_SIDE]
     */
    public fun at(width: Int, height: Int): RenderingAssertion =
        RenderingAssertion(scene, Raster(width, height, scene.background), goldens)
}
