package dev.lazyz.strategies.painter

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.forEachRow
import dev.lazyz.shading.LateShading
import dev.lazyz.shading.LayerShading
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans

/**
 * The picture painted so far. Depth is evaluated at the end, for visible samples only.
 *
 * An [OpaquePainting] shades what is painted on it. A [LayeredPainting] keeps translucent layers, and shades at the
 * end.
 */
internal sealed class Painting(protected val frame: Frame, protected val counters: Counters.Builder) {
    protected val region = frame.region
    protected val width = region.width

    /** The visible opaque primitive of each sample, or [DepthTest.BACKGROUND], in rows from the top. */
    protected val indices: IntArray

    init {
        require(region.size <= Image.MAX_SAMPLES) {
            "the painter holds at most ${Image.MAX_SAMPLES} samples: ${region.size}"
        }
        indices = IntArray(region.size.toInt())
        indices.fill(DepthTest.BACKGROUND)
    }

    /** Bytes held. */
    abstract val bytes: Long

    /** Paints the primitive [index] at the columns [start] until [end] of row [y], over what [brush] is over. */
    abstract fun paint(index: Int, y: Int, start: Int, end: Int, brush: Brush)

    /** Writes colours and visible primitives of row [y], whose first sample has the array index [start]. */
    protected abstract fun finishRow(y: Int, start: Int, colors: IntArray, visible: IntArray)

    /** Passes the rows to [sink]. */
    fun finish(sink: RowSink) {
        val colors = IntArray(width)
        val depths = IntArray(width)
        val visible = IntArray(width)
        for (y in region.rowStart until region.rowEnd) {
            endIfInterrupted()
            finishRow(y, at(region.columnStart, y), colors, visible)
            for (i in 0 until width) depths[i] = depth(region.columnStart + i, y, visible[i])
            sink.row(y, colors, depths, visible)
        }
    }

    /** Evaluates the depth of the primitive [index], or of the background, at a sample that it covers. */
    fun depth(x: Int, y: Int, index: Int): Int {
        if (index == DepthTest.BACKGROUND) return frame.raster.backgroundDepth
        counters.depthEvaluations++
        return frame.primitives[index].depth(x, y)
    }

    /** Returns the array index of the sample at column [x] and row [y] of the raster. */
    protected fun at(x: Int, y: Int): Int = (y - region.rowStart) * width + (x - region.columnStart)
}

/** A canvas for opaque primitives: colour and primitive of each sample. What is painted is shaded immediately. */
internal class OpaquePainting(frame: Frame, counters: Counters.Builder) : Painting(frame, counters) {
    private val fragment = Fragment()
    private val argb = IntArray(indices.size)

    init {
        argb.fill(frame.raster.background.toArgb())
    }

    override val bytes: Long get() = argb.bytes + indices.bytes + Int.SIZE_BYTES * 3L * width

    override fun paint(index: Int, y: Int, start: Int, end: Int, brush: Brush) {
        var at = at(start, y)
        for (x in start until end) {
            if (brush.isOver(x, y, index, indices[at])) paint(x, y, at, index)
            at++
        }
    }

    private fun paint(x: Int, y: Int, at: Int, index: Int) {
        endIfInterrupted()
        counters.depthPasses++
        counters.shadingCalls++
        fragment.moveTo(x, y)
        frame.primitives[index].shade(fragment)
        argb[at] = fragment.toArgb()
        indices[at] = index
    }

    override fun finishRow(y: Int, start: Int, colors: IntArray, visible: IntArray) {
        argb.copyInto(colors, 0, start, start + width)
        indices.copyInto(visible, 0, start, start + width)
    }
}

/**
 * A canvas for frames with translucent primitives: at each sample the visible opaque primitive, and the translucent
 * layers painted over it, the nearest on top.
 *
 * A translucent primitive becomes a layer; an opaque one removes the layers that it is over. Both are usually painted
 * on top. Where the order of painting was not proved, a primitive goes below the layers that are over it. Colours are
 * computed at the end and from the front, because contract rule 5.5 blends in this direction, and shades nothing behind
 * layers that no light passes.
 */
internal class LayeredPainting(frame: Frame, counters: Counters.Builder) : Painting(frame, counters) {
    private val shading = LayerShading(frame, LateShading(frame, Coherence.DIRECT, counters, Checkpoint.CALLER))

    /** The top layer of each sample, or [NONE]. */
    private val tops = IntArray(indices.size).apply { fill(NONE) }

    /** For each layer, its primitive, and the layer below it. Unused layers are linked in the same way. */
    private var primitives = IntArray(INITIAL)
    private var belows = IntArray(INITIAL)
    private var used = 0
    private var unused = NONE

    /** Number of fragments on the canvas. All are shading calls to be made, unless something hides them. */
    private var held = 0L

    /** The layers of one sample, from the top. */
    private var stack = IntArray(INITIAL)

    override val bytes: Long
        get() = Int.SIZE_BYTES * (2L * indices.size + 2L * primitives.size + stack.size + 3L * width)

    override fun paint(index: Int, y: Int, start: Int, end: Int, brush: Brush) {
        val isTranslucent = frame.primitives[index].isTranslucent
        var at = at(start, y)
        for (x in start until end) {
            endIfInterrupted()

            // Go below the layers that are over the primitive
            var above = NONE
            var below = tops[at]
            while (below != NONE && !brush.isOver(x, y, index, primitives[below])) {
                above = below
                below = belows[below]
            }
            if (below != NONE || brush.isOver(x, y, index, indices[at])) {
                counters.depthPasses++
                if (isTranslucent) link(at, above, layer(index, below)) else cover(at, above, below, index)
            }
            at++
        }
        counters.peakSuspensions = maxOf(counters.peakSuspensions, held)
    }

    /** Makes the primitive [index] the opaque one of a sample, and removes the layers from [below] on. */
    private fun cover(at: Int, above: Int, below: Int, index: Int) {
        if (indices[at] == DepthTest.BACKGROUND) held++
        indices[at] = index
        link(at, above, NONE)
        var layer = below
        while (layer != NONE) {
            val next = belows[layer]
            belows[layer] = unused
            unused = layer
            held--
            layer = next
        }
    }

    private fun link(at: Int, above: Int, layer: Int) {
        if (above == NONE) tops[at] = layer else belows[above] = layer
    }

    /** Returns a new layer of the primitive [index] over the layer [below]. */
    private fun layer(index: Int, below: Int): Int {
        val layer = if (unused != NONE) unused.also { unused = belows[it] } else append()
        primitives[layer] = index
        belows[layer] = below
        held++
        return layer
    }

    private fun append(): Int {
        if (used == primitives.size) {
            check(used < MAX_LAYERS) { "more than $MAX_LAYERS translucent fragments: render a smaller region" }
            val size = minOf(2L * used, MAX_LAYERS.toLong()).toInt()
            primitives = primitives.copyOf(size)
            belows = belows.copyOf(size)
        }
        return used++
    }

    override fun finishRow(y: Int, start: Int, colors: IntArray, visible: IntArray) {
        for (i in 0 until width) {
            val count = collect(tops[start + i])
            val backdrop = indices[start + i]
            colors[i] = shading.shade(region.columnStart + i, y, stack, count, backdrop)
            visible[i] = if (count > 0) stack[0] else backdrop
        }
    }

    /** Writes the primitives of the layers from [top] down to [stack], and returns their number. */
    private fun collect(top: Int): Int {
        var count = 0
        var layer = top
        while (layer != NONE) {
            if (count == stack.size) stack = stack.copyOf(2 * count)
            stack[count++] = primitives[layer]
            layer = belows[layer]
        }
        return count
    }

    private companion object {
        const val NONE = -1
        const val INITIAL = 16
        const val MAX_LAYERS = Int.MAX_VALUE - 8
    }
}

/**
 * Paints primitives onto a canvas, over primitives that are proved to be behind, without comparing depths.
 *
 * The order of painting is chosen so that every primitive is painted after those that it hides. If primitives form a
 * cycle or surfaces cross, no such order exists. The brush therefore looks at the primitives already painted at each
 * sample (not at their depths). Once for each pair of primitives, it checks whether an order is proved; if not, it
 * compares the two at the samples that they share. At every sample, the canvas thus holds the visible one of all
 * primitives painted so far, in any order of painting, because visibility is a minimum. The background is painted
 * first.
 */
internal class Brush(
    private val frame: Frame,
    private val canvas: Painting,
    private val pairs: PairOrder,
    private val counters: Counters.Builder,
) {
    private val test = frame.raster.depthTest
    private val spans = frame.region.spans()

    /**
     * For each painted primitive (element 0 is the background), the last primitive painted over it, and the order
     * proved for the two.
     */
    private val metBy = IntArray(frame.primitives.size + 1) { NONE }
    private val proved = ByteArray(frame.primitives.size + 1)

    /** Bytes held. */
    val bytes: Long get() = 5L * metBy.size

    fun paint(index: Int) {
        frame.primitives[index].forEachRow(frame.region, spans) { y ->
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                canvas.paint(index, y, spans.start(i), spans.end(i), this)
            }
        }
    }

    /** Whether the primitive [index] is visible before [other] at a sample that both cover. */
    fun isOver(x: Int, y: Int, index: Int, other: Int): Boolean = when (orderOf(index, other)) {
        OVER -> true
        UNDER -> false
        else -> test.key(canvas.depth(x, y, index), index) < test.key(canvas.depth(x, y, other), other)
    }

    /** Returns the order that is proved for the primitive [index] and the [other] wherever both cover a sample. */
    private fun orderOf(index: Int, other: Int): Byte {
        val at = other + 1
        if (metBy[at] != index) {
            metBy[at] = index
            proved[at] = when {
                pairs.isBefore(index, other) -> OVER
                pairs.isBefore(other, index) -> UNDER
                else -> UNPROVED
            }
        }
        return proved[at]
    }

    private companion object {
        const val NONE = -1
        const val OVER: Byte = 1
        const val UNDER: Byte = -1
        const val UNPROVED: Byte = 0
    }
}
