package dev.lazyz.conformance.judgement

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase

/** The current try of a rule, as seen by the code that renders for the rule. */
internal interface TryUnderWay {
    /** The user's own frames. */
    val ownCases: List<FrameCase>

    /** The name of a setting of the process that has changed since the run began; null if there is none. */
    val settingChanged: String?

    /**
     * Called before a rule renders [case]. [how] describes how the renderer differs from the default; empty if it does
     * not.
     */
    fun saw(case: FrameCase, how: String = "")

    /**
     * Returns whether this try has already used [renderer]. Always false in threads other than the try's own, because
     * there the order is not defined.
     */
    fun isAgain(renderer: Renderer): Boolean

    /** Called when another rendering begins: each has its own deadline. */
    fun goesOn()

    companion object {
        /** The current try; null between rules. There is one at a time in a JVM. */
        @Volatile
        var current: TryUnderWay? = null
    }
}
