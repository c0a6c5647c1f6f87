package dev.lazyz.conformance.corpus

import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.results.RuleOutcome
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectory
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeLines
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir

/** Programs that draw the corpus, good ones and hostile ones. The good one is in C, and needs a compiler. */
@DisabledOnOs(OS.WINDOWS)
class ProgramTest {
    @TempDir
    lateinit var folder: Path

    private val all = "{scene} {picture} {depth} {primitive}"

    private fun report(command: String, rule: String, baseline: Path? = null): ConformanceReport {
        val run = ProgramConformance(command).rule(rule).tries(0.2).jobs(2).deadline(Duration.ofMillis(500))
        baseline?.let { run.baseline(it) }
        return run.run()
    }

    /** Returns the program that the C file of the page makes, perhaps with a mistake. */
    private fun compiled(mistake: Int): Path {
        val program = folder.resolve("exact$mistake")
        assumeTrue(ends("cc", "--version"), "there is no C compiler")
        val source = Path.of("corpus/exact.c")
        assertTrue(ends("cc", "-O1", "-DMISTAKE=$mistake", "-o", "$program", "$source", "-lm"))
        return program
    }

    private fun ends(vararg words: String): Boolean = try {
        val process = ProcessBuilder(*words).redirectErrorStream(true).redirectOutput(folder.resolve("log").toFile())
        process.start().waitFor() == 0
    } catch (_: IOException) {
        false
    }

    @Test
    fun rightProgramConforms() {
        val report = report("${compiled(0)} $all", "2.4")
        assertTrue(report.isConformant, report.toText())
        assertEquals(listOf("rule_2_4_holes", "rule_2_4_selfCrossing"), report.results.map { it.rule.name })
        assertTrue(report.results.all { Regex("(\\d exact)?(, )?(\\d within)?").matches(it.message) }, report.toText())
        assertTrue(
            "zcli conformance --program '${folder.resolve("exact0")} $all' --seed" in report.toJUnitXml() +
                report.commandFor(report.results[0].rule)
        )
    }

    @Test
    fun mistakesAreFoundAndReduced() {
        for ((mistake, rule) in listOf(1 to "rule_2_4_holes", 2 to "rule_5_2_ties", 3 to "rule_5_5_translucent")) {
            val report = report("${compiled(mistake)} {scene} {picture}", rule)
            assertEquals(RuleOutcome.FAILED, report.results.single().outcome, report.toText())
            val scene = checkNotNull(report.results[0].failure?.sceneFile)
            assertTrue(scene.lines().size < 11, scene)
        }
    }

    @Test
    fun baselineTellsNewFailuresAndNewPasses() {
        val wrong = "${compiled(2)} {scene} {picture}"
        val baseline = folder.resolve("baseline.csv")
        assertEquals(RuleOutcome.FAILED, report(wrong, "5.2", baseline).results[0].outcome)
        val lines = baseline.readLines()
        assertEquals(listOf("01", "02", "03", "04").map { "04-ties-$it,wrong" }, lines.takeLast(4))
        val known = report(wrong, "5.2", baseline).results[0]
        assertEquals(RuleOutcome.WAIVED, known.outcome)
        assertTrue("failed before: 04-ties-01, 04-ties-02, 04-ties-03, 04-ties-04" in known.message, known.message)
        val better = report("${compiled(0)} {scene} {picture}", "5.2", baseline).results[0]
        assertEquals(RuleOutcome.WAIVED_BUT_PASSES, better.outcome)
        assertTrue("new passes: 04-ties-01, " in better.message, better.message)
        baseline.writeLines(lines.map { it.replace("ties-03,wrong", "ties-03,exact") })
        val worse = report(wrong, "5.2", baseline).results[0]
        assertEquals(RuleOutcome.FAILED, worse.outcome)
        assertTrue(worse.message.endsWith("; new failures: 04-ties-03"), worse.message)
        baseline.writeText("scene,result\n04-ties-01,good\n")
        assertThrows(IllegalArgumentException::class.java) { report(wrong, "5.2", baseline) }
    }

    private fun outcome(command: String): Pair<RuleOutcome, String> {
        val result = report("$command; : {scene} {picture}", "5.2").results.single()
        return result.outcome to "${result.message}\n${result.failure}"
    }

    @Test
    fun programsWithoutAPictureFail() {
        for ((command, words) in listOf(
            "true" to "there is no such file",
            "echo oops > {picture}" to "is not a picture",
            "cp ../docs/images/teapot.png {picture}" to "has 640 x 480 pixels, not ",
            "yes much | head -c 3000000" to "there is no such file",
            "head -c 100000000 /dev/zero > {picture}; exit 0" to " 32000000 bytes",
        )) {
            val (outcome, message) = outcome(command)
            assertEquals(RuleOutcome.FAILED, outcome, message)
            assertTrue(words in message, message)
        }
        val (outcome, message) = outcome("echo why; exit 7")
        assertEquals(RuleOutcome.CRASHED, outcome)
        assertTrue("exit code 7; it printed\nwhy" in message, message)
        assertEquals(RuleOutcome.NOT_SUPPORTED, outcome("exit 3").first)
        assertThrows(IllegalArgumentException::class.java) { ProgramConformance("draw {scene}") }
    }

    /** The first scene waits until a second one is drawn, too; one of the four crashes. */
    @Test
    fun scenesAreDrawnAtTheSameTimeAndCrashAlone() {
        val both = folder.resolve("both").createDirectory()
        val wait = "touch $both/$$; while [ $(ls $both | wc -l) -lt 2 ]; do sleep 0.01; done"
        val crash = "if grep -q ties-02 {scene}; then kill -SEGV $$; fi"
        val result = report("$wait; $crash; ${compiled(0)} {scene} {picture}", "5.2").results.single()
        assertEquals(RuleOutcome.CRASHED, result.outcome, result.message)
        assertEquals("3 exact, 1 crashed", result.message)
    }

    @Test
    fun programsThatDoNotEndAreEnded() {
        val pid = folder.resolve("pid")
        for (command in listOf(
            "trap '' TERM INT; while :; do :; done",
            "sh -c 'echo $$ > $pid; exec sleep 3000' & sleep 3000",
        )) {
            val (outcome, message) = outcome(command)

            // On a machine that gives the program no half second in five, it is not known whether it is too slow
            assertTrue(outcome == RuleOutcome.TIMED_OUT || outcome == RuleOutcome.INCONCLUSIVE, message)
            assertTrue("was not over after" in message || outcome == RuleOutcome.INCONCLUSIVE, message)
        }
        val child = ProcessHandle.of(pid.readText().trim().toLong())
        assertTrue(child.isEmpty || child.get().onExit().get(1, TimeUnit.MINUTES) != null)
    }

    /** The reader in Python gives the same verdicts, where Python with NumPy is. */
    @Test
    fun readerComparesThePictures() {
        assumeTrue(ends("python3", "-c", "import numpy"), "there is no Python with NumPy")
        val corpus = folder.resolve("corpus")
        CorpusFiles.write(corpus)
        Files.list(corpus).use { paths ->
            paths.filter { !Regex("(04-ties|15-translucent)-.*").matches("${it.fileName}") }.forEach(Files::delete)
        }
        for ((mistake, last) in listOf(0 to "37 exact, 3 within", 2 to "24 wrong, 14 exact, 2 within")) {
            val program = compiled(mistake)
            assertEquals(mistake == 0, ends("python3", "corpus/corpus.py", "$corpus", "$program $all"))
            assertEquals(last, folder.resolve("log").readLines().last())
        }
        assertFalse(ends("python3", "corpus/corpus.py", "$corpus", "echo oops > {picture}"))
        assertEquals("40 wrong", folder.resolve("log").readLines().last())
    }
}
