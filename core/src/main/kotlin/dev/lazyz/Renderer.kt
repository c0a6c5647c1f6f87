package dev.lazyz

import java.io.IOException
import kotlinx.coroutines.flow.Flow

/**
 * A hidden-surface algorithm: determines which primitive is visible at each sample, and computes the image.
 *
 * All renderers give the same result, bit for bit. They differ in time, memory and the number of shading calls. To
 * write your own, implement [render] with a sink, and check it with the suite in `lazyz-conformance`.
 *
 * A renderer can be used for any number of frames, one after the other or from several threads at the same time.
 */
public interface Renderer {
    /** Short lower-case name, unique among renderers, for example `zbuffer`. */
    public val id: String

    /** A description of the renderer in one line. */
    public val summary: String

    /** What the renderer guarantees in addition to the correct image. */
    public val capabilities: Set<Capability> get() = emptySet()

    /**
     * Returns this renderer with the given [options].
     *
     * @throws IllegalArgumentException if its [capabilities] do not include all that the options need, see
     *   [RenderOptions.requireSupportedBy]. [RenderOptions.supportedBy] leaves such options out
     */
    public fun configured(options: RenderOptions): Renderer = apply { options.requireSupportedBy(this) }

    /**
     * Renders [frame] and passes every row of its region to [sink], once, from top to bottom, on the calling thread.
     *
     * An exception from a primitive, a shader or the sink ends the rendering and is rethrown unchanged.
     *
     * @return the work that the rendering took
     * @throws IllegalArgumentException if the frame has translucent primitives and the renderer does not blend
     * @throws InterruptedException if the calling thread is interrupted. The built-in renderers then end after at most
     *   100 ms of processor time, plus that of the call of a primitive, a shader, a selector or the sink in progress.
     *   Another renderer may also finish the image; the interrupt status then stays set
     * @throws IOException if the sink throws it
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(frame: Frame, sink: RowSink): Counters

    /**
     * Renders pixels of [side] x [side] samples of [frame], each the mean of its own samples, and passes every row of
     * them to [sink]; or returns null, before the first row, if this renderer does not do that. Then the rows of
     * samples are filtered. The pixels are the same, bit for bit. Called by `SampledFrame`, which callers use. A
     * renderer that delegates to another one and changes [render] must override this, too.
     *
     * @param frame samples; the region consists of whole pixels
     * @return the work, counted in samples, or null
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun renderPixels(frame: Frame, side: Int, sink: RowSink): Counters? = null

    /**
     * Renders [frame] into memory. Throws like the other [render]. Cost: 12 bytes a sample in addition to the
     * renderer's own memory.
     */
    @Throws(InterruptedException::class)
    public fun render(frame: Frame): Image {
        val collector = Image.Collector(frame.region)
        val counters = render(frame, collector)
        return collector.toImage(counters)
    }
}

/**
 * Where primitives are shaded with several samples a pixel. How often a shader is called depends on the renderer:
 * `TiledRenderer` calls it once for each primitive that has one colour in a pixel, as long as it adds up the samples
 * itself. Others call it at each visible sample, and look for the point of the colour each time.
 */
public enum class ShadingRate {
    /** At every visible sample. */
    SAMPLE,

    /**
     * A primitive has one colour in each pixel, that of the mean of the pixel's samples that are in it (contract rule
     * 6.12). The edges of primitives are as smooth as with [SAMPLE]; highlights are not. Textures with a `MipFilter`
     * are read with the footprint of a pixel, as with one sample a pixel. For expensive shaders.
     */
    PIXEL,

    /**
     * As [PIXEL] for triangles whose colours change little within a pixel, which their material decides: it has no
     * maps, no custom shader and no narrow highlights. All else as [SAMPLE]. Nearly as exact as [SAMPLE].
     */
    AUTO,
}

/** Receives finished rows, in order from the top. */
public fun interface RowSink {
    /**
     * Receives row [y] of the raster. The arrays belong to the renderer and are valid only during this call. Element 0
     * is the first column of the frame's region. The arrays can be longer than the row. The sink may change the
     * elements of the row, which does not affect later rows, but no other elements.
     *
     * @param argb colours, 8-bit sRGB with straight alpha, `0xAARRGGBB`
     * @param depth depths, 0..2^31-1, see [Depth]
     * @param primitive submission index of the visible primitive, or [DepthTest.BACKGROUND]
     * @throws IOException if the row cannot be written; rendering ends, and the exception reaches its caller
     */
    @Throws(IOException::class)
    public fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray)
}

/**
 * A renderer that takes primitives one by one, as they arrive. It keeps a primitive only as long as the image needs it,
 * so there may be more primitives than fit into memory.
 *
 * The image is that of a [Frame] with the same primitives in the same order (contract rule 7.6).
 */
public interface StreamingRenderer : Renderer {
    /**
     * Begins an image of [region]; no primitive has arrived yet. Several images can be in progress at the same time.
     *
     * @throws IllegalArgumentException if [region] is not within [raster], or too large for this renderer
     */
    public fun begin(raster: Raster, region: Region): Rendering

    /** Begins an image of the whole [raster]. Throws like the other [begin]. */
    public fun begin(raster: Raster): Rendering = begin(raster, raster.region)

    /** An image whose primitives arrive one by one, see [StreamingRenderer.begin]. Not thread safe. */
    public interface Rendering {
        /**
         * Draws [primitive]. The order of the calls is the order of submission, which decides ties of depth.
         *
         * An exception from the primitive or its shader is rethrown unchanged, and ends the image.
         *
         * @throws IllegalArgumentException if the primitive is translucent and the renderer does not blend; the image
         *   can be continued without it
         * @throws IllegalStateException if the image has ended, or already has 2^31-1 primitives
         * @throws InterruptedException as [Renderer.render]; it ends the image
         */
        @Throws(InterruptedException::class)
        public fun add(primitive: Primitive)

        /**
         * Ends the image, and passes every row to [sink], once, from top to bottom, on the calling thread.
         *
         * @return the work that the image took
         * @throws IllegalStateException if the image has already ended
         * @throws InterruptedException as [Renderer.render]
         * @throws IOException if the sink throws it
         */
        @Throws(InterruptedException::class, IOException::class)
        public fun finish(sink: RowSink): Counters
    }
}

/**
 * Renders [primitives] as they arrive, and passes every row to [sink] after the last one.
 *
 * Cancellable between primitives. If the flow throws an exception, rendering ends and the sink receives no rows. Throws
 * like [StreamingRenderer.Rendering.add] and [StreamingRenderer.Rendering.finish].
 */
@JvmSynthetic
public suspend fun StreamingRenderer.render(raster: Raster, primitives: Flow<Primitive>, sink: RowSink): Counters {
    val drawing = begin(raster)
    primitives.collect { drawing.add(it) }
    return drawing.finish(sink)
}

/**
 * A guarantee that a renderer gives in addition to the correct image. The conformance suite checks each declared
 * capability (contract rule 7.6). A capability that is not declared is neither used nor tested.
 */
public enum class Capability {
    /** Shades each visible sample exactly once, and nothing else: shading calls = visible samples. */
    SHADES_ONLY_VISIBLE,

    /** The amount of working memory does not depend on the number of rows of the raster. */
    CONSTANT_MEMORY,

    /** Passes each row to the sink as soon as it is complete, before work on later rows starts. */
    STREAMS_ROWS,

    /**
     * Reads primitives one by one and does not keep hidden ones: memory does not grow with their number.
     */
    STREAMS_PRIMITIVES,

    /** Uses several threads, up to [RenderOptions.threads]. */
    PARALLEL,

    /** Blends translucent primitives in exact depth order. */
    TRANSPARENCY,

    /** Limits its working memory to [RenderOptions.memoryBudget]. */
    MEMORY_BUDGET,

    /** Shades after visibility is known, and supports [RenderOptions.coherence]. */
    COHERENCE,

    /** Supports [RenderOptions.selector]: the caller chooses which fragments of a sample determine its colour. */
    SELECTION,
}
