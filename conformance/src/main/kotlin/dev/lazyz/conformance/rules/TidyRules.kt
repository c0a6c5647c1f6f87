package dev.lazyz.conformance.rules

import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.conformance.probes.leavesNothingBehind
import dev.lazyz.conformance.probes.memory.leavesNoObjects
import dev.lazyz.conformance.probes.memory.leavesNoSizes
import net.jqwik.api.Property

/** Rules about side effects of a rendering. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface TidyRules : RulesForOne {
    /** A rendering leaves no output, no thread, no file and no changed global state. */
    @Rule(
        intent = "A library runs in its caller's process, and leaves nothing behind there.",
        look = "Look for print statements, executors that are never shut down, temporary files and global settings.",
    )
    @Property(tries = 1)
    public fun rule_7_9_renderingsLeaveNothingBehind() {
        leavesNothingBehind { renderer() }
        for (options in VARIED) leavesNothingBehind { renderer().let { it.configured(options.supportedBy(it)) } }
    }

    /** However often a renderer renders, and pictures of however many sizes, it holds no more memory. */
    @Rule(
        intent = "A renderer may be used a million times in a process, so not even a few bytes may remain each time.",
        look = "Look for static collections, listeners, shutdown hooks and caches to which each rendering adds, " +
            "and for pools of arrays by their length.",
    )
    @Property(tries = 1)
    public fun rule_7_9_renderingsHoldNoMoreMemory() {
        val renderer = renderer()
        for (options in VARIED) leavesNoObjects(renderer, options.supportedBy(renderer))
        leavesNoSizes(renderer, VARIED.first().supportedBy(renderer))
    }

    private companion object {
        /** With several threads; and without any memory budget, where renderers take other code paths. */
        val VARIED = listOf(
            RenderOptions(threads = 2, tileSize = 8),
            RenderOptions(Coherence.ADAPTIVE, 0L, threads = 2, tileSize = 8),
        )
    }
}
