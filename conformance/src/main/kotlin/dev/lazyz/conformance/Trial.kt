package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.Renderer
import java.time.LocalDate
import java.util.Collections
import java.util.IdentityHashMap
import net.jqwik.api.lifecycle.PropertyExecutionResult
import net.jqwik.api.lifecycle.PropertyExecutionResult.Status

/** One rule on trial, from the first try to the verdict. */
internal class Trial(private val rule: SuiteRule, private val waiver: Waiver?) {
    private val census = Census()
    private val start = System.nanoTime()

    /** Why the rule does not apply, once that is known. */
    @Volatile
    var notDeclared: NotDeclared? = null

    /** What the first try that failed threw: what follows makes the frame smaller, and is no try. */
    @Volatile
    var firstFailure: Throwable? = null

    private val rendered = Collections.synchronizedSet(Collections.newSetFromMap(IdentityHashMap<Renderer, Boolean>()))

    /** Whether this try has asked [renderer] for a picture before. */
    fun isAgain(renderer: Renderer): Boolean = !rendered.add(renderer)

    /** A rule renders [frame]. */
    fun saw(frame: Frame) {
        if (firstFailure == null) census.add(frame)
    }

    /** The next try begins. */
    fun nextTry() {
        census.nextTry()
        rendered.clear()
    }

    /** Says what came of the rule, given jqwik's [result]. */
    fun verdict(result: PropertyExecutionResult, today: LocalDate): RuleResult {
        val inapplicable = notDeclared
        val failure = result.throwable().orElse(null) ?: AssertionError("failed without a word")
        val plain = when {
            inapplicable != null -> RuleOutcome.NOT_SUPPORTED
            result.status() == Status.SUCCESSFUL -> RuleOutcome.PASSED
            result.status() == Status.ABORTED -> RuleOutcome.NOT_SUPPORTED
            rule.level == Level.SHOULD -> RuleOutcome.NOT_FOLLOWED
            else -> RuleOutcome.FAILED
        }
        val outcome = when {
            waiver == null -> plain
            waiver.expires < today -> RuleOutcome.WAIVER_EXPIRED
            plain.isBroken -> RuleOutcome.WAIVED
            else -> RuleOutcome.WAIVED_BUT_PASSES
        }
        val parameters = result.falsifiedParameters().orElse(emptyList())
        return RuleResult(
            rule,
            outcome,
            message = message(plain, outcome, failure),
            tries = result.countTries(),
            milliseconds = (System.nanoTime() - start) / NANOSECONDS,
            distribution = census.distribution(),
            failure = if (plain.isBroken) RuleFailure.of(failure, parameters, firstFailure) else null,
        )
    }

    private fun message(plain: RuleOutcome, outcome: RuleOutcome, failure: Throwable): String = when (outcome) {
        RuleOutcome.PASSED -> ""
        RuleOutcome.FAILED, RuleOutcome.CRASHED, RuleOutcome.TIMED_OUT, RuleOutcome.FLAKY, RuleOutcome.NOT_FOLLOWED ->
            failure.message ?: failure.toString()

        RuleOutcome.NOT_RUN -> failure.message.orEmpty()

        RuleOutcome.NOT_SUPPORTED -> (notDeclared ?: failure).message.orEmpty()
        RuleOutcome.WAIVED -> "waived until ${waiver?.expires}: ${waiver?.reason} (${waiver?.link})"
        RuleOutcome.WAIVED_BUT_PASSES -> "is waived, but ${word(plain)}: delete its waiver"
        RuleOutcome.WAIVER_EXPIRED -> "the waiver expired on ${waiver?.expires}, and the rule ${word(plain)}"
    }

    private fun word(plain: RuleOutcome): String = when (plain) {
        RuleOutcome.PASSED -> "passes"
        RuleOutcome.FAILED -> "fails"
        RuleOutcome.CRASHED -> "crashes"
        RuleOutcome.TIMED_OUT -> "times out"
        RuleOutcome.FLAKY -> "is flaky"
        RuleOutcome.NOT_RUN -> "was not run"
        RuleOutcome.NOT_FOLLOWED -> "is not followed"
        else -> "is not supported"
    }

    companion object {
        private const val NANOSECONDS = 1_000_000L

        /** The rule that is on trial just now; null between rules. There is one at a time in a JVM. */
        @Volatile
        var current: Trial? = null
    }
}
