package dev.lazyz.conformance.results

import dev.lazyz.Image
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.casesAmong
import dev.lazyz.conformance.census.Distribution
import dev.lazyz.conformance.judgement.TimedOut
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.rules.Symptom

/** What came of a rule. */
public enum class RuleOutcome(internal val words: String) {
    /** The renderer keeps the rule, as far as it was tried. */
    PASSED("passed"),

    /** The renderer breaks the rule: a wrong answer, or an exception. */
    FAILED("failed"),

    /** The renderer threw an [Error], or ended the process, while the rule was tried: a failure. */
    CRASHED("crashed"),

    /** A try of the rule was not over at its deadline: a failure. */
    TIMED_OUT("timed out"),

    /** The renderer broke the rule, and did not when it was tried on the same frame again: a failure. */
    FLAKY("flaky"),

    /** The rule was not tried, since too many others had timed out or the process was ended: a failure. */
    NOT_RUN("not run"),

    /** The renderer does not do what it SHOULD: reported, but no failure. */
    NOT_FOLLOWED("not followed"),

    /** The renderer breaks the rule, which a waiver allows. */
    WAIVED("waived"),

    /** A waiver allows the renderer to break the rule, which it does not: a failure, as the waiver must go. */
    WAIVED_BUT_PASSES("waived but passes"),

    /** A waiver's day has passed: a failure, whether the rule is broken or not. */
    WAIVER_EXPIRED("waiver expired"),

    /** The rule is for renderers with a capability that this one does not declare. */
    NOT_SUPPORTED("not supported"),
    ;

    /** Whether a renderer with this outcome does not conform. */
    public val isFailure: Boolean get() = when (this) {
        PASSED, NOT_FOLLOWED, WAIVED, NOT_SUPPORTED -> false
        FAILED, CRASHED, TIMED_OUT, FLAKY, NOT_RUN, WAIVED_BUT_PASSES, WAIVER_EXPIRED -> true
    }

    /** Whether the renderer broke the rule, whatever its level. */
    internal val isBroken: Boolean get() = when (this) {
        FAILED, CRASHED, TIMED_OUT, FLAKY, NOT_FOLLOWED -> true
        PASSED, NOT_RUN, WAIVED, WAIVED_BUT_PASSES, WAIVER_EXPIRED, NOT_SUPPORTED -> false
    }

    /** Whether reports tell it at length. */
    internal val isTold: Boolean get() = isFailure || this == NOT_FOLLOWED
}

/**
 * What came of one rule. Immutable and thread safe.
 *
 * @property rule the rule
 * @property outcome what came of it
 * @property message why it failed, is not followed, is waived, was not run or is not supported; empty if it passed
 * @property tries how often it was tried, frames that were made smaller after a failure not included
 * @property milliseconds how long that took
 * @property distribution what the frames were like
 * @property failure how the renderer breaks the rule, be it waived or not; null if it does not
 */
public class RuleResult internal constructor(
    public val rule: SuiteRule,
    public val outcome: RuleOutcome,
    public val message: String,
    public val tries: Int,
    public val milliseconds: Long,
    public val distribution: Distribution,
    public val failure: RuleFailure?,
) {
    override fun toString(): String = "$rule: ${outcome.words}"
}

/**
 * How a renderer breaks a rule, on the smallest frame that was found. Immutable and thread safe, if the pictures are
 * left alone.
 *
 * @property message what is wrong, in words, with the frame
 * @property code the frame as a Kotlin expression, see [FrameCase.code]; null if the rule is not about a frame
 * @property expected the right picture; null if there is none to show
 * @property actual the renderer's picture, of the same region; null if there is none to show
 * @property cause what was thrown
 * @property before what was rendered before it, the last few frames, if the failure is not reproducible; else empty
 */
public class RuleFailure private constructor(
    public val message: String,
    public val code: String?,
    public val expected: Image?,
    public val actual: Image?,
    public val cause: Throwable,
    internal val case: FrameCase?,
    private val first: Throwable?,
    public val before: List<FrameCase>,
) {
    /** What it looks like, before and after the frame was made smaller; null if it does not tell enough to say. */
    internal val symptoms: Set<Symptom>? by lazy {
        val last = Symptoms.of(cause)
        val before = first?.takeIf { it !== cause }?.let { Symptoms.of(it) }
        if (before == null || last == null) last else last intersect before
    }

    /** The frame as the text of a scene file, see [FrameCase.sceneFile]; null if there are no words for it. */
    public val sceneFile: String? get() = case?.sceneFile()

    /** The first sample that differs, in rows from the top; null if none does or there is nothing to compare. */
    public val sample: DifferingSample? = if (expected == null || actual == null) {
        null
    } else {
        difference(expected, actual)?.let { DifferingSample(it.x, it.y, it.expectedAnswer, it.actualAnswer, it.count) }
    }

    override fun toString(): String = message

    internal companion object {
        /** How many frames before a failure that is not reproducible are kept. */
        const val MOST_BEFORE: Int = 5

        /**
         * Tells of what was [thrown] when a rule was tried with [parameters], and what at [first], if that is known.
         * [before] are frames that were rendered before.
         */
        fun of(
            thrown: Throwable,
            parameters: List<Any?>,
            first: Throwable? = null,
            before: List<FrameCase> = emptyList(),
        ): RuleFailure {
            val violation = thrown as? Violation
            val case = violation?.case ?: (thrown as? TimedOut)?.case ?: casesAmong(parameters).firstOrNull()
            return RuleFailure(
                thrown.message ?: thrown.toString(),
                case?.code,
                violation?.expected,
                violation?.actual,
                thrown,
                case,
                first,
                before,
            )
        }
    }
}

/**
 * A sample at which a picture is wrong. Immutable and thread safe.
 *
 * @property x column of the raster
 * @property y row of the raster
 * @property expected what it should show, in words: colour, depth and primitive
 * @property actual what it shows, in words
 * @property count how many samples of the picture differ
 */
public class DifferingSample internal constructor(
    public val x: Int,
    public val y: Int,
    public val expected: String,
    public val actual: String,
    public val count: Int,
) {
    override fun toString(): String = "($x, $y): expected $expected, but was $actual"
}
