package dev.lazyz.conformance.rules

import dev.lazyz.Coherence
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.probes.leavesNothingBehind
import net.jqwik.api.Property

/** The rule about what a rendering leaves behind. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface TidyRules : RulesForOne {
    /** A rendering leaves no output, no thread, no file and no changed global state. */
    @Rule(
        intent = "A library is a guest in the process of its caller, and leaves nothing behind there.",
        look = "Look for print statements, for executors that nobody shuts down, for temporary files and for settings.",
    )
    @Property(tries = 1)
    public fun rule_7_9_renderingsLeaveNothingBehind() {
        val renderer = renderer()
        leavesNothingBehind(renderer)

        // Where there is no room for anything, renderers do something else
        leavesNothingBehind(renderer.configured(RenderOptions(Coherence.ADAPTIVE, 0L, threads = 2, tileSize = 8)))
    }
}
