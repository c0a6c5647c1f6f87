package dev.lazyz.strategies.lists

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.shading.LateShading

/**
 * Each sample keeps all its fragments with their colours suspended; a [Selector] then chooses what is seen.
 *
 * The scan conversion knows nothing of the choice: nearest, farthest, k-th, a count of overdraw, exact blending, or the
 * caller's own. Colours that the selector does not ask for are never computed. Without a selector the visible fragment
 * is shown, or, where the frame has translucent primitives, all are blended in exact order of depth: transparency that
 * does not depend on the order of submission, without approximation.
 *
 * Use it for translucent scenes, for layers of depth, and to see overdraw; where only the nearest fragment counts, the
 * other lazy renderers do less.
 *
 * Works row by row. Memory: 8 bytes a primitive and 12 more while it is active; of one row 8 bytes a fragment, 12 a
 * span and 24 a column, and the cursors of the active primitives; long rows are taken in pieces, so that no more than
 * about a million fragments are held at once. Time: proportional to the fragments, and sorting those of a sample where
 * the selector asks for more than the nearest. Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995), on cells that hold lists of (depth,
 * colour). Loren Carpenter, "The A-buffer, an Antialiased Hidden Surface Method", SIGGRAPH 1984, keeps such lists for the
 * whole picture, shaded when they are made; here they live for a row and are shaded when they are chosen.
 */
public class Lists @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "lists"

    override val summary: String get() = "each sample keeps all its fragments, a selector picks or blends them"

    /**
     * Shades only what is visible as long as the selector is the usual one, and blends what is translucent unless the
     * caller chooses another.
     */
    override val capabilities: Set<Capability>
        get() {
            val isUsual = options.selector == null || options.selector === Selector.nearest()
            return if (isUsual) ALWAYS + Capability.SHADES_ONLY_VISIBLE else ALWAYS
        }

    override fun configured(options: RenderOptions): Renderer = Lists(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        val selector = options.selector ?: if (frame.hasTranslucency) Selector.blend() else Selector.nearest()
        val counters = Counters()
        counters.primitives = frame.primitives.size.toLong()
        val shading = LateShading(frame, options.coherence, counters)
        val active = ActiveList(frame)
        val fragments = RowFragments(frame, counters)
        val cell = RowCell(frame, fragments, shading)
        val row = RowOutput(frame)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            // Scan-convert the row, a piece at a time
            active.moveTo(y, fragments)
            shading.beginRow()
            row.clear()
            var start = 0
            while (start < frame.width) {
                val end = fragments.fill(y, start)

                // Let the selector choose among the fragments of each sample
                for (column in start until end) {
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
        return counters
    }

    override fun toString(): String = "Lists($options)"

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
