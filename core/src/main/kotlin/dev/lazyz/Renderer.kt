package dev.lazyz

import java.io.IOException

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
