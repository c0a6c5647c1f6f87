package dev.lazyz

import dev.lazyz.spi.ShadingCursor
import java.util.concurrent.Executor
import java.util.function.IntConsumer

/**
 * Options of a rendering. Except for [selector], they change its cost and never its image. Immutable.
 *
 * A renderer supports those options whose [Capability] it has, and refuses the others, see [Renderer.configured].
 * [threads] and [tileSize] are accepted by every renderer: one thread is not more than permitted, and a renderer
 * without tiles has none to size.
 *
 * @property coherence how deferred shading steps attributes between samples
 * @property memoryBudget maximum working memory in bytes, in addition to the image; null for no limit
 * @property threads number of threads that share the work, at least 1; 1 is the calling thread alone. With more, the
 *   next stage of the work may begin while the last one ends, so that for moments up to twice as many are busy
 * @property tileSize width and height of tiles in samples, a power of two in 8..512; for renderers that have tiles.
 *   Tiles in which samples become pixels, see [Renderer.renderPixels], are twice as wide and high, from 64 on
 * @property selector chooses what each sample shows, for renderers with [Capability.SELECTION]. With null, a sample
 *   shows its visible fragment, or all fragments blended if the frame has translucent primitives
 * @property executor runs the threads other than the calling one; null for threads of the library. Renderers do not
 *   wait for the executor to begin a task: if it is busy, the calling thread does the work
 * @property bandBytes most bytes of the rows that `TiledRenderer` and `HierarchicalRenderer` keep of a streamed frame,
 *   at 12 a sample, but at least one row: a larger picture is rendered in bands, with a pass over the primitives for
 *   each. Null for a third of the heap
 * @throws IllegalArgumentException if a number is out of range
 */
public class RenderOptions @JvmOverloads constructor(
    public val coherence: Coherence = Coherence.DIRECT,
    public val memoryBudget: Long? = null,
    public val threads: Int = Runtime.getRuntime().availableProcessors(),
    public val tileSize: Int = 64,
    public val selector: Selector? = null,
    public val executor: Executor? = null,
    public val bandBytes: Long? = null,
) {
    internal val workers: Workers get() = Workers(threads, executor ?: LibraryThreads)

    init {
        require(memoryBudget == null || memoryBudget >= 0) { "memoryBudget must not be negative: $memoryBudget" }
        require(bandBytes == null || bandBytes >= 0) { "bandBytes must not be negative: $bandBytes" }
        require(threads >= 1) { "threads must be at least 1: $threads" }
        require(tileSize in 8..512 && tileSize.countOneBits() == 1) {
            "tileSize must be a power of two in 8..512: $tileSize"
        }
    }

    /**
     * Calls [action] for each number in 0 until [count], for a renderer that works in parallel: on the calling thread,
     * and on others that [executor] has free, at most [threads] in all. Returns when all calls have ended. If one
     * throws, those that have not begun are skipped, and the first exception is thrown.
     *
     * @throws InterruptedException if the calling thread is interrupted
     */
    @Throws(InterruptedException::class)
    public fun inParallel(count: Int, action: IntConsumer): Unit =
        workers.forEach(count, Checkpoint.CALLER) { number, _ -> action.accept(number) }

    /** The capabilities that a renderer must have to support these options. */
    public val needs: Set<Capability>
        get() = setOfNotNull(
            Capability.MEMORY_BUDGET.takeIf { memoryBudget != null },
            Capability.COHERENCE.takeIf { coherence != Coherence.DIRECT },
            Capability.SELECTION.takeIf { selector != null },
        )

    /**
     * Returns these options, for a renderer that is being configured with them.
     *
     * @throws IllegalArgumentException if [renderer] lacks one of the capabilities that they need
     */
    public fun requireSupportedBy(renderer: Renderer): RenderOptions = apply {
        val missing = needs - renderer.capabilities
        require(missing.isEmpty()) {
            "'${renderer.id}' does not support ${missing.joinToString(" and ") { optionOf(it) }}: leave it out, or " +
                "use a renderer with ${missing.joinToString(" and ")}"
        }
    }

    /** Returns those of these options that [renderer] supports; the others have their default. */
    public fun supportedBy(renderer: Renderer): RenderOptions {
        val missing = needs - renderer.capabilities
        return copy(
            coherence = if (Capability.COHERENCE in missing) Coherence.DIRECT else coherence,
            memoryBudget = if (Capability.MEMORY_BUDGET in missing) null else memoryBudget,
            selector = if (Capability.SELECTION in missing) null else selector,
        )
    }

    private fun optionOf(need: Capability): String = when (need) {
        Capability.MEMORY_BUDGET -> "a memory budget"
        Capability.COHERENCE -> "$coherence coherence"
        else -> "a selector"
    }

    /** Returns these options with another way to step attributes. */
    public fun withCoherence(coherence: Coherence): RenderOptions = copy(coherence = coherence)

    /** Returns these options with a budget of memory in bytes, at least 0. */
    public fun withMemoryBudget(memoryBudget: Long): RenderOptions = copy(memoryBudget = memoryBudget)

    /** Returns these options without a budget of memory. */
    public fun withoutMemoryBudget(): RenderOptions = copy(memoryBudget = null)

    /** Returns these options with another number of threads, at least 1. */
    public fun withThreads(threads: Int): RenderOptions = copy(threads = threads)

    /** Returns these options with other tiles: samples, a power of two in 8..512. */
    public fun withTileSize(tileSize: Int): RenderOptions = copy(tileSize = tileSize)

    /** Returns these options with a [selector], or without one. */
    public fun withSelector(selector: Selector?): RenderOptions = copy(selector = selector)

    /** Returns these options with an [executor] for the threads, or with the library's own threads. */
    public fun withExecutor(executor: Executor?): RenderOptions = copy(executor = executor)

    /** Returns these options with another limit for the bands of a streamed frame, in bytes, at least 0. */
    public fun withBandBytes(bandBytes: Long): RenderOptions = copy(bandBytes = bandBytes)

    /** Returns these options with the default limit for the bands of a streamed frame, a third of the heap. */
    public fun withDefaultBandBytes(): RenderOptions = copy(bandBytes = null)

    private fun copy(
        coherence: Coherence = this.coherence,
        memoryBudget: Long? = this.memoryBudget,
        threads: Int = this.threads,
        tileSize: Int = this.tileSize,
        selector: Selector? = this.selector,
        executor: Executor? = this.executor,
        bandBytes: Long? = this.bandBytes,
    ): RenderOptions = RenderOptions(coherence, memoryBudget, threads, tileSize, selector, executor, bandBytes)

    override fun toString(): String =
        "RenderOptions($coherence, memoryBudget=$memoryBudget, threads=$threads, tileSize=$tileSize, " +
            "selector=$selector, executor=$executor, bandBytes=$bandBytes)"

    /**
     * How deferred shading steps attributes between samples. All modes give the same colours, bit for bit (see
     * [ShadingCursor]).
     */
    public enum class Coherence {
        /** The attributes of each sample are evaluated directly. */
        DIRECT,

        /** The attributes are stepped from the last visible sample of the same primitive on the row. */
        INCREMENTAL,

        /** A cost model chooses between the two for each primitive and gap (see [Primitive.shadingStartCost]). */
        ADAPTIVE,
    }
}
