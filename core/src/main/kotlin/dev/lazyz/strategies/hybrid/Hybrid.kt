package dev.lazyz.strategies.hybrid

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Drawing
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.pipeline.GuardedDrawing
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.requireOpaque
import java.io.IOException

/**
 * Scan-converts each primitive as it arrives, and suspends the colours until the end.
 *
 * The memory of suspensions is accounted for. A primitive that is visible somewhere so far holds a record with the
 * runs of samples at which it was visible when it was drawn. If primitives arrive as a stream, the primitive itself is
 * kept as well (see [dev.lazyz.Primitive.heldBytes]). The record is freed when the primitive's last sample is covered
 * by a nearer primitive. Before these bytes would exceed [RenderOptions.memoryBudget], all suspended colours are
 * computed, which frees their records; after that, colours are suspended again. A primitive whose record does not fit
 * into the budget alone is shaded as it is drawn. Any budget, including 0, therefore gives the same picture; with less
 * memory, more shaded samples are covered later. The number of extra shading calls is [Counters.shadingCalls] minus
 * the number of visible samples.
 *
 * Use it when primitives arrive one by one and shading is expensive, and to keep the memory of a rendering within a
 * known limit.
 *
 * Memory: 12 bytes a sample, and suspensions within the budget; in addition, only the current primitive and objects of
 * constant size. Time: proportional to the number of fragments. Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995): the hybrid algorithm (eager spine,
 * lazy elements), and the desperate evaluator, which forces suspensions to reclaim memory.
 */
public class Hybrid @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) :
    StreamingRenderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "hybrid"

    override val summary: String get() = "draws at once and shades at the end, or earlier to keep to a memory budget"

    /** With a memory budget, shading may happen early, so [Capability.SHADES_ONLY_VISIBLE] holds only without one. */
    override val capabilities: Set<Capability>
        get() = if (options.memoryBudget == null) ALWAYS + Capability.SHADES_ONLY_VISIBLE else ALWAYS

    override fun configured(options: RenderOptions): Hybrid = Hybrid(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val cost = if (frame.isStreamed) PrimitiveCost.HELD else PrimitiveCost.NONE
        val samples = SuspendedSamples(frame, options, cost)
        frame.forEachPrimitive(Checkpoint.CALLER) { _, primitive -> samples.draw(primitive) }
        return samples.finish(sink)
    }

    /** Begins an image. A primitive is kept only as long as a suspended colour needs it. */
    override fun begin(raster: Raster, region: Region): Drawing {
        val samples = SuspendedSamples(Frame(raster, emptyList(), region), options, PrimitiveCost.HELD)
        return GuardedDrawing(this, samples::draw, samples::finish)
    }

    override fun toString(): String = "Hybrid($options)"

    private companion object {
        val ALWAYS: Set<Capability> =
            setOf(Capability.STREAMS_PRIMITIVES, Capability.MEMORY_BUDGET, Capability.COHERENCE)
    }
}
