package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.broken.gallery.RuleNames
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.rules.Rule
import java.nio.file.Files
import java.nio.file.Path
import kotlin.reflect.KClass

/** A run of the suite from within a test: which rules there are, and why which of them failed. */
class SuiteRun private constructor(val report: ConformanceReport) {
    /** The names of the rules that were run. */
    val rules: Set<String> = report.results.mapTo(LinkedHashSet()) { it.rule.name }

    /** What was thrown, by the names of the rules that failed or are not followed. */
    val failures: Map<String, Throwable> = report.results
        .filter { it.outcome.isBroken }
        .associate { it.rule.name to checkNotNull(it.failure).cause }

    companion object {
        /** The names of all rules. */
        val rules: Set<String> = SuiteRule.all.mapTo(LinkedHashSet()) { it.name }

        /** Judges what [make] makes on [tries] times the usual frames. */
        fun of(tries: Double, make: () -> Renderer): SuiteRun =
            SuiteRun(Conformance(make).tries(tries).withoutShrinking().run())

        /** Runs the suite [subject]: the rules called [rules], or all. */
        fun of(subject: KClass<out RendererConformance>, tries: Double, vararg rules: String): SuiteRun {
            val constructor = subject.java.getDeclaredConstructor().apply { isAccessible = true }
            val conformance = Conformance { constructor.newInstance().renderer() }.subject(subject.java)
            for (rule in rules) conformance.rule(rule)
            return SuiteRun(conformance.tries(tries).withoutShrinking().run())
        }

        /** What is said of the rule of this name. */
        fun annotation(rule: String): Rule =
            RendererConformance::class.java.methods.first { it.name == rule }.getAnnotation(Rule::class.java)

        /** Judges what [make] makes by some rules, shrinking nothing. */
        fun ofRules(rules: Collection<String>, make: () -> Renderer): SuiteRun {
            val conformance = Conformance(make).tries(1.0).withoutShrinking()
            for (rule in rules) conformance.rule(rule)
            if (RuleNames.frames in rules) conformance.frames(ownFrames)
            return SuiteRun(conformance.run())
        }

        /** A folder with a frame of a width that the suite's own do not have. */
        private val ownFrames: Path =
            listOf("src/test/resources", "conformance/src/test/resources").map { Path.of(it) }
                .first { Files.isDirectory(it) }.resolve("frames")

        /** Judges what [make] makes by one rule, and shrinks what fails. */
        fun ofRule(rule: String, tries: Double, make: () -> Renderer): SuiteRun =
            SuiteRun(Conformance(make).tries(tries).rule(rule).run())

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
