package dev.lazyz.conformance.run

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.NotMadeException
import dev.lazyz.conformance.mutants.DisruptiveRenderers
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.mutants.wrappers.FailureMistakes
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.appendText
import kotlin.io.path.createFile
import kotlin.io.path.readLines
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Whatever a renderer does, a run ends and reports it. */
class RunTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val ties = "rule_5_2_tiesGoToTheFirstSubmitted"

    private fun of(make: () -> Renderer) = Conformance(make).tries(0.1)

    private fun Conformance.impatient() = deadline(Duration.ofMillis(300))

    private fun nearest(make: () -> Renderer): RuleResult = of(make).rule(nearest).run().results.single()

    /** A machine that is too busy gives no verdict, so asks again, and skips the test if that goes on. */
    private fun <T> verdict(isInconclusive: (T) -> Boolean, ask: () -> T): T {
        val answer = generateSequence(ask).take(MOST_REQUESTS).firstOrNull { !isInconclusive(it) }
        assumeTrue(answer != null, "the machine is too busy")
        return answer!!
    }

    private fun assertOutcome(expected: RuleOutcome, result: RuleResult) =
        assertEquals(expected, result.outcome) { result.message }

    @Test
    fun hangingRendererTimesOutWithTheFrameAndThePlace() {
        val isAsleep = "was not over after 0.3 s in which no thread was running; it is at"
        val isBusy = "was not over after 0.3 s of processor time; it is at"
        val hanging = listOf(
            Triple(DisruptiveRenderers.sleeps(), isAsleep, "java.lang.Thread.sleep("),
            Triple(DisruptiveRenderers.spins(), isBusy, ".DisruptiveRenderers"),
            Triple(DisruptiveRenderers.waits(), isAsleep, "thread never-done (WAITING)"),
        )
        for ((renderer, words, place) in hanging) {
            // What is busy may get no processor for so long that it seems to be asleep
            fun isStarved(result: RuleResult) = words == isBusy && isAsleep in result.message
            val result = verdict({ it.outcome == RuleOutcome.INCONCLUSIVE || isStarved(it) }) {
                of { renderer }.impatient().rule(nearest).run().results.single()
            }
            assertOutcome(RuleOutcome.TIMED_OUT, result)
            assertTrue(words in result.message, result.message)
            assertTrue(place in result.message, result.message)
            assertTrue(".DisruptiveRenderers" in result.message, result.message)
            assertTrue("\nin\nFrameBuilder(Raster(" in result.message, result.message)
            assertTrue(result.failure?.code.orEmpty() in result.message)
            assertEquals(words == isBusy, "a loop that does not end" in result.look, result.look)
            assertEquals(words == isAsleep, "a thread that waits" in result.look, result.look)
        }
    }

    /** It gets no more processor time than on a machine that is very busy. */
    @Test
    fun whatIsNeitherBusyNorAsleepIsInconclusive() {
        val run = verdict({ it.results.single().outcome == RuleOutcome.TIMED_OUT }) {
            of { DisruptiveRenderers.dozes() }.impatient().rule(nearest).run()
        }
        val result = run.results.single()
        assertOutcome(RuleOutcome.INCONCLUSIVE, result)
        assertTrue(result.message.startsWith("was not over after 3 s, but the machine gave it only 0"), result.message)
        assertTrue("--deadline" in result.look, result.look)
        assertNull(result.failure)
        assertTrue(run.isInconclusive && !run.isConformant)
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun inconclusiveRunSaysSoInEveryReport(@TempDir folder: Path) {
        val journal = folder.resolve("journal")
        val rules = SuiteRule.matching("5.1").map { it.name }
        journal.createFile()
        for (rule in rules.take(3)) {
            journal.appendText("$rule .")
            assertTrue(Journal.ended(journal, "the process made no progress for 230 s", RuleOutcome.INCONCLUSIVE))
        }
        val run = of { PlainRenderer() }.journal(journal).rule("5.1").run()
        assertTrue(run.results.all { it.outcome == RuleOutcome.INCONCLUSIVE }, run.toText())
        assertEquals("3 earlier rules are inconclusive", run.results[3].message)
        assertTrue(run.isInconclusive && !run.isConformant)
        val count = "${rules.size} inconclusive"
        assertTrue("plain may conform, this run is inconclusive: ${rules.size} rules, $count;" in run.toText())
        assertTrue("INCONCLUSIVE: ${rules[0]} (MUST)" in run.toText(), run.toText())
        assertTrue("\"conformant\": false,\n    \"inconclusive\": true" in run.toJson(), run.toJson())
        assertTrue("failures=\"0\" errors=\"${rules.size}\" skipped=\"0\"" in run.toJUnitXml(), run.toJUnitXml())
        assertTrue("<error type=\"inconclusive\" message=\"ended the process: " in run.toJUnitXml())
        assertTrue("<h2>Inconclusive</h2>" in run.toHtml())
    }

    @Test
    fun rendererThatIsNeverMadeIsReportedWithThePlace() {
        val hanging = listOf(
            { DisruptiveRenderers.never() },
            {
                object : PlainRenderer() {
                    override val capabilities: Set<Capability> get() = DisruptiveRenderers.never()
                }
            },
        )
        for (make in hanging) {
            val reported = verdict({ "the machine gave it only" in it }) {
                assertThrows(NotMadeException::class.java) { of(make).impatient().run() }.message.orEmpty()
            }
            val words = "making the renderer was not over after 0.3 s in which no thread was running; it is at"
            assertTrue(reported.startsWith(words), reported)
            assertTrue("DisruptiveRenderers.never" in reported, reported)
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun listenerLearnsWhatCameOfEachRule() {
        val heard = ArrayList<String>()
        val run = of { WrongColors() }.rule("9.6").rule("5.2")
            .listener { rule, outcome, milliseconds -> heard.add("$rule $outcome $milliseconds") }.run()
        assertEquals(run.results.map { "${it.rule} ${it.outcome} ${it.milliseconds}" }.sorted(), heard.sorted())
        assertTrue(run.results.size > 2)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun slowRendererIsNotTakenForHanging() {
        val slow = object : PlainRenderer() {
            override fun render(frame: Frame, sink: RowSink): Counters {
                Thread.sleep(100)
                return super.render(frame, sink)
            }
        }
        val result = verdict({ it.outcome == RuleOutcome.INCONCLUSIVE }) {
            of { slow }.deadline(Duration.ofSeconds(1)).tries(0.01).rule("rule_5_3_everyDepthTestIsObeyed").run()
                .results.single()
        }
        assertTrue(result.milliseconds > 1000)
        assertOutcome(RuleOutcome.PASSED, result)
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun otherRulesAreTriedUntilThreeHaveTimedOut() {
        val last = "rule_9_6_narrowRastersAreDrawnCorrectly"
        val rules = listOf("rule_1_3_movingByWholePixelsMovesThePicture", "5.1", ties, last)
        val run = verdict({ it.isInconclusive }) {
            of { DisruptiveRenderers.sleeps() }.impatient().also { for (rule in rules) it.rule(rule) }.run()
        }
        val outcomes = run.results.map { it.outcome }
        assertEquals(3, outcomes.count { it == RuleOutcome.TIMED_OUT }) { run.toText() }
        assertTrue(outcomes.takeLast(2).all { it == RuleOutcome.NOT_RUN }, run.toText())
        assertEquals("3 earlier rules timed out or ended the process", run.results.last().message)
        assertEquals(0, run.results.last().tries)
    }

    @Test
    fun errorsAreCrashesOfOneRule() {
        val renderers = mapOf(
            DisruptiveRenderers.exhausts() to "java.lang.OutOfMemoryError",
            DisruptiveRenderers.recurses() to "java.lang.StackOverflowError",
            DisruptiveRenderers.forgets() to "kotlin.NotImplementedError",
            DisruptiveRenderers.dies() to "java.lang.ThreadDeath",
        )
        for ((renderer, error) in renderers) {
            val run = of { renderer }.rule(nearest)
                .rule("rule_9_6_framesWithoutPrimitivesShowTheBackground").run()
            assertOutcome(RuleOutcome.CRASHED, run.results.first())
            assertOutcome(RuleOutcome.PASSED, run.results.last())
            assertTrue("threw $error" in run.results.first().message, run.results.first().message)
            assertNotNull(run.results.first().failure?.code)
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun failureThatIsNotReproducibleIsFlakyAndKeepsWhatCameBefore() {
        for (renderer in listOf(DisruptiveRenderers.racy(), DisruptiveRenderers.stateful())) {
            val result = nearest { renderer }
            assertOutcome(RuleOutcome.FLAKY, result)
            assertTrue(result.message.startsWith("not reproducible: "), result.message)
            val failure = checkNotNull(result.failure)
            assertTrue(failure.before.isNotEmpty(), renderer.id)
            assertTrue(failure.message !in result.message, "reports print both messages: ${result.message}")
        }
    }

    @Test
    fun reportOfAFailureInterruptsNobody() {
        val report = Conformance { FailureMistakes.stopsInterruptedWorkers() }
            .rule("rule_7_8_interruptedWorkersFinishTheirWork").run()
        // On a busy machine, the threads do not do the same again
        assertTrue(report.results.single().outcome.isFailure, report.toText())
        assertTrue("Likely cause" in report.toText(), report.toText())
        assertFalse(Thread.interrupted())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun shrinkingIsBoundedAndLeavesNoThread() {
        var calls = 0
        val before = Thread.getAllStackTraces().keys
        val report = of {
            calls++
            WrongColors()
        }.rule("5.1").rule("5.2").run()
        val broken = report.results.filter { it.outcome == RuleOutcome.FAILED }
        assertTrue(broken.size > RuleFailures.MOST_SHRUNK, report.toText())

        // Each failure: first the tries, then the shrinking steps, then its repetitions
        val tries = report.results.sumOf { it.tries }
        val most =
            RuleFailures.MOST_SHRUNK * Settings.MANY_STEPS +
                (broken.size - RuleFailures.MOST_SHRUNK) * Settings.FEW_STEPS
        assertTrue(calls <= tries + most + 4 * broken.size, "$calls calls")
        val end = System.nanoTime() + NET.toNanos()
        fun more() = Thread.getAllStackTraces().keys - before
        while (more().isNotEmpty() && System.nanoTime() < end) Thread.sleep(1)
        assertEquals(emptySet<Thread>(), more())
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun runWhoseProcessEndedIsTakenUp(@TempDir folder: Path) {
        val journal = folder.resolve("journal")
        assertFalse(Journal.ended(journal, "exit code 3", RuleOutcome.CRASHED))
        journal.writeText("rule_4_3_backgroundIsVisibleWhereNoFragmentPasses ... PASSED\n$nearest ....")
        assertTrue(Journal.ended(journal, "exit code 3", RuleOutcome.CRASHED))

        var calls = 0
        val run = of {
            calls++
            PlainRenderer()
        }.journal(journal).rule(nearest).rule(ties).run()
        val (crashed, passed) = run.results
        assertOutcome(RuleOutcome.CRASHED, crashed)
        assertTrue(crashed.message.startsWith("ended the process: exit code 3\nin\nFrameBuilder("), crashed.message)
        assertEquals(4, crashed.tries)
        assertOutcome(RuleOutcome.PASSED, passed)
        assertEquals(1 + passed.tries, calls, "no try of the rule that has crashed")
        val lines = journal.readLines()
        assertEquals("$nearest .... ! CRASHED exit code 3", lines[1])
        assertEquals("$ties ${".".repeat(passed.tries)} PASSED ${passed.milliseconds}", lines.last())
    }

    private companion object {
        const val MOST_REQUESTS = 5

        /** Long enough for a thread that ends. */
        val NET: Duration = Duration.ofMinutes(1)
    }
}
