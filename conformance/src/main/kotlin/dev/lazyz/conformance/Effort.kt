package dev.lazyz.conformance

import java.lang.reflect.AnnotatedElement
import java.lang.reflect.Method
import java.nio.file.Path
import java.time.LocalDate
import java.util.Optional
import net.jqwik.api.ShrinkingMode
import net.jqwik.api.lifecycle.AroundPropertyHook
import net.jqwik.api.lifecycle.AroundTryHook
import net.jqwik.api.lifecycle.PropertyExecutionResult
import net.jqwik.api.lifecycle.PropertyExecutor
import net.jqwik.api.lifecycle.PropertyLifecycleContext
import net.jqwik.api.lifecycle.TryExecutionResult
import net.jqwik.api.lifecycle.TryExecutor
import net.jqwik.api.lifecycle.TryLifecycleContext
import org.opentest4j.TestAbortedException

/** Sets tries and seed of the suite's rules, by a [Conformance] run or by system properties, and judges. */
internal class Effort :
    AroundPropertyHook,
    AroundTryHook {
    /** Leaves alone what a subclass adds. */
    override fun appliesTo(element: Optional<AnnotatedElement>): Boolean =
        element.map {
            it !is Method || it.declaringClass.isAssignableFrom(RendererConformance::class.java)
        }.orElse(false)

    override fun aroundProperty(
        context: PropertyLifecycleContext,
        property: PropertyExecutor,
    ): PropertyExecutionResult {
        val rule = SuiteRule.find(context.targetMethod().name) ?: return property.execute()
        val run = RunUnderWay.current
        val settings = run?.settings ?: Settings.ofProperties()

        // Make the effort that is asked for
        val attributes = context.attributes()
        attributes.setTries((attributes.tries().orElse(1) * settings.tries).toInt().coerceAtLeast(1))
        attributes.setSeed(rule.seed(settings.seed ?: SuiteRule.fixedSeed).toString())
        if (settings.shrinking == Shrinking.OFF) attributes.setShrinking(ShrinkingMode.OFF)

        // Try the rule, and judge
        val trial = Trial(rule, settings.waivers.of(rule.name))
        Trial.current = trial
        val result = try {
            property.execute()
        } finally {
            Trial.current = null
        }
        val verdict = trial.verdict(result, LocalDate.now())
        if (run != null) {
            run.add(verdict)
            return translated(result, verdict)
        }
        if (verdict.outcome != RuleOutcome.FAILED) return translated(result, verdict)
        val kept = KeptFailure.of(context.testInstance() as RendererConformance, settings, verdict)
        return result.mapToFailed(AssertionError("${verdict.message}\n$kept", verdict.failure?.cause))
    }

    override fun aroundTry(
        context: TryLifecycleContext,
        attempt: TryExecutor,
        parameters: List<Any>,
    ): TryExecutionResult {
        val trial = Trial.current
        trial?.nextTry()
        val result = attempt.execute(parameters)
        val failure = result.throwable().orElse(null)
        if (trial != null && failure is NotDeclared) {
            trial.notDeclared = failure
            return TryExecutionResult.satisfied(true)
        }
        if (trial != null && result.isFalsified && trial.firstFailure == null) trial.firstFailure = failure
        return result
    }

    /** What jqwik tells whoever runs it. */
    private fun translated(result: PropertyExecutionResult, verdict: RuleResult): PropertyExecutionResult =
        when (verdict.outcome) {
            RuleOutcome.PASSED, RuleOutcome.FAILED, RuleOutcome.CRASHED, RuleOutcome.TIMED_OUT, RuleOutcome.FLAKY,
            RuleOutcome.NOT_RUN,
            -> result

            RuleOutcome.NOT_FOLLOWED, RuleOutcome.WAIVED, RuleOutcome.NOT_SUPPORTED ->
                result.mapToAborted(TestAbortedException(verdict.message))

            RuleOutcome.WAIVED_BUT_PASSES, RuleOutcome.WAIVER_EXPIRED ->
                result.mapToFailed(AssertionError(verdict.message, verdict.failure?.cause))
        }
}

/** Whether a frame that fails is made smaller. */
internal enum class Shrinking { ON, OFF }

/** How the suite is run; [seed] is null for the fixed one. */
internal class Settings(val tries: Double, val seed: Long?, val waivers: Waivers, val shrinking: Shrinking) {
    companion object {
        /** What the system properties say. */
        fun ofProperties(): Settings = Settings(tries(), seed(), waivers(), Shrinking.ON)

        fun tries(): Double {
            val text = System.getProperty(RendererConformance.TRIES, "1")
            val tries = text.toDoubleOrNull()
            require(tries != null && tries > 0.0 && tries.isFinite()) {
                "system property ${RendererConformance.TRIES} must be a positive number: $text"
            }
            return tries
        }

        fun seed(): Long? = System.getProperty(RendererConformance.SEED)?.let { text ->
            requireNotNull(text.toLongOrNull()) {
                "system property ${RendererConformance.SEED} must be a whole number: $text"
            }
        }

        fun waivers(): Waivers =
            System.getProperty(Waivers.PROPERTY)?.let { Waivers.read(Path.of(it)) } ?: Waivers.NONE
    }
}
