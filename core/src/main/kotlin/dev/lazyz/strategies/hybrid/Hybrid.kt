package dev.lazyz.strategies.hybrid

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.requireOpaque
import kotlinx.coroutines.flow.Flow

/**
 * Eager spine, lazy elements: scan-converts each primitive as it arrives, and suspends the colours to the end.
 *
 * What a suspension costs is counted: a primitive that is visible somewhere, so far, holds a record with the runs of
 * samples at which it was visible when it was drawn, and, if primitives arrive as a stream, the primitive itself is kept
 * (see [Primitive.heldBytes]). The record goes when the primitive's last sample is covered by something nearer. Before
 * these bytes would exceed [RenderOptions.memoryBudget], all suspensions are forced, which frees them, and laziness
 * resumes; a primitive whose record does not fit at all is shaded as it is drawn. So any budget, 0 too, gives the same
 * picture: with less memory, more of what is shaded is covered later. The extra shading calls are
 * [Counters.shadingCalls] less the visible samples.
 *
 * Use it when primitives arrive one by one and shading is expensive, and to hold a picture's cost within known memory.
 *
 * Memory: 12 bytes a sample, and suspensions within the budget; besides, only the primitive in hand and objects of
 * constant size. Time: proportional to the fragments. Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995): the hybrid algorithm, and the
 * desperate evaluator that forces suspensions to get memory back.
 */
public class Hybrid @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "hybrid"

    override val summary: String get() = "draws at once and shades at the end, or earlier to keep to a memory budget"

    /** Shades only what is visible unless a memory budget may force it to shade early. */
    override val capabilities: Set<Capability>
        get() = if (options.memoryBudget == null) ALWAYS + Capability.SHADES_ONLY_VISIBLE else ALWAYS

    override fun configured(options: RenderOptions): Renderer = Hybrid(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val samples = SuspendedSamples(frame, options, PrimitiveCost.NONE)
        for (primitive in frame.primitives) samples.draw(primitive)
        return samples.finish(sink)
    }

    /**
     * Renders primitives as they arrive. The order of arrival is the order of submission. A primitive is kept only as
     * long as a suspended colour needs it.
     *
     * Cancellable between primitives. An exception of the flow ends the rendering; no row has been handed out then.
     *
     * @throws IllegalArgumentException if a primitive is translucent
     * @throws IllegalStateException if more than 2^31-2 primitives arrive
     */
    public suspend fun render(raster: Raster, primitives: Flow<Primitive>, sink: RowSink): Counters {
        val samples = SuspendedSamples(Frame(raster, emptyList()), options, PrimitiveCost.HELD)
        var index = 0
        primitives.collect {
            requireOpaque(it, index++, this)
            samples.draw(it)
        }
        return samples.finish(sink)
    }

    override fun toString(): String = "Hybrid($options)"

    private companion object {
        val ALWAYS: Set<Capability> =
            setOf(Capability.STREAMS_PRIMITIVES, Capability.MEMORY_BUDGET, Capability.COHERENCE)
    }
}
