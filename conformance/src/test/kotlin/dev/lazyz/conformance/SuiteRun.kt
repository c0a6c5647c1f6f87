package dev.lazyz.conformance

import dev.lazyz.Renderer
import kotlin.reflect.KClass
import net.jqwik.api.Property
import org.junit.platform.engine.DiscoverySelector
import org.junit.platform.engine.TestExecutionResult
import org.junit.platform.engine.discovery.DiscoverySelectors.selectClass
import org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod
import org.junit.platform.engine.support.descriptor.MethodSource
import org.junit.platform.launcher.EngineFilter.includeEngines
import org.junit.platform.launcher.TestExecutionListener
import org.junit.platform.launcher.TestIdentifier
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder
import org.junit.platform.launcher.core.LauncherFactory

/** A run of the suite from within a test: which rules there are, and why which of them failed. */
class SuiteRun private constructor(val rules: Set<String>, val failures: Map<String, Throwable>) {
    /** The suite for whatever renderer is to be judged next. */
    class Subject : RendererConformance() {
        override fun renderer(): Renderer = make()
    }

    companion object {
        /** The names of all rules. */
        val rules: Set<String> = RendererConformance::class.java.methods
            .filter { it.isAnnotationPresent(Property::class.java) }
            .mapTo(LinkedHashSet()) { it.name }

        private var make: () -> Renderer = { error("no renderer to judge") }

        /** Judges what [make] makes on [tries] times the usual frames. */
        fun of(tries: Double, make: () -> Renderer): SuiteRun {
            this.make = make
            return of(Subject::class, tries)
        }

        /** Runs the suite [subject]. */
        fun of(subject: KClass<out RendererConformance>, tries: Double): SuiteRun =
            run(selectClass(subject.java), tries, "OFF")

        /** Judges what [make] makes by one rule, and shrinks what fails. */
        fun ofRule(rule: String, tries: Double, make: () -> Renderer): SuiteRun {
            this.make = make
            return run(selectMethod(Subject::class.java, rule, FrameCase::class.java), tries, "BOUNDED")
        }

        private fun run(what: DiscoverySelector, tries: Double, shrinking: String): SuiteRun {
            val rules = LinkedHashSet<String>()
            val failures = LinkedHashMap<String, Throwable>()
            val listener = object : TestExecutionListener {
                override fun executionFinished(test: TestIdentifier, result: TestExecutionResult) {
                    val rule = (test.source.orElse(null) as? MethodSource)?.methodName ?: test.displayName
                    if (test.isTest) rules.add(rule)
                    if (result.throwable.isPresent) failures[rule] = result.throwable.get()
                }
            }
            val request = LauncherDiscoveryRequestBuilder.request()
                .selectors(what)
                .filters(includeEngines("jqwik"))
                .configurationParameter("jqwik.database", "")
                .configurationParameter("jqwik.failures.after.default", "RANDOM_SEED")
                .configurationParameter("jqwik.shrinking.default", shrinking)
                .configurationParameter("jqwik.reporting.usejunitplatform", "true")
                .build()
            withProperty(RendererConformance.TRIES, tries.toString()) {
                LauncherFactory.create().execute(request, listener)
            }
            return SuiteRun(rules, failures)
        }

        /** Calls [block] while the system property [name] has this [value]. */
        fun withProperty(name: String, value: String, block: () -> Unit) {
            val before = System.setProperty(name, value)
            try {
                block()
            } finally {
                if (before == null) System.clearProperty(name) else System.setProperty(name, before)
            }
        }
    }
}
