package dev.lazyz.conformance.run

import dev.lazyz.Renderer
import dev.lazyz.conformance.probes.SettingsBefore
import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.rules.AllRules
import java.util.concurrent.atomic.AtomicReference
import java.util.function.Supplier
import java.util.logging.Level as LogLevel
import java.util.logging.Logger
import org.junit.platform.engine.TestExecutionResult
import org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod
import org.junit.platform.launcher.EngineFilter.includeEngines
import org.junit.platform.launcher.TestExecutionListener
import org.junit.platform.launcher.TestIdentifier
import org.junit.platform.launcher.core.LauncherConfig
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder
import org.junit.platform.launcher.core.LauncherFactory

/** A run of the suite in this process. jqwik instantiates the test class, which gets its renderer from here. */
internal class RunUnderWay(
    val make: Supplier<out Renderer>,
    private val subject: Class<out AllRules>,
    private val rules: List<SuiteRule>,
    val settings: Settings,
    val journal: Journal? = null,
    private val listener: RuleListener = RuleListener { _, _, _ -> },
    val settingsBefore: SettingsBefore? = null,
) {
    private val results = LinkedHashMap<String, RuleResult>()

    /** Adds the result of a rule. */
    fun add(result: RuleResult) {
        results[result.rule.name] = result
        listener.ended(result.rule, result.outcome, result.milliseconds)
    }

    /** Runs the rules and returns their results, in the same order. */
    fun execute(): List<RuleResult> {
        check(active.compareAndSet(null, this)) {
            "a run of the conformance suite is in progress in this process; only one at a time is possible"
        }
        val level = jqwik.level
        jqwik.level = LogLevel.SEVERE
        try {
            val mishaps = Mishaps()
            launcher().execute(request(), mishaps)
            val missing = rules.filter { it.name !in results }
            check(missing.isEmpty()) { "not run: ${missing.joinToString()}; $mishaps" }
        } finally {
            jqwik.level = level
            active.set(null)
        }
        return rules.map { results.getValue(it.name) }
    }

    /** Disables listeners that happen to be on the class path. */
    private fun launcher() = LauncherFactory.create(
        LauncherConfig.builder()
            .enableLauncherSessionListenerAutoRegistration(false)
            .enableLauncherDiscoveryListenerAutoRegistration(false)
            .enablePostDiscoveryFilterAutoRegistration(false)
            .enableTestExecutionListenerAutoRegistration(false)
            .build(),
    )

    /** The user's frames come first: past failures are the most likely to fail again. */
    private fun inOrder() = rules.sortedByDescending { settings.frames != null && it.name == FrameFolder.RULE }

    private fun request() = LauncherDiscoveryRequestBuilder.request()
        .selectors(inOrder().map { selectMethod(subject, it.method) })
        .filters(includeEngines("jqwik"))
        .enableImplicitConfigurationParameters(false)
        .configurationParameter("jqwik.database", "")
        .configurationParameter("jqwik.failures.after.default", "RANDOM_SEED")
        .configurationParameter("jqwik.reporting.usejunitplatform", "true")
        .build()

    /** Records why tests or their class could not be run. */
    private class Mishaps : TestExecutionListener {
        private val causes = ArrayList<Throwable>()

        override fun executionFinished(test: TestIdentifier, result: TestExecutionResult) {
            result.throwable.ifPresent { causes.add(it) }
        }

        override fun toString(): String = causes.firstOrNull()?.stackTraceToString() ?: "the reason is unknown"
    }

    companion object {
        private val active = AtomicReference<RunUnderWay?>()

        /** jqwik logs that it has no database, which is intended, and when it ends shrinking. */
        private val jqwik = Logger.getLogger("net.jqwik")

        /** The run in progress, or null if a build tool runs the suite. */
        val current: RunUnderWay? get() = active.get()
    }
}
