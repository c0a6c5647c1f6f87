package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.strategies.flow.FlowPipeline
import dev.lazyz.strategies.hierarchical.HierarchicalZBuffer
import dev.lazyz.strategies.hybrid.Hybrid
import dev.lazyz.strategies.lazy.LazyZBuffer
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.painter.Painter
import dev.lazyz.strategies.scanline.ScanLine
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.strategies.warnock.Warnock
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.util.ServiceLoader

/**
 * The renderers there are: the one list that the command line, the conformance suite and the benchmarks read.
 *
 * Use it where a user chooses by name; code that knows what it wants constructs the class itself. To add one of one's
 * own, put its class name into `META-INF/services/dev.lazyz.Renderer` and the jar on the class path. Thread safe.
 */
public object Renderers {
    /**
     * The renderers of this library, in the order in which they are listed; one line each. Where nobody chooses, the first
     * that can do what is asked for is taken.
     */
    @JvmStatic
    public val builtIn: List<Renderer> = listOf(
        Tiled(),
        ZBuffer(),
        LazyZBuffer(),
        FlowPipeline(),
        Hybrid(),
        Lists(),
        ScanLine(),
        Painter(),
        Warnock(),
        HierarchicalZBuffer(),
    )

    /**
     * Returns the built-in renderers, and behind them those that third parties offer through [ServiceLoader], in the
     * order of the class path as the current thread's context class loader sees it.
     *
     * @throws IllegalStateException if two renderers have the same id; the message names both classes
     * @throws java.util.ServiceConfigurationError if a third party's renderer cannot be loaded
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
     * Returns the renderer with the given [id], or null if there is none. Fails as [all] does, so that what a name
     * means does not depend on the order of a class path.
     */
    @JvmStatic
    public fun find(id: String): Renderer? = all().firstOrNull { it.id == id }

    /**
     * Estimates what each renderer of [all] takes for [frame], and which of them can render it as asked.
     *
     * A renderer is ruled out if it lacks one of [needs], or what the frame or [options] need: transparency, a memory budget, a
     * selector; or if the model expects it to hold more than [memory] bytes. Cost: see [FrameNumbers.of].
     *
     * @throws IllegalStateException as [all]
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
     * Returns a renderer that can render [frame] as asked, configured with [options]: the first of [all] that can, unless
     * [StrategyModel] expects another to be much faster, see [StrategyEstimates.best]. Renderers that were never measured are
     * taken only where no other can.
     *
     * @throws IllegalArgumentException if every renderer is ruled out; the message says why
     * @throws IllegalStateException as [all]
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
}
