package dev.lazyz.conformance.results

import dev.lazyz.Image
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.casesAmong
import dev.lazyz.conformance.census.Distribution
import dev.lazyz.conformance.judgement.ProcessEnded
import dev.lazyz.conformance.judgement.TimedOut
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.crash
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.rules.Symptom

/** The outcome of a rule. */
public enum class RuleOutcome(internal val words: String) {
    /** No try broke the rule. */
    PASSED("passed"),

    /** The renderer breaks the rule: a wrong result, or an exception. */
    FAILED("failed"),

    /** The renderer threw an [Error], or ended the process, during the rule: a failure. */
    CRASHED("crashed"),

    /** A rendering did not end within its processor time, or all its threads waited for as long: a failure. */
    TIMED_OUT("timed out"),

    /**
     * The machine was so busy that a rendering did not get the processor time of its deadline, so it is not known
     * whether it is too slow; or the rule was not run, because this happened to others. Neither a failure nor a proof.
     */
    INCONCLUSIVE("inconclusive"),

    /** The renderer broke the rule, but not when the same frame was rendered again: a failure. */
    FLAKY("flaky"),

    /** The rule was not run, because too many others timed out or ended the process: a failure. */
    NOT_RUN("not run"),

    /** The renderer breaks a rule of level SHOULD: reported, but not a failure. */
    NOT_FOLLOWED("not followed"),

    /** The renderer breaks the rule, but a waiver allows it. */
    WAIVED("waived"),

    /**
     * A waiver allows the renderer to break the rule, but the rule passes: a failure, because the waiver must be
     * deleted.
     */
    WAIVED_BUT_PASSES("waived but passes"),

    /** The waiver has expired: a failure, whether the rule is broken or not. */
    WAIVER_EXPIRED("waiver expired"),

    /** The rule applies only to renderers with a capability that this one does not declare. */
    NOT_SUPPORTED("not supported"),
    ;

    /** Whether a renderer with this outcome does not conform. */
    public val isFailure: Boolean get() = when (this) {
        PASSED, INCONCLUSIVE, NOT_FOLLOWED, WAIVED, NOT_SUPPORTED -> false
        FAILED, CRASHED, TIMED_OUT, FLAKY, NOT_RUN, WAIVED_BUT_PASSES, WAIVER_EXPIRED -> true
    }

    /** Whether the renderer broke the rule, whatever the rule's level. */
    internal val isBroken: Boolean get() = when (this) {
        FAILED, CRASHED, TIMED_OUT, FLAKY, NOT_FOLLOWED -> true
        PASSED, INCONCLUSIVE, NOT_RUN, WAIVED, WAIVED_BUT_PASSES, WAIVER_EXPIRED, NOT_SUPPORTED -> false
    }

    /** Whether reports describe it in detail. */
    internal val isDetailed: Boolean get() = isFailure || this == NOT_FOLLOWED || this == INCONCLUSIVE
}

/**
 * The result of one rule. Immutable and thread safe.
 *
 * @property rule the rule
 * @property outcome its outcome
 * @property message why it failed, is inconclusive, is not followed, is waived, was not run or is not supported; empty
 *   if it passed. For a program, how many pictures are right, too
 * @property tries number of tries, without those that shrink a frame after a failure
 * @property milliseconds duration of the rule
 * @property distribution traits of the frames
 * @property failure how the renderer breaks the rule, even if it is waived; null if it does not
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
    /** Where to look in the renderer, in one sentence; empty if not known. */
    internal val look: String get() = when (outcome) {
        RuleOutcome.TIMED_OUT -> when {
            failure?.cause is Violation -> rule.look
            (failure?.cause as? TimedOut)?.isAsleep == true -> WHERE_IT_WAITS
            else -> WHERE_IT_LOOPS
        }

        RuleOutcome.INCONCLUSIVE -> WHAT_TO_DO
        else -> failure?.let { crashLook(it.cause) } ?: rule.look
    }

    override fun toString(): String = "$rule: ${outcome.words}"

    internal companion object {
        private const val WHERE_IT_LOOPS =
            "The stack in the message says where it is: look for a loop that does not end, or that takes very long."
        private const val WHERE_IT_WAITS =
            "The stack in the message says where it is: look for a thread that waits for what never comes."
        private const val WHAT_TO_DO = "Run it again while the machine has less other work, or with a longer " +
            "deadline (zcli: --deadline SECONDS; as a test: -Dlazyz.conformance.deadline=SECONDS)."

        /** Where to look if the renderer crashed or threw; null if it did not. */
        fun crashLook(thrown: Throwable): String? = when {
            thrown is ProcessEnded -> "Look for System.exit, Runtime.halt, and native code that crashes."

            crash(thrown) is OutOfMemoryError ->
                "Look for arrays that are sized by the whole raster, by bounds or by the number of primitives, and " +
                    "for lists that only grow."

            crash(thrown) is StackOverflowError ->
                "Look for recursion whose depth is the number of primitives, fragments or samples: make it a loop, " +
                    "or halve the rest in each call."

            crash(thrown) != null -> "Look where the error is thrown."

            thrown is Exception || (thrown as? Violation)?.cause is Exception -> "Look where the exception is thrown."

            else -> null
        }
    }
}

/**
 * How a renderer breaks a rule, for the smallest failing frame that was found. Immutable and thread safe, if the images
 * are not modified.
 *
 * @property message description of the failure, with the frame
 * @property code the frame as a Kotlin expression, see [FrameCase.code]; null if the rule is not about a frame
 * @property expected the correct picture; null if there is none to show
 * @property actual the renderer's picture, of the same region; null if there is none to show
 * @property cause the exception
 * @property before the last few frames that were rendered before, if the failure is not reproducible; otherwise empty
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
    /** The symptoms that the failure showed both before and after shrinking; null if they cannot be determined. */
    internal val symptoms: Set<Symptom>? by lazy {
        val last = Symptoms.of(cause)
        val before = first?.takeIf { it !== cause }?.let { Symptoms.of(it) }
        if (before == null || last == null) last else last intersect before
    }

    /** What the renderer does, if it crashes: a verb and its object. */
    internal val crash: String? get() = when {
        cause is ProcessEnded -> "ends the process"
        else -> crash(cause)?.let { "throws ${it.javaClass.name}" }
    }

    /** Whether the message says the whole cause. */
    internal val isPlain: Boolean get() = (cause as? Violation)?.isPlain == true

    /** The frame as the text of a scene file, see [FrameCase.sceneFile]; null if that format cannot express it. */
    public val sceneFile: String? get() = case?.sceneFile()

    /** The first sample that differs, in rows from the top; null if none differs or there is nothing to compare. */
    public val sample: DifferingSample? = if (expected == null || actual == null) {
        null
    } else {
        difference(expected, actual)?.let { DifferingSample(it.x, it.y, it.expectedAnswer, it.actualAnswer, it.count) }
    }

    override fun toString(): String = message

    internal companion object {
        /** Number of frames that are kept from before a failure that is not reproducible. */
        const val MOST_BEFORE: Int = 5

        /**
         * Describes the exception [thrown] when a rule was tried with [parameters]. [first] is the exception before
         * shrinking, if known, and [before] are frames that were rendered earlier.
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
 * @property expected the correct colour, depth and primitive, in words
 * @property actual the actual colour, depth and primitive, in words
 * @property count number of samples of the picture that differ
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

/** Receives the outcome of each rule as soon as the rule has ended, from `Conformance` or `Supervision`. */
public fun interface RuleListener {
    /**
     * Called when [rule] has ended. Called once for each rule, in the thread that runs or supervises the suite. Must
     * not throw.
     *
     * @param milliseconds duration of the rule
     */
    public fun ended(rule: SuiteRule, outcome: RuleOutcome, milliseconds: Long)
}
