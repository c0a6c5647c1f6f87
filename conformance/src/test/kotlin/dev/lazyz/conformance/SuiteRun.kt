package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.rules.Rule
import java.nio.file.Files
import java.nio.file.Path
import kotlin.reflect.KClass

/** A run of the suite from a test: the rules, and why some of them failed. */
class SuiteRun private constructor(val report: ConformanceReport) {
    /** The names of the rules that were run. */
    val rules: Set<String> = report.results.mapTo(LinkedHashSet()) { it.rule.name }

    /** Exceptions by the names of the rules that failed or are not followed. */
    val failures: Map<String, Throwable> = report.results
        .filter { it.outcome.isBroken }
        .associate { it.rule.name to checkNotNull(it.failure).cause }

    companion object {
        /** The names of all rules. */
        val rules: Set<String> = SuiteRule.all.mapTo(LinkedHashSet()) { it.name }

        /** Rules that take seconds for any number of tries. */
        val longRules: List<String> = listOf(
            "rule_1_1_thousandsOfTilesAreDrawnCorrectly", "rule_8_1_promiseToStreamPrimitivesIsKept",
            "rule_7_9_renderingsHoldNoMoreMemory", "rule_7_3_promiseOfConstantMemoryIsKept",
            "rule_1_1_columnsAndRowsAreNotTruncated", "rule_5_3_allPairsOnATinyRasterAreDrawnCorrectly",
            "rule_6_6_texturesAreReadWithTheirOwnFootprints", "rule_9_4_indicesAreNotTruncated",
            "rule_7_5_tilesOfEverySizeGiveTheSamePicture", "rule_9_4_indicesAboveTwoToThe24AreExact",
        )

        /** The names of the other rules. */
        val quickRules: Set<String> = rules - longRules.toSet()

        /** Tests the renderers that [make] returns with [tries] times the default number of frames of [rules]. */
        fun of(tries: Double, rules: Set<String> = this.rules, make: () -> Renderer): SuiteRun {
            val conformance = Conformance(make).tries(tries).withoutShrinking()
            for (rule in rules) conformance.rule(rule)
            return SuiteRun(conformance.run())
        }

        /** Runs the suite [subject]: the rules named [rules], or all. */
        fun of(subject: KClass<out RendererConformance>, tries: Double, vararg rules: String): SuiteRun {
            val constructor = subject.java.getDeclaredConstructor().apply { isAccessible = true }
            val conformance = Conformance { constructor.newInstance().renderer() }.subject(subject.java)
            for (rule in rules) conformance.rule(rule)
            return SuiteRun(conformance.tries(tries).withoutShrinking().run())
        }

        /** Returns the annotation of the rule with this name. */
        fun annotation(rule: String): Rule =
            RendererConformance::class.java.methods.first { it.name == rule }.getAnnotation(Rule::class.java)

        /** Tests the renderers that [make] returns with some rules, without shrinking. */
        fun ofRules(rules: Collection<String>, make: () -> Renderer): SuiteRun {
            val conformance = Conformance(make).tries(1.0).withoutShrinking()
            for (rule in rules) conformance.rule(rule)
            if (RuleNames.frames in rules) conformance.frames(ownFrames)
            return SuiteRun(conformance.run())
        }

        /** A folder with a frame whose width does not occur among the suite's frames. */
        private val ownFrames: Path =
            listOf("src/test/resources", "conformance/src/test/resources").map { Path.of(it) }
                .first { Files.isDirectory(it) }.resolve("frames")

        /** Tests the renderers that [make] returns with one rule, with shrinking. */
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
