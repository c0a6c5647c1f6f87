package dev.lazyz.conformance.rules

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase

/** The suite's default seed. Each rule's own seed is computed from this seed and the rule's name. */
internal const val FIXED: String = "1995"

/** A part of the suite's rules for one renderer. [AllRules] combines all parts. */
public sealed interface RulesForOne {
    /**
     * Returns the renderer to test: either a new instance or always the same one. Called once for each try of each
     * rule.
     */
    public fun renderer(): Renderer

    /** Returns the user's own frames, in addition to those of the suite. */
    public fun frames(): List<FrameCase>
}
