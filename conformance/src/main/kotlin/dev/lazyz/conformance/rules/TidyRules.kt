package dev.lazyz.conformance.rules

import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.probes.leavesNothingBehind
import net.jqwik.api.Property

/** The rule about side effects of a rendering. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface TidyRules : RulesForOne {
    /** A rendering leaves no output, no thread, no file and no changed global state. */
    @Rule(
        intent = "A library runs in its caller's process, and leaves nothing behind there.",
        look = "Look for print statements, executors that are never shut down, temporary files and global settings.",
    )
    @Property(tries = 1)
    public fun rule_7_9_renderingsLeaveNothingBehind() {
        val renderer = renderer()
        leavesNothingBehind(renderer)

        // Without any memory budget, renderers take other code paths
        val options = RenderOptions(Coherence.ADAPTIVE, 0L, threads = 2, tileSize = 8)
        leavesNothingBehind(renderer.configured(options.supportedBy(renderer)))
    }
}
