package dev.lazyz.conformance

import dev.lazyz.conformance.mutants.RuleNames
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.TimeUnit
import kotlin.io.path.exists
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** A renderer in a separate process: there is always a result, and no process remains. */
class SupervisionTest {
    @TempDir
    lateinit var folder: Path

    private val files by lazy { SupervisedFiles(folder) }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rendererThatHaltsHasCrashedAndTheOtherRulesAreTried() {
        val heard = ArrayList<String>()
        val outcome = files.supervision("halts", Duration.ofSeconds(20))
            .listener { rule, outcome, _ -> heard.add("$rule $outcome") }
            .run { files.report.exists() }
        assertEquals(0, outcome.code)
        val (ties, empty) = SupervisedRun.RULES
        assertEquals(listOf("$ties CRASHED", "$empty PASSED"), heard)
        assertTrue("ended the process: exit code 7\\nin\\nFrameBuilder(" in files.report.readText())
        assertEquals(setOf("crashed", "passed"), RecordedReport.read(files.report).outcomes.values.toSet())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rendererThatEndsTheProcessWhenItIsMadeIsReported() {
        for (name in listOf("exits when made", "halts when made")) {
            val reported = assertThrows(EndedEarlyException::class.java) {
                files.supervision(name, Duration.ofSeconds(20)).run { files.report.exists() }
            }
            assertEquals("the process ended while no rule was tried: exit code 0", reported.message)
            val words = "The process ends while the renderer is created, before the first rule"
            assertEquals(name.startsWith("exits"), words in reported.printed) { reported.printed }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun settingThatChangedBeforeTheFirstRuleIsFound() {
        files.supervision("sets the time zone when its class is loaded", Duration.ofSeconds(20))
            .run { files.report.exists() }
        assertTrue("leaves behind another default time zone" in files.report.readText())
        val outcomes = RecordedReport.read(files.report).outcomes
        assertEquals(mapOf(RuleNames.empty to "passed", RuleNames.tidy to "failed"), outcomes)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun processEndsWhenTheOneThatSupervisesItIsKilled() {
        val supervising = ChildJvm.start(listOf("-Xmx128m"), Supervising::class, "$folder")
        try {
            val deadline = System.nanoTime() + TimeUnit.MINUTES.toNanos(5)
            while (!files.journal.exists() || "." !in files.journal.readText()) {
                assertTrue(System.nanoTime() < deadline, "no rule is on trial")
                Thread.sleep(50)
            }
            val judging = supervising.children().toList().single()
            assertTrue(judging.isAlive)
            supervising.destroyForcibly().waitFor()
            judging.onExit().get(5, TimeUnit.MINUTES)
        } finally {
            supervising.descendants().forEach { it.destroyForcibly() }
            supervising.destroyForcibly()
        }
    }
}
