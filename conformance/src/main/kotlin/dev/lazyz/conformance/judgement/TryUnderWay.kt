package dev.lazyz.conformance.judgement

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase

/** The try of a rule that is under way, as what renders for the rule knows it. */
internal interface TryUnderWay {
    /** Frames of the user's own. */
    val ownCases: List<FrameCase>

    /** A rule renders [case]; [how] says what is special about the renderer, or nothing. */
    fun saw(case: FrameCase, how: String = "")

    /**
     * Whether this try has asked [renderer] for a picture before. Of several threads that ask at the same time none does so
     * again, whichever is first.
     */
    fun isAgain(renderer: Renderer): Boolean

    /** Another rendering begins: each has its deadline. */
    fun goesOn()

    companion object {
        /** Null between rules. There is one at a time in a JVM. */
        @Volatile
        var current: TryUnderWay? = null
    }
}
