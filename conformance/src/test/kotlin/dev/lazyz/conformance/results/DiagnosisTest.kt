package dev.lazyz.conformance.results

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.judgement.ProcessEnded
import dev.lazyz.conformance.mutants.DisruptiveRenderers
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.Mistakes
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import dev.lazyz.conformance.rules.Symptom
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readLines
import kotlin.io.path.writeLines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Finds the rule that a mistake is about, among all the rules that it breaks. */
class DiagnosisTest {
    private val names = RuleNames

    private val record: Path = listOf("src/test/resources", "conformance/src/test/resources").map { Path.of(it) }
        .first { Files.isDirectory(it) }.resolve("mutants.csv")

    private fun broken(rule: String, vararg symptoms: Symptom) =
        Diagnosis.Broken(checkNotNull(SuiteRule.find(rule)), symptoms.toSet())

    private fun causes(vararg broken: Diagnosis.Broken) =
        Diagnosis.ofBroken(broken.toList()).causes.map { it.rule.name }

    /**
     * A line for each mistake and each set of symptoms that failures of rules have at a fifth of the default effort,
     * and these rules. `-Dlazyz.record=true` rewrites it, which takes minutes.
     */
    private fun recorded(): Map<Mistake, List<Diagnosis.Broken>> {
        val lines = record.readLines().drop(1).map { it.split(',') }.groupBy { (id) -> id }
        return Mistakes.all.filter { it.id in lines }.associateWith { mistake ->
            lines.getValue(mistake.id).flatMap { (_, symptoms, rules) ->
                val all = symptoms.split(' ').filter { it.isNotEmpty() }.mapTo(LinkedHashSet()) { Symptom.valueOf(it) }
                rules.split(' ').mapNotNull { SuiteRule.find(it) }
                    .map { Diagnosis.Broken(it, all.takeIf { it.isNotEmpty() }) }
            }
        }
    }

    private fun record() {
        val lines = mutableListOf(record.readLines().first())
        for (mistake in Mistakes.all) {
            val conformance = Conformance { mistake.make() }.tries(0.2).withoutShrinking()

            // Some render a frame of very many primitives once for each of them
            for (rule in SuiteRun.rules - names.many + mistake.noticedBy) conformance.rule(rule)
            val broken = conformance.run().results.filter { it.failure != null }
            for ((symptoms, results) in broken.groupBy { it.failure?.symptoms.orEmpty() }) {
                lines += "${mistake.id},${symptoms.joinToString(" ")},${results.joinToString(" ") { it.rule.name }}"
            }
            record.writeLines(lines)
        }
    }

    /** At least nine of ten, on failures that are not shrunk, which contain less information. */
    @Test
    fun oneOfTheRulesThatAWrongRendererIsAboutIsAmongTheFirstThree() {
        if (System.getProperty("lazyz.record") == "true") record()
        val all = recorded()
        val missed = all.filter { (mistake, broken) ->
            Diagnosis.ofBroken(broken).causes.none { it.rule.name in mistake.noticedBy }
        }
        val share = "${all.size - missed.size} of ${all.size} wrong renderers are diagnosed"
        val lines = missed.map { (mistake, broken) ->
            "${mistake.id}: ${Diagnosis.ofBroken(broken).causes.map { it.rule }}, not ${mistake.noticedBy}"
        }
        assertTrue(all.size > 60, share)
        assertTrue(missed.size * 10 <= all.size, "$share:\n${lines.joinToString("\n")}")
    }

    @Test
    fun symptomOfAllFailuresIsTheCause() {
        val tie = arrayOf(Symptom.PICTURE, Symptom.TIE)
        val all = arrayOf(broken(names.nearest, *tie), broken(names.halves, *tie), broken(names.ties, *tie))
        assertEquals(names.ties, causes(*all).first())
        val other = arrayOf(Symptom.PICTURE, Symptom.ORDER)
        assertEquals(names.nearest, causes(broken(names.nearest, *other), broken(names.halves, *other), all[2]).first())
    }

    @Test
    fun whatOnlyShouldBeIsNamedAfterWhatMust() {
        val counters = arrayOf(Symptom.COUNTERS)
        val causes = causes(broken(names.memoryReport, *counters), broken(names.passes, *counters))
        assertEquals(listOf(names.passes, names.memoryReport), causes)
    }

    @Test
    fun whatIsUsualIsNamedBeforeWhatIsRare() {
        val glass = arrayOf(Symptom.PICTURE, Symptom.TRANSLUCENT)
        val causes = causes(broken(names.extremes, *glass), broken(names.blend, *glass))
        assertEquals(listOf(names.blend, names.extremes), causes)
        assertEquals(listOf(names.extremes), causes(broken(names.extremes, *glass)))
    }

    /** What is wrong most often is said instead of that something is. */
    @Test
    fun wrongPictureInGeneralIsTheLastCause() {
        val depth = arrayOf(Symptom.PICTURE, Symptom.DEPTH)
        val all = arrayOf(broken(names.nearest, *depth), broken(names.own, *depth), broken(names.empty, *depth))
        val first = Diagnosis.ofBroken(all.toList()).causes.first()
        assertEquals(names.nearest, first.rule.name)
        assertEquals("in 3 of 3 failures the correct primitive has a wrong depth", first.why)
        val ties = arrayOf(Symptom.PICTURE, Symptom.TIE, Symptom.GREATEST_WINS)
        val tied = listOf(names.nearest, names.ties, names.own, names.options).map { broken(it, *ties) }
        assertEquals(names.ties, Diagnosis.ofBroken(tied).causes.first().rule.name)
        assertTrue(Diagnosis.ofBroken(tied).causes.indexOfFirst { it.rule.name == names.nearest } != 1)
    }

    /** Where it is thrown says more than what the frames have in common. */
    @Test
    fun exceptionsOfMostFailuresAreSaid() {
        val thrown = arrayOf(Symptom.PICTURE, Symptom.EXCEPTION)
        val all = listOf(broken(names.tests, *thrown, Symptom.GREATEST_WINS), broken(names.own, *thrown))
        val whys = Diagnosis.ofBroken(all).causes.map { it.why }
        assertTrue("in 2 of 2 failures the renderer throws" in whys, whys.toString())
        assertEquals("Look where the exception is thrown.", RuleResult.crashLook(IllegalStateException()))
    }

    @Test
    fun crashesHaveHintsOfTheirOwn() {
        val hints = mapOf(
            DisruptiveRenderers.exhausts() to "arrays that are sized",
            DisruptiveRenderers.recurses() to "recursion whose"
        )
        for ((renderer, hint) in hints) {
            val report = Conformance { renderer }.tries(0.05).withoutShrinking()
                .rule(names.nearest).rule(names.ties).run()
            val (cause) = report.diagnosis.causes
            assertTrue(hint in cause.look, report.toText())
            assertTrue("failures the renderer throws java.lang." in cause.why, cause.why)
            assertEquals(1, report.diagnosis.causes.size, "the same crash once")
        }
        assertTrue("System.exit" in RuleResult.crashLook(ProcessEnded("ended")).orEmpty())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun reportBeginsWithTheCauseAndIsShortHoweverMuchFails() {
        val suite = Conformance { BasicMistakes.lastWinsTies() }.tries(0.02).withoutShrinking()

        // Those about pictures, without the ones that take seconds
        val chapters = listOf("rule_2_", "rule_4_", "rule_5_")
        for (rule in SuiteRun.quickRules) {
            if (chapters.any(rule::startsWith) && "Million" !in rule && "million" !in rule) suite.rule(rule)
        }
        val report = suite.run()
        val text = report.toText()
        assertTrue(report.results.count { it.outcome.isFailure } > 10, text)
        val lines = text.lines()
        assertTrue(lines[0].startsWith("last-wins-ties does NOT conform: "), lines[0])
        assertEquals("Likely causes, best first", lines[2])
        assertTrue(lines[3].startsWith("  1. ${names.ties}: in "), lines[3])
        assertTrue(lines.size <= report.results.size + 120, "${lines.size} lines")
        assertEquals(3, lines.count { it.startsWith("FAILED: ") })
    }
}
