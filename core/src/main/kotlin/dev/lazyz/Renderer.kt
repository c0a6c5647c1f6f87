package dev.lazyz

/**
 * A hidden-surface algorithm: an order in which to evaluate which primitive is visible at which sample.
 *
 * All renderers give the same bits; they differ in time, memory and the number of shading calls. To write one,
 * implement [render] with a sink, and prove it with the suite of `lazyz-conformance`.
 *
 * A renderer may be used for any number of frames, one after the other or from several threads at once.
 */
public interface Renderer {
    /** Short lower-case name, unique among renderers, such as `zbuffer`. */
    public val id: String

    /** What the renderer does, in one line. */
    public val summary: String

    /** What the renderer promises beyond the picture. */
    public val capabilities: Set<Capability> get() = emptySet()

    /** Returns a renderer like this one that heeds [options], as far as they go with its [capabilities]. */
    public fun configured(options: RenderOptions): Renderer = this

    /**
     * Renders [frame] and hands every row of its region to [sink], from the top row to the bottom row, each once, on the
     * calling thread.
     *
     * If that thread is interrupted, some renderers throw [InterruptedException]; the others go on, and its interrupt
     * status stays set.
     *
     * @return what it took
     */
    public fun render(frame: Frame, sink: RowSink): Counters

    /** Renders [frame] into memory. Cost: 12 bytes a sample besides the renderer's own memory. */
    public fun render(frame: Frame): Image {
        val collector = Image.Collector(frame.region)
        val counters = render(frame, collector)
        return collector.toImage(counters)
    }
}

/** Takes finished rows, in order from the top. */
public fun interface RowSink {
    /**
     * Takes row [y] of the raster. The arrays belong to the renderer and are valid during this call only; each holds one
     * element a column, beginning with the first column of the frame's region (and may be longer than the row). The sink
     * may write into these elements, which changes nothing in later rows, and into no others.
     *
     * @param argb colours, 8-bit sRGB with straight alpha, `0xAARRGGBB`
     * @param depth depths, 0..2^31-1, see [Depth]
     * @param primitive submission index of the visible primitive, or [DepthTest.BACKGROUND]
     */
    public fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray)
}
