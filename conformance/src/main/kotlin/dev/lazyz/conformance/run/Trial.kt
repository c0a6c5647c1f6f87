package dev.lazyz.conformance.run

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.casesAmong
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.judgement.Inconclusive
import dev.lazyz.conformance.judgement.NotDeclared
import dev.lazyz.conformance.judgement.ProcessEnded
import dev.lazyz.conformance.judgement.TimedOut
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.crash
import dev.lazyz.conformance.probes.SettingsBefore
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waiver
import dev.lazyz.conformance.rules.Level
import java.time.Duration
import java.time.LocalDate
import java.util.Collections
import java.util.IdentityHashMap
import net.jqwik.api.lifecycle.PropertyExecutionResult
import net.jqwik.api.lifecycle.PropertyExecutionResult.Status
import net.jqwik.api.lifecycle.TryExecutionResult

/**
 * One rule under test, from the first try to the result.
 *
 * Each try runs in a separate thread, and each of its renderings has the [deadline]. After the first failure, at most
 * [steps] smaller frames are tried, the same ones in every run.
 */
internal class Trial(
    val rule: SuiteRule,
    private val waiver: Waiver?,
    deadline: Duration = Settings.USUAL_DEADLINE,
    steps: Int = Settings.MANY_STEPS,
    private val journal: Journal? = null,
) : TryUnderWay,
    AutoCloseable {
    /** The user's own frames; null if there are none. */
    var own: FrameFolder? = null

    /** The settings of the process before the run; null if other code uses the same process. */
    var settingsBefore: SettingsBefore? = null

    override val settingChanged: String? get() = settingsBefore?.changed

    override val ownCases: List<FrameCase> get() = own?.cases.orEmpty()

    private val shrinking = ShrinkingLimit(steps, deadline.multipliedBy(DEADLINES_TO_SHRINK))
    private val census = Census()
    private val start = System.nanoTime()
    private val thread = TryThread(deadline)
    private val before = ArrayDeque<FrameCase>()
    private var isFlaky = false
    private val processEnd = journal?.endAt(rule)
    private var tries = 0

    /** Why the rule does not apply; null until this is known. */
    private var notDeclared: NotDeclared? = null

    /** Why it is not known whether the renderer follows the rule; null unless that is so. */
    private var inconclusive: Inconclusive? = null

    /** Why the rule is not run at all; null if it is. */
    var notRun: NotRun? = null

    /** The smallest failing try. Once this is set, further tries shrink the frame and are not counted. */
    @Volatile
    private var falsified: Falsified? = null

    /** The exception of the first failing try. */
    private var firstFailure: Throwable? = null

    private class Falsified(val parameters: List<Any>, val failure: Throwable)

    private val rendered = Collections.synchronizedSet(Collections.newSetFromMap(IdentityHashMap<Renderer, Boolean>()))

    /** The thread of the current try. */
    @Volatile
    private var tryThread: Thread? = null

    override fun isAgain(renderer: Renderer): Boolean = !rendered.add(renderer) && Thread.currentThread() === tryThread

    /** The frame that the current try renders or rendered last; null if there is none. */
    @Volatile
    var underTrial: FrameCase? = null
        private set

    override fun saw(case: FrameCase, how: String) {
        underTrial = case
        if (falsified == null) {
            census.add(case.frame, case.scene, how)
        } else {
            shrinking.count(case.frame)
        }
    }

    override fun goesOn() {
        thread.goesOn()
        journal?.goesOn()
    }

    /** Calls [block] as the next try, or as the next shrinking step. */
    fun attempt(parameters: List<Any>, block: () -> TryExecutionResult): TryExecutionResult {
        if (notRun != null || notDeclared != null || inconclusive != null) return TryExecutionResult.satisfied(true)
        falsified?.let { return shrink(it, parameters, block) }
        journal?.tries()
        tries++
        if (processEnd != null) return replay(processEnd, parameters)
        census.nextTry()
        val result = answer(parameters, block)
        val failure = result.throwable().orElse(null)
        if (failure is NotDeclared || failure is Inconclusive) {
            notDeclared = failure as? NotDeclared
            inconclusive = failure as? Inconclusive
            return TryExecutionResult.satisfied(true)
        }
        if (result.isFalsified) {
            firstFailure = failure
            falsified = Falsified(parameters, failure ?: AssertionError("failed without a message"))
            shrinking.begin()
            if (isTooExpensiveToRepeat(failure)) shrinking.end()
        } else {
            remember(parameters)
        }
        return result
    }

    /** Skips the tries before the one in which the process ended, and reports that one as failed. */
    private fun replay(end: ProcessEnd, parameters: List<Any>): TryExecutionResult {
        if (tries < end.tries) return TryExecutionResult.satisfied()
        val lead = if (end.isShrinking) "failed, and during shrinking " else ""
        val where = casesAmong(parameters).firstOrNull()?.let { "\nin\n$it" }.orEmpty()
        val message = "${lead}ended the process: ${end.words}$where"
        if (end.outcome == RuleOutcome.INCONCLUSIVE) {
            inconclusive = Inconclusive(message)
            return TryExecutionResult.satisfied(true)
        }
        val failure = if (end.outcome == RuleOutcome.TIMED_OUT) TimedOut(message, null) else ProcessEnded(message)
        falsified = Falsified(parameters, failure)
        shrinking.end()
        return TryExecutionResult.falsified(failure)
    }

    /**
     * Reports the first failure to jqwik for every step, because jqwik would otherwise keep and sort a list of all
     * failures.
     */
    private fun shrink(best: Falsified, parameters: List<Any>, block: () -> TryExecutionResult): TryExecutionResult {
        if (!shrinking.isStepLeft()) throw ShrinkingEnds()
        journal?.shrinks()
        val failure = answer(parameters, block).throwable().orElse(null)
        if (failure is TimedOut || failure is Inconclusive) throw ShrinkingEnds()
        if (failure == null || failure.javaClass != best.failure.javaClass) return TryExecutionResult.satisfied()
        falsified = Falsified(parameters, failure)
        return TryExecutionResult.falsified(firstFailure)
    }

    /** Calls [block] in the try thread and catches all throwables. jqwik's own code stays in the calling thread. */
    private fun answer(parameters: List<Any>, block: () -> TryExecutionResult): TryExecutionResult {
        underTrial = casesAmong(parameters).firstOrNull()
        rendered.clear()
        return try {
            thread.call {
                tryThread = Thread.currentThread()
                block()
            }
        } catch (late: Late) {
            val words = "${late.message}${underTrial?.let { "\nin\n$it" }.orEmpty()}"
            TryExecutionResult.falsified(
                when (late.lateness) {
                    Lateness.BUSY -> TimedOut(words, underTrial)
                    Lateness.ASLEEP -> TimedOut(words, underTrial, isAsleep = true)
                    Lateness.UNKNOWN -> Inconclusive(words)
                },
            )
        } catch (e: InterruptedException) {
            throw e
        } catch (e: Throwable) {
            TryExecutionResult.falsified(e)
        }
    }

    private fun remember(parameters: List<Any>) {
        before.addAll(casesAmong(parameters))
        while (before.size > RuleFailure.MOST_BEFORE) before.removeFirst()
    }

    /** Calls [block] several times with the failing try. If one call succeeds, the failure is not reproducible. */
    fun repeat(block: (List<Any>) -> Unit) {
        val best = falsified ?: return
        if (isTooExpensiveToRepeat(best.failure)) return
        isFlaky = (1..REPETITIONS).any { answer { thread.call { block(best.parameters) } } == null }
    }

    /** Returns the result of the rule, given jqwik's [result]. */
    fun verdict(result: PropertyExecutionResult, today: LocalDate): RuleResult {
        val failure =
            falsified?.failure ?: result.throwable().orElse(null) ?: AssertionError("failed without a message")
        val plain = outcome(result.status(), failure)
        val outcome = when {
            waiver == null || plain == RuleOutcome.NOT_RUN || plain == RuleOutcome.INCONCLUSIVE -> plain
            waiver.expires < today -> RuleOutcome.WAIVER_EXPIRED
            plain.isBroken -> RuleOutcome.WAIVED
            else -> RuleOutcome.WAIVED_BUT_PASSES
        }
        val parameters = falsified?.parameters.orEmpty()
        return RuleResult(
            rule,
            outcome,
            message = message(plain, outcome, failure),
            tries = if (notRun != null) 0 else result.countTries(),
            milliseconds = (System.nanoTime() - start) / NANOSECONDS,
            distribution = census.distribution(),
            failure = if (!plain.isBroken) {
                null
            } else {
                RuleFailure.of(failure, parameters, firstFailure, if (isFlaky) before.toList() else emptyList())
            },
        )
    }

    private fun outcome(status: Status, failure: Throwable): RuleOutcome = when {
        notRun != null -> checkNotNull(notRun).outcome
        inconclusive != null -> RuleOutcome.INCONCLUSIVE
        notDeclared != null -> RuleOutcome.NOT_SUPPORTED
        processEnd != null -> processEnd.outcome
        status == Status.SUCCESSFUL -> RuleOutcome.PASSED
        status == Status.ABORTED -> RuleOutcome.NOT_SUPPORTED
        failure is TimedOut -> RuleOutcome.TIMED_OUT
        crash(failure) != null -> RuleOutcome.CRASHED
        rule.level == Level.SHOULD -> RuleOutcome.NOT_FOLLOWED
        isFlaky -> RuleOutcome.FLAKY
        else -> RuleOutcome.FAILED
    }

    private fun message(plain: RuleOutcome, outcome: RuleOutcome, failure: Throwable): String = when (outcome) {
        RuleOutcome.PASSED -> ""
        RuleOutcome.FLAKY -> NOT_REPRODUCIBLE
        RuleOutcome.FAILED, RuleOutcome.CRASHED, RuleOutcome.TIMED_OUT, RuleOutcome.NOT_FOLLOWED -> words(failure)
        RuleOutcome.NOT_RUN -> notRun?.why.orEmpty()
        RuleOutcome.INCONCLUSIVE -> notRun?.why ?: inconclusive?.message.orEmpty()
        RuleOutcome.NOT_SUPPORTED -> (notDeclared ?: failure).message.orEmpty()
        RuleOutcome.WAIVED -> "waived until ${waiver?.expires}: ${waiver?.reason} (${waiver?.link})"
        RuleOutcome.WAIVED_BUT_PASSES -> "has a waiver, but ${verb(plain)}: delete the waiver"
        RuleOutcome.WAIVER_EXPIRED -> "the waiver expired on ${waiver?.expires}, and the rule ${verb(plain)}"
    }

    private fun words(failure: Throwable): String = failure.message ?: failure.toString()

    private fun verb(plain: RuleOutcome): String = when (plain) {
        RuleOutcome.PASSED -> "passes"
        RuleOutcome.FAILED -> "fails"
        RuleOutcome.CRASHED -> "crashes"
        RuleOutcome.TIMED_OUT -> "times out"
        RuleOutcome.FLAKY -> "is flaky"
        RuleOutcome.NOT_FOLLOWED -> "is not followed"
        else -> "is not supported"
    }

    override fun close(): Unit = thread.close()

    companion object {
        private const val NANOSECONDS = 1_000_000L

        /** A frame that fails in one of ten renderings fails in as many further ones with a probability of 1/1000. */
        private const val REPETITIONS = 3

        /** Limits shrinking by time, for tries that take seconds each. Usually the number of steps is the limit. */
        private const val DEADLINES_TO_SHRINK = 3L

        private const val NOT_REPRODUCIBLE =
            "not reproducible: the same frame was correct when rendered again; look for state or data races"

        /** The current rule; null between rules. There is one at a time in a JVM. */
        var current: Trial?
            get() = TryUnderWay.current as Trial?
            set(trial) {
                TryUnderWay.current = trial
            }

        private fun isTooExpensiveToRepeat(failure: Throwable?): Boolean =
            failure is TimedOut || failure is ProcessEnded || failure is OutOfMemoryError ||
                failure?.cause is OutOfMemoryError
    }
}
