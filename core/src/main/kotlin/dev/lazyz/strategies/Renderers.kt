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
}
