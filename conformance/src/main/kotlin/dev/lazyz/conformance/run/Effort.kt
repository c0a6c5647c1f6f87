package dev.lazyz.conformance.run

import dev.lazyz.conformance.judgement.Inconclusive
import dev.lazyz.conformance.report.ReportFiles
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.rules.AllRules
import java.io.IOException
import java.lang.reflect.AnnotatedElement
import java.lang.reflect.Method
import java.nio.file.Files
import java.nio.file.Path
import java.time.LocalDate
import java.util.Optional
import net.jqwik.api.Reporter
import net.jqwik.api.lifecycle.AroundContainerHook
import net.jqwik.api.lifecycle.AroundPropertyHook
import net.jqwik.api.lifecycle.AroundTryHook
import net.jqwik.api.lifecycle.ContainerLifecycleContext
import net.jqwik.api.lifecycle.PropertyExecutionResult
import net.jqwik.api.lifecycle.PropertyExecutor
import net.jqwik.api.lifecycle.PropertyLifecycleContext
import net.jqwik.api.lifecycle.TryExecutionResult
import net.jqwik.api.lifecycle.TryExecutor
import net.jqwik.api.lifecycle.TryLifecycleContext
import org.junit.platform.engine.FilterResult
import org.junit.platform.engine.TestDescriptor
import org.junit.platform.engine.support.descriptor.ClassSource
import org.junit.platform.launcher.PostDiscoveryFilter
import org.opentest4j.TestAbortedException

/**
 * jqwik hook: sets tries and seed of the suite's rules, from a run of `Conformance` or from system properties, and
 * determines their outcomes.
 */
internal class Effort :
    AroundContainerHook,
    AroundPropertyHook,
    AroundTryHook {
    /**
     * The tally of the current test class. jqwik creates one hook for all classes, and runs one class after the other.
     */
    private var tally = RuleFailures()

    override fun beforeContainer(context: ContainerLifecycleContext) {
        tally = RuleFailures()
        context.optionalContainerClass().ifPresent { requireRulesNotOverridden(it) }
    }

    /** Checks that no test class overrides a rule. Rules are functions of interfaces, which cannot be final. */
    private fun requireRulesNotOverridden(type: Class<*>) {
        if (!AllRules::class.java.isAssignableFrom(type)) return
        for (rule in SuiteRule.all) {
            val found = type.getMethod(rule.name, *rule.method.parameterTypes)
            check(found.declaringClass == rule.method.declaringClass) {
                "${type.name} overrides $rule; to allow a failure, use a waiver"
            }
        }
    }

    /** Ignores tests that a subclass adds. */
    override fun appliesTo(element: Optional<AnnotatedElement>): Boolean =
        element.map {
            it !is Method || it.declaringClass.isAssignableFrom(AllRules::class.java)
        }.orElse(false)

    override fun aroundProperty(
        context: PropertyLifecycleContext,
        property: PropertyExecutor,
    ): PropertyExecutionResult {
        val rule = SuiteRule.find(context.targetMethod().name) ?: return property.execute()
        val run = RunUnderWay.current
        val settings = run?.settings ?: Settings.ofProperties()

        // Set the number of tries, the seed and the shrinking mode
        val attributes = context.attributes()
        attributes.setTries((rule.tries * settings.tries).toInt().coerceAtLeast(1))
        attributes.setSeed(rule.seed(settings.seed ?: SuiteRule.fixedSeed).toString())
        if (run != null) attributes.setShrinking(settings.shrinking.mode)

        // Run the rule and determine its outcome
        val journal = run?.journal
        journal?.begins(rule)
        val (result, verdict) = Trial(rule, settings.waivers.of(rule.name), settings.deadline, tally.steps, journal)
            .use { trial ->
                trial.own = settings.frames
                trial.settingsBefore = run?.settingsBefore
                trial.notRun = tally.whyNoFurtherRule
                val result = tried(trial, context, property)
                run?.settingsBefore?.restore()
                result to trial.verdict(result, LocalDate.now())
            }
        tally.add(verdict)
        journal?.ends(verdict)
        settings.frames?.keep(verdict)
        if (run != null) {
            run.add(verdict)
            return translated(context, result, verdict)
        }
        if (verdict.outcome == RuleOutcome.INCONCLUSIVE) {
            // Build tools count an exception as an error, not as a failure
            return result.mapToFailed(Inconclusive("inconclusive: ${verdict.message}\n${verdict.look}"))
        }
        if (!verdict.outcome.isBroken || !verdict.outcome.isFailure) return translated(context, result, verdict)
        val kept = KeptFailure.of(context.testInstance() as AllRules, settings, verdict)
        return result.mapToFailed(AssertionError("${verdict.message}\n$kept", verdict.failure?.cause))
    }

    private fun tried(
        trial: Trial,
        context: PropertyLifecycleContext,
        property: PropertyExecutor,
    ): PropertyExecutionResult {
        ExitMessage.keep()
        Trial.current = trial
        try {
            val result = property.execute()
            trial.repeat { context.targetMethod().invoke(context.testInstance(), *it.toTypedArray()) }
            return result
        } finally {
            Trial.current = null
        }
    }

    override fun aroundTry(
        context: TryLifecycleContext,
        attempt: TryExecutor,
        parameters: List<Any>,
    ): TryExecutionResult {
        val rule = SuiteRule.find(context.targetMethod().name) ?: return attempt.execute(parameters)

        // jqwik may bound shrinking by time and then continue the search after the rule has ended
        val trial = Trial.current?.takeIf { it.rule == rule } ?: throw ShrinkingEnds()
        return trial.attempt(parameters) { attempt.execute(parameters) }
    }

    /** Returns the result that jqwik reports to its caller. */
    private fun translated(
        context: PropertyLifecycleContext,
        result: PropertyExecutionResult,
        verdict: RuleResult,
    ): PropertyExecutionResult =
        when (verdict.outcome) {
            RuleOutcome.PASSED, RuleOutcome.FAILED, RuleOutcome.CRASHED, RuleOutcome.TIMED_OUT, RuleOutcome.FLAKY ->
                result

            RuleOutcome.NOT_FOLLOWED, RuleOutcome.WAIVED, RuleOutcome.NOT_SUPPORTED -> {
                // jqwik's own report of a skipped property has a dozen lines that say nothing
                context.reporter().publishValue(verdict.rule.name, "${verdict.outcome.words}: ${verdict.message}")
                context.wrapReporter { Silence }
                result.mapToAborted(TestAbortedException(verdict.message))
            }

            RuleOutcome.INCONCLUSIVE, RuleOutcome.NOT_RUN, RuleOutcome.WAIVED_BUT_PASSES, RuleOutcome.WAIVER_EXPIRED ->
                result.mapToFailed(AssertionError(verdict.message, verdict.failure?.cause))
        }
}

/** Publishes nothing. */
private object Silence : Reporter {
    override fun publishValue(key: String, value: String) = Unit

    override fun publishReport(key: String, value: Any) = Unit

    override fun publishReports(key: String, values: Map<String, Any>) = Unit
}

/** Saves the frames of failures when the suite runs as a test of a build, where there is no report. */
internal object KeptFailure {
    /**
     * Writes the files of a [failed] rule, and returns a text with their location and the command that reproduces the
     * failure.
     */
    fun of(test: AllRules, settings: Settings, failed: RuleResult): String {
        val failure = checkNotNull(failed.failure)
        val judged = StrategyInfo(test.renderer())
        val report = settings.report(judged, null, listOf(failed), failed.milliseconds, isOnDisk = false)
        val folder = folder().resolve(test.javaClass.simpleName)
        val kept = try {
            Files.createDirectories(folder)
            val files = ReportFiles(report, folder).write(failure, folder, failed.rule)
            if (files.isEmpty()) "" else "saved in $folder: ${files.joinToString()}\n"
        } catch (e: IOException) {
            "not saved: $e\n"
        }
        return "${kept}seed ${report.seed}; again: ${report.commandFor(failed.rule)}"
    }

    /** The folder that the system property names, or a folder in the build directory. */
    private fun folder(): Path {
        System.getProperty(SuiteProperties.OUTPUT)?.let { return Path.of(it) }
        val build = listOf("target", "build").map { Path.of(it) }.firstOrNull { Files.isDirectory(it) }
        return (build ?: Path.of(System.getProperty("java.io.tmpdir"))).resolve("lazyz-conformance")
    }
}

/**
 * If the process ends during a try, prints the rule and the frame to standard error. Also prints a message if the
 * process ends while the renderer is created.
 */
internal object ExitMessage {
    init {
        Runtime.getRuntime().addShutdownHook(Thread({ tell() }, "lazyz-last-words"))
    }

    /** Starts watching for the end of the process. */
    fun keep(): Unit = Unit

    /** Whether the renderer is being created, before any rule runs. */
    @Volatile
    var isMaking: Boolean = false

    private fun tell() {
        val trial = Trial.current
        if (trial == null) {
            if (isMaking) System.err.println("The process ends while the renderer is created, before the first rule")
            return
        }
        val where = trial.underTrial?.let { ", with\n$it" }.orEmpty()
        System.err.println("The process ends while ${trial.rule} is running$where")
    }
}

/**
 * Fails a Maven build that would run no rule, and succeed, because of `-Dtest='MyTest#rule_5*'`: Maven looks for
 * methods by the class that declares them, which is one of the suite's. It includes everything.
 */
internal class SelectedRules : PostDiscoveryFilter {
    override fun apply(test: TestDescriptor): FilterResult {
        val source = test.source.orElse(null) as? ClassSource
        val type = source?.let { runCatching { it.getJavaClass() }.getOrNull() }
        if (type != null && AllRules::class.java.isAssignableFrom(type)) requireRules(type.simpleName)
        return FilterResult.included(null)
    }

    companion object {
        /** The system property in which Maven passes the option of this name on. */
        const val PROPERTY: String = "test"

        private fun requireRules(name: String) {
            val words = System.getProperty(PROPERTY).orEmpty().split(',').map { it.trim() }
            val (type, methods) = words.firstOrNull { it.substringBefore('#').endsWith(name) && '#' in it }
                ?.split('#', limit = 2) ?: return
            check("*Rules#$methods" in words) {
                "-Dtest=$type#$methods runs none of the rules, which $name inherits; use -Dtest='$type,*Rules#$methods'"
            }
        }
    }
}
