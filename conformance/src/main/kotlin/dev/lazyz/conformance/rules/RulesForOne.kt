package dev.lazyz.conformance.rules

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase

/** The suite's seed, unless a run names another; each rule's own seed is made of it and of the rule's name. */
internal const val FIXED: String = "1995"

/** A part of the suite's rules, and the one renderer that they are about. All parts together are [AllRules]. */
public sealed interface RulesForOne {
    /** Returns the renderer to judge, a new one or always the same. Called once for each try of each rule. */
    public fun renderer(): Renderer

    /** Returns frames of the user's own, besides those of the suite. */
    public fun frames(): List<FrameCase>
}
