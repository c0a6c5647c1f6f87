package dev.lazyz.conformance

import net.jqwik.api.Property

/** The rule about what a rendering leaves behind. Part of [RendererConformance]. */
@Suppress("ktlint:standard:function-naming")
public sealed class TidyRules : PromiseRules() {
    /** A rendering leaves no output, no thread, no file and no changed global state. */
    @Rule(
        intent = "A library is a guest in the process of its caller, and leaves nothing behind there.",
        look = "Look for print statements, for executors that nobody shuts down, for temporary files and for settings.",
    )
    @Property(tries = 1)
    public fun rule_7_9_renderingsLeaveNothingBehind() {
        leavesNothingBehind(renderer())
    }
}
