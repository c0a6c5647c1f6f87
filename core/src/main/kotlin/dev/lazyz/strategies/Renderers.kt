package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.strategies.bsp.BspRenderer
import dev.lazyz.strategies.flow.FlowRenderer
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.lazy.LazyRenderer
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.painter.PainterRenderer
import dev.lazyz.strategies.raycast.RaycastRenderer
import dev.lazyz.strategies.scanline.ScanlineRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.warnock.WarnockRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.util.ServiceLoader

/**
 * The available renderers. The command line, the conformance suite and the benchmarks all read this list.
 *
 * Use it where a user chooses a renderer by name; code that needs a particular renderer constructs its class directly.
 * To add a custom renderer, put its class name into `META-INF/services/dev.lazyz.Renderer` and its jar on the class
 * path. Thread safe.
 */
public object Renderers {
    /**
     * The renderers of this library, in the order in which they are listed. If the user does not choose one, the first
     * renderer that supports the request is used.
     */
    @JvmStatic
    public val builtIn: List<Renderer> = listOf(
        TiledRenderer(),
        ZBufferRenderer(),
        HybridRenderer(),
        LazyRenderer(),
        FlowRenderer(),
        ListsRenderer(),
        ScanlineRenderer(),
        PainterRenderer(),
        WarnockRenderer(),
        HierarchicalRenderer(),
        RaycastRenderer(),
        BspRenderer(),
    )

    /**
     * Returns the built-in renderers, followed by third-party renderers found through [ServiceLoader]. Third-party
     * renderers are in the order of the class path as seen by the current thread's context class loader.
     *
     * @throws IllegalStateException if two renderers have the same id; the message names both classes
     * @throws java.util.ServiceConfigurationError if a third-party renderer cannot be loaded
     */
    @JvmStatic
    public fun all(): List<Renderer> {
        val all = builtIn + ServiceLoader.load(Renderer::class.java)
        val byId = HashMap<String, Renderer>()
        for (renderer in all) {
            val other = byId.put(renderer.id, renderer) ?: continue
            error(
                "two renderers have the id '${renderer.id}': ${other.javaClass.name} and ${renderer.javaClass.name}; " +
                    "take one of them off the class path",
            )
        }
        return all
    }

    /**
     * Returns the renderer with the given [id], or null if there is none. Fails in the same cases as [all], so that the
     * meaning of a name does not depend on the order of the class path.
     */
    @JvmStatic
    public fun find(id: String): Renderer? = all().firstOrNull { it.id == id }

    /**
     * Estimates the time and memory that each renderer of [all] needs for [frame], and determines which renderers can
     * render it as requested.
     *
     * A renderer is ruled out if it lacks one of [needs], or a capability that the frame or the [options] require
     * (transparency, a memory budget, a selector), or if the model expects it to hold more than [memory] bytes. Cost:
     * a look at about 1,000 primitives, and one pass over all of them for translucency.
     *
     * @throws IllegalStateException in the same cases as [all]
     */
    @JvmStatic
    @JvmOverloads
    public fun estimates(
        frame: Frame,
        options: RenderOptions = RenderOptions(),
        needs: Set<Capability> = emptySet(),
        memory: Long = Runtime.getRuntime().maxMemory(),
    ): StrategyEstimates = StrategyEstimates.of(all(), frame, options, needs, memory)

    /**
     * Returns a renderer that can render [frame] as requested, configured with [options]. This is the first suitable
     * renderer of [all], unless the cost model expects another to be much faster, see [StrategyEstimates.best]. A
     * renderer that was never measured is used only if no other is suitable.
     *
     * @throws IllegalArgumentException if every renderer is ruled out; the message gives the reasons
     * @throws IllegalStateException in the same cases as [all]
     */
    @JvmStatic
    @JvmOverloads
    public fun auto(
        frame: Frame,
        options: RenderOptions = RenderOptions(),
        needs: Set<Capability> = emptySet(),
        memory: Long = Runtime.getRuntime().maxMemory(),
    ): Renderer {
        val estimates = estimates(frame, options, needs, memory)
        return requireNotNull(estimates.best) { "no renderer can do this:\n${estimates.explain()}" }.renderer
    }

    /**
     * The expected time and memory of all renderers for a frame, see [Renderers.estimates]. Immutable.
     *
     * @property threads the requested number of threads
     * @property memory most bytes that a renderer may hold
     * @property all all renderers: first those that can be chosen, by ascending time, then those that can be chosen but
     *   were never measured, then those that are ruled out
     */
    public class StrategyEstimates private constructor(
        internal val numbers: FrameNumbers,
        public val threads: Int,
        public val memory: Long,
        public val all: List<StrategyEstimates.Estimate>,
        private val usual: StrategyEstimates.Estimate?,
    ) {
        /**
         * The renderer to choose, or null if all are ruled out. This is the first in the order of [Renderers.all] that
         * is not ruled out, unless the fastest is expected to be more than [MARGIN] times as fast; then it is the
         * fastest.
         */
        public val best: StrategyEstimates.Estimate?
            get() {
                if (usual == null) return null
                val fastest = all.first()
                return if (usual.milliseconds > MARGIN * fastest.milliseconds) fastest else usual
            }

        /**
         * Returns readable text: the frame's numbers, then a line for each renderer with time, memory and why it is
         * ruled out.
         */
        public fun explain(): String = buildString {
            val kind = if (numbers.isTranslucent) "some translucent" else "all opaque"
            append("frame: ${numbers.columns} x ${numbers.rows} samples, ${numbers.primitives} primitives, $kind; ")
            append("about %.2f fragments a sample, ".format(null, numbers.depthComplexity))
            append("%.1f rows a primitive\n".format(null, numbers.primitiveRows / maxOf(1, numbers.primitives)))
            append("threads: $threads; memory: ${mebibytes(memory.toDouble())}\n")
            for (estimate in all) {
                val time = if (estimate.milliseconds.isNaN()) "not measured" else time(estimate.milliseconds)
                val bytes = if (estimate.bytes.isNaN()) "" else mebibytes(estimate.bytes)
                val reason = estimate.ruledOut?.let { "  ruled out: $it" }.orEmpty()
                append("  %-13s %12s %12s%s\n".format(null, estimate.renderer.id, time, bytes, reason))
            }
        }

        override fun toString(): String = "StrategyEstimates(best=${best?.renderer?.id}, $numbers)"

        /**
         * The expected time and memory of one renderer for a frame. Immutable.
         *
         * @property renderer the renderer, configured with the requested options
         * @property milliseconds time of set-up and rendering in a warm JVM, or NaN if the renderer was never measured
         * @property bytes peak memory, excluding scene and picture, or NaN if the renderer was never measured
         * @property ruledOut why the renderer cannot be chosen, or null if it can
         */
        public class Estimate internal constructor(
            public val renderer: Renderer,
            public val milliseconds: Double,
            public val bytes: Double,
            public val ruledOut: String?,
        ) {
            override fun toString(): String =
                "Estimate(${renderer.id}, $milliseconds ms, $bytes bytes, ruledOut=$ruledOut)"
        }

        public companion object {
            /**
             * How many times as fast another renderer must be expected to be, for it to be chosen instead of the first
             * suitable one. Estimates are often wrong by less.
             */
            public const val MARGIN: Double = 1.5

            private const val MEBIBYTE = 1024.0 * 1024.0

            internal fun of(
                renderers: List<Renderer>,
                frame: Frame,
                options: RenderOptions,
                needs: Set<Capability>,
                memory: Long,
            ): StrategyEstimates {
                val numbers = FrameNumbers.of(frame)
                val implied = options.needs + setOfNotNull(Capability.TRANSPARENCY.takeIf { numbers.isTranslucent })
                val estimates = renderers.map {
                    estimate(it.configured(options.supportedBy(it)), numbers, options, needs + implied, memory)
                }
                val (possible, impossible) = estimates.partition { it.ruledOut == null }
                // Sorting is stable and puts NaN last
                val sorted = possible.sortedBy { it.milliseconds } + impossible
                return StrategyEstimates(numbers, options.threads, memory, sorted, possible.firstOrNull())
            }

            private fun estimate(
                renderer: Renderer,
                numbers: FrameNumbers,
                options: RenderOptions,
                needs: Set<Capability>,
                memory: Long,
            ): StrategyEstimates.Estimate {
                val missing = needs.sorted() - renderer.capabilities
                val bytes = StrategyMemory.expected(renderer.id, numbers, options.memoryBudget)
                val ruledOut = when {
                    missing.isNotEmpty() -> "lacks " + missing.joinToString { it.name.lowercase().replace('_', ' ') }
                    bytes > memory -> "needs about ${mebibytes(bytes)}"
                    else -> null
                }
                val time = StrategyModel.milliseconds(renderer.id, numbers, options.threads)
                return StrategyEstimates.Estimate(renderer, time, bytes, ruledOut)
            }

            /** Returns an amount of memory as text. */
            internal fun mebibytes(bytes: Double): String = "%.1f MiB".format(null, bytes / MEBIBYTE)

            private fun time(milliseconds: Double): String = "%.2f ms".format(null, milliseconds)
        }
    }
}
