@file:JvmName("GoldenAssertions")

package dev.lazyz.testing

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Scene
import java.io.UncheckedIOException
import org.opentest4j.AssertionFailedError

/**
 * Begins a golden test of [scene], which is rendered at the size that follows.
 *
 * Kotlin: `assertThat(scene).at(512, 512).matches("golden/teapot.png")`; Java: the same, with
 * `import static dev.lazyz.testing.GoldenAssertions.assertThat`.
 */
public fun assertThat(scene: Scene): SceneAssertion = SceneAssertion(scene, Goldens.current())

/** Begins a golden test of the colours of [image]. Its depths and primitives are not compared. */
public fun assertThat(image: Image): PictureAssertion =
    PictureAssertion(Goldens.current()) { ActualPicture(Picture.of(image)) { image.toPng() } }

/** Begins a golden test of a picture in memory: [png] are the bytes of a PNG file. */
public fun assertThat(png: ByteArray): PictureAssertion =
    PictureAssertion(Goldens.current()) { ActualPicture(Picture.decode(png)) { png } }

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

/** A golden test of a picture. Created by [assertThat]. Immutable and thread safe. */
public class PictureAssertion private constructor(
    private val goldens: Goldens,
    private val threshold: Double,
    private val actual: () -> ActualPicture,
) {
    internal constructor(goldens: Goldens, actual: () -> ActualPicture) : this(goldens, 0.0, actual)

    /**
     * Accepts a picture if no channel of a pixel differs by more than [codes] from the golden file, 0..255, in codes of
     * 8 bits. The default is 0, since Lazy Z gives the same bits on every machine. Sizes must be the same in any case.
     *
     * @throws IllegalArgumentException if [codes] is not in 0..255
     */
    public fun withThreshold(codes: Double): PictureAssertion =
        PictureAssertion(goldens, validThreshold(codes), actual)

    /**
     * Compares the picture with the file [golden], pixel by pixel.
     *
     * The path is relative to `src/test/resources` of the project whose tests run, or to the folder that the system
     * property `lazyz.golden.root` names; or it is absolute. With `-Dlazyz.golden.update=true`, a file that is missing
     * or different is written instead of compared, which is printed to standard output. Otherwise it never is.
     *
     * @param golden path of a PNG file, with `/` between folders
     * @throws AssertionFailedError if the pictures differ, or there is no such file. The picture, the differences and a
     *   page that shows them are then in `golden-pictures` of the build folder; the message names them
     * @throws IllegalArgumentException if [golden] does not end in `.png`
     * @throws UncheckedIOException if a file cannot be read or written
     */
    public fun matches(golden: String) {
        require(golden.endsWith(".png")) { "a golden file must end in .png: $golden" }
        val picture = try {
            actual()
        } catch (damaged: SceneFormatException) {
            throw AssertionFailedError("the picture cannot be compared with $golden: ${damaged.message}", damaged)
        }
        goldens.check(golden, picture, threshold)
    }
    internal companion object {
        /** Returns [codes], which must be in 0..255. */
        fun validThreshold(codes: Double): Double {
            require(codes in 0.0..255.0) { "the threshold must be in 0..255: $codes" }
            return codes
        }
    }
}
