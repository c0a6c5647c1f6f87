package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.world.Camera
import dev.lazyz.world.Lines
import dev.lazyz.world.Points
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.Surface
import java.io.IOException

/**
 * Anti-aliasing by several samples a pixel: [factor] x [factor] samples on a regular grid, and a box filter.
 *
 * ```
 * val smooth = SuperSampling(4)
 * val image = smooth.render(Tiled(), smooth.frame(scene, Raster(640, 480)))
 * ```
 *
 * The frame is an ordinary one, of a raster [factor] times as wide and as high, so every renderer, option and region
 * works, and all renderers give the same bits. A pixel's colour is the mean of its samples in linear light, weighted by
 * their alpha; its alpha is the mean alpha. The samples are those of contract rule 6.4, so each has 8 bits a component.
 * Sums are of integers, so their order does not matter. Depth and primitive are those of the sample that wins the depth
 * test. If no sample has an alpha above 0, the pixel is as its upper left sample.
 *
 * Cost: [factor]^2 samples a pixel, shaded one by one. Memory: that of the renderer for rows of samples, and 48 bytes a
 * column of pixels. Rows are passed on as soon as their samples are complete. Immutable and thread safe.
 *
 * @property factor samples a pixel in each direction, 1..[MAX_FACTOR]; with 1, nothing changes
 * @throws IllegalArgumentException if [factor] is out of range
 */
public class SuperSampling(public val factor: Int) {
    init {
        require(factor in 1..MAX_FACTOR) { "factor must be in 1..$MAX_FACTOR: $factor" }
    }

    /**
     * Sets up [scene] for the samples of [pixels]. Sizes of [Points] and [Lines] stay as they are in pixels.
     *
     * @param options the threads of set-up, see [Scene.frame]
     * @throws IllegalArgumentException if the raster of samples has a side above [Raster.MAX_SIDE]
     * @throws UnsupportedOperationException if [factor] is above 1 and the camera's projection is [Projection.Screen]:
     *   such a scene is given in samples
     */
    @JvmOverloads
    public fun frame(scene: Scene, pixels: Raster, options: RenderOptions = RenderOptions()): Frame {
        if (factor == 1) return scene.frame(pixels, options)
        if ((scene.viewpoint as? Camera)?.projection == Projection.Screen) {
            throw UnsupportedOperationException("a scene given on the screen has one sample a pixel")
        }
        val widest = Raster.MAX_SIDE / factor
        require(pixels.width <= widest && pixels.height <= widest) {
            "with $factor x $factor samples a pixel, a side has at most $widest pixels: ${pixels.width} x ${pixels.height}"
        }
        val magnified = scene.withSurfaces(scene.surfaces.map { magnified(it) })
        return magnified.frame(pixels.withSize(pixels.width * factor, pixels.height * factor), options)
    }

    private fun magnified(surface: Surface): Surface = when (surface) {
        is Points -> surface.withSize(surface.size * factor)
        is Lines -> surface.withWidth(surface.width * factor)
        else -> surface
    }

    /** Returns the samples of a region of pixels, for [Frame.within]. */
    public fun samples(pixels: Region): Region = Region(
        pixels.columnStart * factor,
        pixels.rowStart * factor,
        pixels.columnEnd * factor,
        pixels.rowEnd * factor,
    )

    /**
     * Returns the pixels of a region of samples.
     *
     * @throws IllegalArgumentException if the region does not consist of whole pixels
     */
    public fun pixels(samples: Region): Region {
        val pixels = Region(
            samples.columnStart / factor,
            samples.rowStart / factor,
            samples.columnEnd / factor,
            samples.rowEnd / factor,
        )
        require(samples(pixels) == samples) { "$samples must consist of pixels of $factor x $factor samples" }
        return pixels
    }

    /**
     * Renders [frame], a frame of samples, and passes every row of pixels to [sink]. Throws like [Renderer.render].
     *
     * @return the work, counted in samples
     * @throws IllegalArgumentException if the frame's region does not consist of whole pixels
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(renderer: Renderer, frame: Frame, sink: RowSink): Counters =
        renderer.render(frame, toPixels(frame, sink))

    /** Renders [frame], a frame of samples, to an image of pixels in memory. Throws like the other [render]. */
    @Throws(InterruptedException::class)
    public fun render(renderer: Renderer, frame: Frame): Image {
        val collector = Image.Collector(pixels(frame.region))
        return collector.toImage(render(renderer, frame, collector))
    }

    /**
     * Returns a sink for the rows of [frame], a frame of samples. It passes rows of pixels to [sink]. Used once; not
     * thread safe.
     *
     * @throws IllegalArgumentException if the frame's region does not consist of whole pixels
     */
    public fun toPixels(frame: Frame, sink: RowSink): RowSink {
        val pixels = pixels(frame.region)
        return if (factor == 1) sink else BoxFilter(factor, pixels, frame.raster.depthTest, sink)
    }

    override fun toString(): String = "SuperSampling($factor)"

    public companion object {
        /** The largest [factor]. */
        public const val MAX_FACTOR: Int = 16

        /** One sample a pixel. */
        @JvmField
        public val NONE: SuperSampling = SuperSampling(1)
    }
}
