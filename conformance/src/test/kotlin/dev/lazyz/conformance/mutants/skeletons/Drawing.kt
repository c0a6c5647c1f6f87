package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.spi.Fragment

/** A renderer that makes a [Drawing] for each frame; what it promises may depend on its options. */
internal class Workbench(
    override val id: String,
    private val promises: (RenderOptions) -> Set<Capability>,
    private val options: RenderOptions = RenderOptions(),
    private val drawing: (Frame, RenderOptions) -> Drawing,
) : Renderer {
    override val summary: String get() = "a renderer of somebody else"

    override val capabilities: Set<Capability> get() = promises(options)

    override fun configured(options: RenderOptions): Renderer =
        Workbench(id, promises, options.requireSupportedBy(this), drawing)

    override fun render(frame: Frame, sink: RowSink): Counters {
        val drawing = drawing(frame, options)
        if (Capability.TRANSPARENCY !in capabilities) drawing.refuseTranslucent(id)
        return drawing.run(sink)
    }
}

/** One rendering of one frame: what all the ways to do it share. Subclasses override a step to make a mistake. */
internal abstract class Drawing(val frame: Frame) {
    val raster = frame.raster
    val region = frame.region
    val width = frame.width
    val test = raster.depthTest
    val primitives: List<Primitive> = frame.primitives
    val counters = Counters.Builder()
    val fragment = Fragment()

    /** Depths of the span that is being drawn, from its first sample on. */
    val spanDepths = IntArray(width)

    // The row that is handed out
    var argb = IntArray(width)
    var depths = IntArray(width)
    var indices = IntArray(width)

    abstract fun run(sink: RowSink): Counters

    open fun refuseTranslucent(id: String) {
        val index = primitives.indexOfFirst { it.isTranslucent }
        require(index < 0) { "primitive $index is translucent and '$id' does not blend: use asOpaque()" }
    }

    open fun backgroundKey(): Long = test.key(raster.backgroundDepth, DepthTest.BACKGROUND)

    open fun backgroundArgb(): Int = raster.background.toArgb()

    /** Whether the bounds of [primitive] reach the region. */
    open fun reaches(primitive: Primitive): Boolean = primitive.rowStart < region.rowEnd &&
        primitive.rowEnd > region.rowStart && primitive.columnStart < region.columnEnd &&
        primitive.columnEnd > region.columnStart && primitive.rowStart < primitive.rowEnd

    /** Computes the depths of a span. */
    open fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
        val form = primitive.depthForm
        if (form == null) {
            for (x in start until end) spanDepths[x - start] = primitive.depth(x, y)
        } else {
            var z = form.at(start, y)
            for (x in start until end) {
                spanDepths[x - start] = (z shr 32).toInt()
                z += form.dx
            }
        }
    }

    open fun count(start: Int, end: Int) {
        counters.fragments += end - start
        counters.depthEvaluations += end - start
    }

    open fun key(depth: Int, index: Int): Long = test.key(depth, index)

    /** Keeps the lesser keys of a span's samples; [at] is the place of its first sample in [keys]. */
    open fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
        for (i in 0 until count) {
            val key = key(spanDepths[i], index)
            if (key < keys[at + i]) {
                keys[at + i] = key
                counters.depthPasses++
            }
        }
    }

    /** Shades and hands out the row whose keys begin at [offset]. */
    open fun finishRow(keys: LongArray, offset: Int, y: Int, sink: RowSink) {
        for (i in 0 until width) {
            depths[i] = test.depthOf(keys[offset + i])
            indices[i] = test.indexOf(keys[offset + i])
        }
        colorRow(y)
        handOut(y, sink)
    }

    open fun handOut(y: Int, sink: RowSink) = sink.row(y, argb, depths, indices)

    open fun isSameRun(first: Int, second: Int): Boolean = first == second

    /** Colours the row, a run of one primitive after the other. */
    open fun colorRow(y: Int) {
        var start = 0
        while (start < width) {
            var end = start + 1
            while (end < width && isSameRun(indices[start], indices[end])) end++
            if (indices[start] == DepthTest.BACKGROUND) {
                argb.fill(backgroundArgb(), start, end)
            } else {
                colorRun(indices[start], y, start, end)
            }
            start = end
        }
    }

    open fun colorRun(index: Int, y: Int, start: Int, end: Int) {
        for (i in start until end) argb[i] = color(index, region.columnStart + i, y)
    }

    open fun color(index: Int, x: Int, y: Int): Int {
        counters.shadingCalls++
        counters.shadingStarts++
        fragment.moveTo(x, y)
        primitives[index].shade(fragment)
        return fragment.toArgb()
    }

    /** The least key that a fragment of [primitive] may have. */
    open fun nearestKey(primitive: Primitive, index: Int): Long =
        minOf(test.key(primitive.leastDepth, index), test.key(primitive.greatestDepth, index))
}
