package dev.lazyz.strategies.lists

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.byFirstRow
import dev.lazyz.raster.bytes
import dev.lazyz.requireInMemory
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans
import java.io.IOException

/**
 * Each sample keeps all its fragments with suspended colours; a [Selector] then chooses the result.
 *
 * The scan conversion does not depend on the choice: nearest, farthest, k-th, a count of overdraw, exact blending, or a
 * custom selector. Colours that the selector does not request are never computed. Without a selector the visible
 * fragment is shown. If the frame has translucent primitives, all fragments are instead blended in exact order of
 * depth, without approximation; the result does not depend on the order of submission.
 *
 * Use it for translucent scenes, for layers of depth, and to visualize overdraw. Where only the nearest fragment
 * matters, the other lazy renderers do less work.
 *
 * Works row by row. Memory: 8 bytes a primitive, plus 12 bytes and a cursor while the primitive is active; for one row,
 * 8 bytes a fragment, 12 a span and 24 a column. Long rows are processed in pieces, so that at most about a million
 * fragments are held at once. Time: proportional to the number of fragments, plus sorting the fragments of a sample if
 * the selector requests more than the nearest. Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), on cells that hold lists of
 * (depth, colour). Loren Carpenter, "The A-buffer, an Antialiased Hidden Surface Method", SIGGRAPH 1984, keeps such
 * lists for the whole picture and shades fragments when they are added; here the lists exist for one row and fragments
 * are shaded when they are chosen.
 */
public class ListsRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "lists"

    override val summary: String get() = "each sample keeps all its fragments, a selector picks or blends them"

    /**
     * Shades only what is visible with the default selector, and blends translucent primitives unless the caller
     * chooses another selector.
     */
    override val capabilities: Set<Capability>
        get() {
            val isUsual = options.selector == null || options.selector === Selector.nearest()
            return if (isUsual) ALWAYS + Capability.SHADES_ONLY_VISIBLE else ALWAYS
        }

    override fun configured(options: RenderOptions): Renderer = ListsRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireInMemory(frame, this)
        val selector = options.selector ?: if (frame.hasTranslucency) Selector.blend() else Selector.nearest()
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val shading = LateShading(frame, options.coherence, counters, Checkpoint.CALLER)
        val active = ActiveList(frame)
        val fragments = RowFragments(frame, counters)
        val cell = RowCell(frame, fragments, shading)
        val row = RowOutput(frame)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            endIfInterrupted()

            // Scan-convert the row, one piece at a time
            active.moveTo(y, fragments)
            shading.beginRow()
            row.clear()
            var start = 0
            while (start < frame.width) {
                val end = fragments.fill(y, start)

                // Let the selector choose among the fragments of each sample
                for (column in start until end) {
                    endIfInterrupted()
                    if (!cell.moveTo(column, y)) continue
                    counters.depthPasses++
                    selector.select(cell)
                    if (cell.isShown) row.set(column, cell)
                }
                start = end
            }
            row.handOut(y, sink)
        }
        shading.beginRow()
        counters.peakBytes = active.peakBytes + fragments.peakBytes + row.bytes + shading.peakBytes
        return counters.build()
    }

    override fun toString(): String = "ListsRenderer($options)"

    private companion object {
        val ALWAYS: Set<Capability> = setOf(
            Capability.CONSTANT_MEMORY,
            Capability.STREAMS_ROWS,
            Capability.TRANSPARENCY,
            Capability.COHERENCE,
            Capability.SELECTION,
        )
    }
}

/**
 * The primitives that may cover the current row, each with a cursor. A primitive is added at its first row and removed
 * after its last. The order does not matter, because the fragments of a sample are sorted by key.
 */
internal class ActiveList(private val frame: Frame) {
    private val spans = frame.region.spans()

    /** First row and index of each primitive that may cover the region, sorted. */
    private val arrivals = frame.byFirstRow(Checkpoint.CALLER)
    private var arrived = 0

    private var indices = IntArray(INITIAL)
    private var cursors = arrayOfNulls<SpanCursor>(INITIAL)
    private var count = 0

    /** Bytes of the cursors themselves, now and at most. */
    private var cursorBytes = 0L
    private var mostCursorBytes = 0L

    /** Bytes held at most; the arrays never shrink. */
    val peakBytes: Long get() = arrivals.bytes + indices.bytes + cursors.bytes + mostCursorBytes

    /** Adds the spans of row [y], which follows the row of the last call, to [fragments]. */
    fun moveTo(y: Int, fragments: RowFragments) {
        // Add the primitives that start at this row
        while (arrived < arrivals.size && (arrivals[arrived] ushr 32).toInt() == y) {
            admit(arrivals[arrived++].toInt(), y)
        }

        // Get the spans of each primitive, and remove primitives that end at this row
        fragments.clear()
        var i = 0
        while (i < count) {
            endIfInterrupted()
            val index = indices[i]
            checkNotNull(cursors[i]).next(spans)
            for (span in 0 until spans.count) fragments.add(index, spans.start(span), spans.end(span))
            if (y + 1 < frame.primitives[index].rowEnd) i++ else dismiss(i)
        }
    }

    private fun admit(index: Int, y: Int) {
        if (count == indices.size) {
            indices = indices.copyOf(2 * count)
            cursors = cursors.copyOf(2 * count)
        }
        val cursor = frame.primitives[index].cursor(y)
        cursorBytes += cursor.bytes
        mostCursorBytes = maxOf(mostCursorBytes, cursorBytes)
        indices[count] = index
        cursors[count] = cursor
        count++
    }

    private fun dismiss(i: Int) {
        cursorBytes -= checkNotNull(cursors[i]).bytes
        count--
        indices[i] = indices[count]
        cursors[i] = cursors[count]
        cursors[count] = null
    }

    private companion object {
        const val INITIAL = 16
    }
}
