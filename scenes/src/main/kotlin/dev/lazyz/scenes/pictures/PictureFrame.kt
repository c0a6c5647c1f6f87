package dev.lazyz.scenes.pictures

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.filter.PixelBackground
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.geometry.UpAxis
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.images.RadianceImage
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.spi.ShadingObserver
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.EnvironmentMap
import dev.lazyz.world.material.Texture
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/**
 * A picture that is set up and can be rendered: a frame of samples, how they become pixels, and what is behind them.
 * Created by [PictureSettings.frame]. Immutable, and thread safe if the frame's primitives are.
 *
 * @property samples the samples and their filter; they know no [behind]
 * @property behind what is behind the pixels, or null for the background of the frame
 * @property up the axis of the model that points up in the frame
 */
public class PictureFrame internal constructor(
    public val samples: SampledFrame,
    public val behind: PixelBackground?,
    public val up: UpAxis,
    private val crop: Lazy<Boolean>,
    private val names: ParameterNames,
) {
    /**
     * Whether a part of the model is more than half a pixel outside the whole picture, or not between the near and the
     * far plane. Cost: linear in the size of the model when it is first asked for, unless the camera was fitted.
     */
    public val isCropped: Boolean get() = crop.value

    /** The samples of the [pixels]. */
    public val frame: Frame get() = samples.frame

    /** Samples a pixel in each direction. */
    public val factor: Int get() = samples.sampling.factor

    /** Whether each sample is a pixel, without a filter. */
    public val isPlain: Boolean get() = factor == 1 && samples.sampling.filter == PixelFilter.BOX

    /** The pixels of the picture. */
    public val pixels: Region get() = samples.pixels

    /** Whether files need alpha: with an opaque background, all pixels are opaque. */
    public val alpha: AlphaChannel
        get() {
            val isOpaque = behind != null || frame.raster.background.alpha >= 1f
            return if (isOpaque) AlphaChannel.DROP else AlphaChannel.KEEP
        }

    /** Returns this picture, whose shading calls are reported to [observer]. */
    public fun observed(observer: ShadingObserver): PictureFrame =
        PictureFrame(samples.observed(observer), behind, up, crop, names)

    /**
     * Returns the part of this picture with the pixels of [region].
     *
     * @throws IllegalArgumentException if [region] is not within the picture
     */
    public fun within(region: Region): PictureFrame =
        PictureFrame(samples.within(region), behind, up, crop, names)

    /** Returns the plan of [planner] with the first of [renderers] that fits, besides [others]. */
    public fun plan(planner: RenderPlanner, renderers: List<Renderer>, others: List<RenderPlan.Item>): RenderPlan =
        planner.plan(samples, renderers, others)

    /**
     * Renders the picture with [renderer], and passes every row of pixels to [sink]. Throws like [Renderer.render].
     *
     * @return the work, counted in samples
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(renderer: Renderer, sink: RowSink): Counters = samples.render(renderer, before(sink))

    /** Renders the picture to an image in memory. Throws like the other [render]. */
    @Throws(InterruptedException::class)
    public fun render(renderer: Renderer): Image {
        val collector = Image.Collector(pixels)
        return collector.toImage(render(renderer, collector))
    }

    /**
     * Renders the picture in the same way, and computes [aovs], in coordinates of the model.
     *
     * @throws NoPictureException if they are too large
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(renderer: Renderer, sink: RowSink, aovs: Set<Aov>): AovImages {
        val all = try {
            AovFrame(samples, aovs)
        } catch (tooLarge: IllegalArgumentException) {
            val region = names.of(PictureParameters.REGION)
            throw NoPictureException("${names.of("aov")}: ${tooLarge.message}, with $region", tooLarge)
        }
        return all.render(renderer, before(sink)).toModel(up)
    }

    /** Returns what comes before [sink]: what is [behind], and a check for interrupts, as not all strategies look. */
    private fun before(sink: RowSink): RowSink {
        val opaque = behind?.behind(pixels, frame.raster.height / factor, sink) ?: sink
        return RowSink { y, argb, depth, primitive ->
            if (Thread.interrupted()) throw InterruptedException("interrupted before row $y")
            opaque.row(y, argb, depth, primitive)
        }
    }

    override fun toString(): String = "PictureFrame($samples)"
}

/**
 * Is told what happens while a picture is set up. By default, it keeps the warnings, and nothing else comes of it. It
 * also keeps the texture, the matcap, the surroundings, and the model as the camera of the last picture saw it: cut,
 * turned and painted. So pictures of one observer read each file once, and if they differ in camera, light and size
 * alone, they prepare the model once.
 *
 * @property name what the model is called in messages
 * @property limits limits on each of these files
 */
public open class PictureObserver @JvmOverloads constructor(
    public val name: String = "the model",
    public val limits: LoadLimits = LoadLimits(),
) {
    private val kept = ArrayList<String>()
    private val textures = ConcurrentHashMap<Path, Texture>()

    private val environments = ConcurrentHashMap<Path, EnvironmentMap>()

    /** Returns the picture of surroundings in a file. */
    internal fun environment(file: Path, options: RenderOptions): EnvironmentMap = environments.computeIfAbsent(file) {
        RadianceImage.read(it, limits, options, ::warning)
    }

    @Volatile
    private var prepared: PreparedModel? = null

    /** Returns the model that [make] prepares as [key] says, or the last one if that had an equal key. */
    internal fun prepared(key: List<Any?>, make: () -> Scene): PreparedModel =
        prepared?.takeIf { it.key == key } ?: PreparedModel(key, make()).also { prepared = it }

    /** Returns the image in a file. */
    internal fun texture(file: Path): Texture = textures.computeIfAbsent(file) { TextureFiles.read(it, limits) }

    /** The warnings that were kept. */
    public val warnings: List<String> get() = kept

    /** Is told what a setting does not do to this model: a sentence for the user. */
    public open fun warning(message: String) {
        kept += message
    }

    /** Is told the camera of a scene in which y points up; the axis [up] of the model was turned there. */
    public open fun camera(camera: Camera, up: UpAxis): Unit = Unit

    /** Is told that shadows are computed from so many [directions]. */
    public open fun shadows(directions: Int): Unit = Unit

    /** Is told that the shadows from another direction are computed, perhaps by several threads at once. */
    public open fun shadowed(): Unit = Unit

    /** Is told that the scene is set up for the samples of a picture of [size]. */
    public open fun setUp(size: ImageSize): Unit = Unit
}

/** A model that cannot be shown with the [PictureSettings]. The message says why, in words for the user. */
public class NoPictureException internal constructor(message: String, cause: Throwable? = null) :
    IllegalArgumentException(message, cause)

internal fun refuse(message: String): Nothing = throw NoPictureException(message)

/** Why there is nothing to see in a picture. */
public enum class Blank {
    /** No primitive is visible. */
    BACKGROUND,

    /** All pixels have the same colour, also those of the background. */
    ONE_COLOR,
}

/**
 * Finds out whether there is something to see in the rows of a picture. Not thread safe.
 *
 * @param width pixels of a row
 */
public class VisibleRows(private val width: Int) : RowSink {
    /** Number of pixels so far at which a primitive is visible. */
    public var visible: Long = 0L
        private set

    private var pixels = 0L
    private var color = 0
    private var isUniform = true

    /** Why there is nothing to see so far, or null if there is something. */
    public val blank: Blank?
        get() = when {
            visible == 0L -> Blank.BACKGROUND
            isUniform && visible < pixels -> Blank.ONE_COLOR
            else -> null
        }

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray): Unit =
        add(argb, primitive, width)

    /** Looks at all rows of [image]. */
    public fun add(image: Image): Unit = add(image.argb, image.primitive, image.argb.size)

    private fun add(argb: IntArray, primitive: IntArray, size: Int) {
        if (pixels == 0L) color = argb[0]
        var x = 0
        while (isUniform && x < size) isUniform = argb[x++] == color
        pixels += size
        var count = 0
        for (x in 0 until size) if (primitive[x] != DepthTest.BACKGROUND) count++
        visible += count
    }
}
