package dev.lazyz

import java.io.IOException
import kotlinx.coroutines.flow.Flow

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
    public fun begin(raster: Raster, region: Region): Drawing

    /** Begins an image of the whole [raster]. Throws like the other [begin]. */
    public fun begin(raster: Raster): Drawing = begin(raster, raster.region)
}

/** An image whose primitives arrive one by one, see [StreamingRenderer.begin]. Not thread safe. */
public interface Drawing {
    /**
     * Draws [primitive]. The order of the calls is the order of submission, which decides ties of depth.
     *
     * An exception from the primitive or its shader is rethrown unchanged, and ends the image.
     *
     * @throws IllegalArgumentException if the primitive is translucent and the renderer does not blend; the image can
     *   be continued without it
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

/**
 * Renders [primitives] as they arrive, and passes every row to [sink] after the last one.
 *
 * Cancellable between primitives. If the flow throws an exception, rendering ends and the sink receives no rows. Throws
 * like [Drawing.add] and [Drawing.finish].
 */
@JvmSynthetic
public suspend fun StreamingRenderer.render(raster: Raster, primitives: Flow<Primitive>, sink: RowSink): Counters {
    val drawing = begin(raster)
    primitives.collect { drawing.add(it) }
    return drawing.finish(sink)
}
