package dev.lazyz.cli.conformance

import dev.lazyz.cli.CapableRenderer
import dev.lazyz.cli.DozingRenderer
import dev.lazyz.cli.ExitingRenderer
import dev.lazyz.cli.FickleRenderer
import dev.lazyz.cli.SpeechlessRenderer
import dev.lazyz.cli.StillbornRenderer
import dev.lazyz.cli.StutteringRenderer
import dev.lazyz.cli.UnbornRenderer
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.rendererJar
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.nio.file.Path
import java.util.concurrent.locks.LockSupport
import kotlin.concurrent.thread
import kotlin.io.path.createDirectory
import kotlin.io.path.createTempFile
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** `zcli conformance` on strategies in third-party jars. */
class ConformanceTest {
    @TempDir
    lateinit var folder: Path

    private val ties = "rule_5_2_tiesGoToTheFirstSubmitted"

    private fun jar(vararg classes: Class<*>, name: String = "mine.jar"): Path =
        folder.rendererJar(*classes, name = name)

    /** Runs in this process, which is faster. */
    private fun judge(vararg words: Any) = zcli("conformance", "--in-process", "--quiet", *words)

    private fun conformance(vararg words: Any) = judge("--tries", "0.05", *words)

    /** The child process measures memory with the collector that users chose, or with the one that is exact. */
    @Test
    fun childKeepsAChosenCollector() {
        val heap = listOf("-Xmx1g", "-XX:+UseStringDeduplication")
        assertEquals(listOf("-XX:+UseZGC") + heap, ConformanceProcess.inherited(listOf("-XX:+UseZGC") + heap))
        val exact = "-XX:MarkSweepAlwaysCompactCount=1"
        for (serial in listOf(emptyList(), listOf("-XX:+UseSerialGC"))) {
            val child = ConformanceProcess.inherited(serial + heap + "-Xlog:gc:file=gc.log")
            assertEquals(listOf("-XX:+UseSerialGC", exact) + serial + heap, child)
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun strangerThatConformsIsReported() {
        val jar = jar(CapableRenderer::class.java)
        val rules = arrayOf("--rule", "4.3", "--rule", "rule_7_3_rowsArriveInOrderEachOnce")
        val run = conformance("--strategy", "capable", "--classpath", jar, *rules).done()
        assertTrue("capable conforms: 2 rules, 2 passed" in run.text, run.text)
        assertTrue("seed          1995, tries x0.05" in run.text, run.text)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun mistakeIsReportedWithTheCommandThatShowsItAgain() {
        val jar = jar(FickleRenderer::class.java, StutteringRenderer::class.java)
        val report = folder.resolve("a report")
        val rule = "rule_7_3_rowsArriveInOrderEachOnce"
        val words = listOf("--strategy", "stuttering", "--classpath", "$jar", "--rule", rule, "--seed", "3")
        val run = judge(*words.toTypedArray(), "--tries", "1", "--report", report)
        assertEquals(ExitCode.DIFFERENT, run.code, run.errors)
        assertEquals("", run.errors)
        assertTrue("\nFAILED: $rule (MUST)\n" in run.text, run.text)
        assertTrue("rows arrived as [0, 1, 2, 3, 4, 5, 6, 7, 7" in run.text, run.text)
        val command = "zcli conformance --strategy stuttering --classpath $jar --seed 3 --tries 1 --rule $rule"
        assertTrue("  reproduce   $command\n" in run.text, run.text)
        assertTrue(report.resolve("report.html").exists() && report.resolve("failures/$rule.kt").exists())
        assertEquals(run.text, report.resolve("report.txt").readText())

        // The command shows the same failure
        val again = judge(*command.split(" ").drop(2).toTypedArray())
        fun failure(text: String) =
            text.substringAfter("FAILED").substringBefore("reproduce").substringBefore("scene file")
        assertEquals(failure(run.text), failure(again.text))
    }

    /** Another process, here a thread of this one, makes temporary files all the time. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun filesOfOtherProcessesAreNotTheStrategys() {
        val files = ArrayList<Path>()
        val other = thread {
            while (!Thread.interrupted()) {
                files.add(createTempFile("lazyz-other"))
                LockSupport.parkNanos(500_000)
            }
        }
        try {
            val rule = "rule_7_9_renderingsLeaveNothingBehind"
            val run = zcli("conformance", "--quiet", "--strategy", "zbuffer", "--rule", rule).done()
            assertTrue("zbuffer conforms: 1 rule, 1 passed" in run.text, run.text)
        } finally {
            other.interrupt()
            other.join()
            files.forEach { it.deleteIfExists() }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun waiversAreHeeded() {
        val jar = jar(StutteringRenderer::class.java)
        val file = folder.resolve("waivers.txt")
        val rule = "rule_7_3_rowsArriveInOrderEachOnce"
        val words = arrayOf("--strategy", "stuttering", "--classpath", jar, "--rule", rule, "--tries", "1")
        val block = "rule: $rule\nreason: stutters\nlink: none\nexpires: 9999-01-01\n"
        file.writeText(block)
        val run = judge(*words, "--waivers", file).done()
        assertTrue("conforms: 1 rule, 1 waived" in run.text, run.text)
        file.writeText(block.replace("link", "lnik"))
        judge(*words, "--waivers", file).mistake("waivers.txt:3: expected 'rule:'")
        judge(*words, "--waivers", "none").mistake("cannot read the waivers file none: there is no such file\n")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun reportIsVerified() {
        val jar = jar(StutteringRenderer::class.java)
        val report = folder.resolve("report")
        val words = arrayOf("--strategy", "stuttering", "--classpath", jar, "--report", report, "--rule", "7.3")
        assertEquals(ExitCode.DIFFERENT, conformance(*words).code)
        val file = report.resolve("report.json")
        val run = judge("--verify", file, "--classpath", jar).done()
        assertTrue(run.text.startsWith("verified: stuttering, "), run.text)
        val other = judge("--verify", file, "--strategy", "zbuffer")
        assertEquals(ExitCode.DIFFERENT, other.code)
        val rule = "rule_7_3_rowsArriveInOrderEachOnce"
        assertTrue("NOT verified: zbuffer, " in other.text, other.text)
        assertTrue("$rule: recorded failed, now passed" in other.text, other.text)
        judge("--verify", file, "--seed", "1").mistake("--verify takes seed, tries, rules and waivers")
        file.writeText("{}")
        judge("--verify", file).mistake("report.json is no report.json of the conformance suite")
        judge("--verify", "none.json").mistake("the report none.json cannot be read: there is no such file\n")
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun exploringAgainWithTheSeedOfASummaryIsTheSame() {
        fun frames(text: String) = text.lines().dropWhile { " frames, of which" !in it }.dropLast(2)
        val rule = arrayOf("--strategy", "zbuffer", "--rule", ties)
        val explored = conformance(*rule, "--explore").done().text
        val seed = checkNotNull(Regex("""(?m)^seed +(\d+), tries x0.05$""").find(explored)) { explored }.groupValues[1]
        assertTrue(frames(explored).size > 5, explored)
        assertEquals(frames(explored), frames(conformance(*rule, "--seed", seed).done().text))
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun numberOfTriesHasBounds() {
        val narrow = "rule_9_6_narrowRastersAreDrawnCorrectly"
        fun tries(factor: String) = judge("--strategy", "zbuffer", "--rule", narrow, "--tries", factor)
        val least = tries("0.001").done()
        assertTrue(", tries x0.001\n" in least.text && "     1 tries" in least.text, least.text)
        for (factor in listOf("0", "0.00099", "1000001")) {
            tries(factor).mistake("--tries: must be in 0.001..1000000")
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun strategyThatCannotSayWhatItIsCapableOfDoesNotConform() {
        val jar = jar(SpeechlessRenderer::class.java)
        val run = conformance("--strategy", "speechless", "--classpath", jar, "--rule", "8.2")
        assertEquals(ExitCode.DIFFERENT, run.code)
        assertTrue("what can I do?" in run.text, run.text)
        assertTrue("speechless does NOT conform" in run.text, run.text)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun strategyThatExitsGetsAVerdictAndTheOtherRulesAreTried() {
        val jar = jar(ExitingRenderer::class.java)
        val rules = arrayOf("--rule", ties, "--rule", "rule_9_6_framesWithoutPrimitivesShowTheBackground")
        val words = arrayOf("--strategy", "exiting", "--classpath", jar, "--tries", "0.05", "--json")
        val run = zcli("conformance", *words, *rules)
        assertEquals(ExitCode.DIFFERENT, run.code, run.errors)
        assertTrue(run.text.startsWith("{") && run.text.endsWith("}\n"), run.text)
        assertEquals("false", run.stat("conformant"))
        assertEquals("1", run.stat("crashed"))
        assertEquals("1", run.stat("passed"))
        assertTrue("ended the process: exit code 0\\nin\\nFrameBuilder(" in run.text, run.text)
        assertTrue("going on" in run.errors, run.errors)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun eachRuleIsReportedAsSoonAsItHasEnded() {
        val rules = arrayOf("--rule", "4.3", "--rule", "rule_5_5_dozensOfThinLayersBlend")
        for (where in listOf(arrayOf("--in-process"), arrayOf())) {
            val words = arrayOf("--strategy", "zbuffer", "--tries", "0.05", *rules)
            val run = zcli("conformance", *where, *words)
            val reported = listOf("passed         rule_4_3_back", "not supported  rule_5_5_dozens")
            assertTrue(reported.all { it in run.errors }, run.errors)
            assertTrue(run.errors.lines().filter { it.isNotEmpty() }.all { it.endsWith(" s") }, run.errors)
            assertTrue(run.text.startsWith("zbuffer conforms: 2 rules, "), run.text)
            assertEquals("", zcli("conformance", *where, *words, "--quiet").errors)
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun strategyThatEndsTheProcessAtOnceGetsAVerdict() {
        val run = zcli("conformance", "--strategy", "stillborn", "--classpath", jar(StillbornRenderer::class.java))
        assertEquals(ExitCode.DIFFERENT, run.code)
        val words = "stillborn does NOT conform: the process ended while no rule was tried: exit code 0"
        assertTrue(words in run.errors, run.errors)
    }

    /** It runs a little now and then, as on a machine that is very busy. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whatCannotBeJudgedHasAnExitCodeOfItsOwn() {
        val jar = jar(DozingRenderer::class.java)
        val rule = "rule_9_6_framesWithoutPrimitivesShowTheBackground"
        val run = judge("--strategy", "dozing", "--classpath", jar, "--rule", rule, "--deadline", "1")
        assertEquals(ExitCode.INCONCLUSIVE, run.code, run.errors)
        assertTrue("dozing may conform, this run is inconclusive: 1 rule, 1 inconclusive" in run.text, run.text)
        assertTrue("with a longer deadline (zcli: --deadline SECONDS" in run.text, run.text)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun jarWithABlankInItsNameIsQuotedInTheCommand() {
        val jar = jar(StutteringRenderer::class.java, name = "my jar.jar")
        val rule = "rule_7_3_rowsArriveInOrderEachOnce"
        val run = judge("--strategy", "stuttering", "--classpath", jar, "--rule", rule, "--seed", "3")
        assertTrue("zcli conformance --strategy stuttering --classpath '$jar' --seed 3" in run.text, run.text)

        // So is everything else that means something to a shell
        val odd = jar(StutteringRenderer::class.java, name = "it's\$x&y.jar")
        val other = judge("--strategy", "stuttering", "--classpath", odd, "--rule", rule, "--seed", "3")
        val quoted = "'" + "$odd".replace("'", "'\\''") + "'"
        assertTrue("zcli conformance --strategy stuttering --classpath $quoted --seed 3" in other.text, other.text)
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun mistakesAreReportedInWords() {
        val jar = jar(CapableRenderer::class.java)
        conformance("--strategy", "capabel", "--classpath", jar)
            .mistake("no strategy 'capabel'; did you mean 'capable'?")
        conformance("--strategy", "other", "--classpath", jar).mistake("no strategy 'other'", "offers capable.")
        conformance("--strategy", "other", "--classpath", folder)
            .mistake("Nothing on the class path is named in META-INF")
        conformance("--strategy", "other").mistake("no strategy 'other'", "--classpath JAR")
        conformance("--strategy", "zbuffer", "--classpath", "no.jar").mistake("--classpath: no.jar: no such file")
        val text = folder.resolve("text.jar").apply { writeText("no jar") }
        conformance("--strategy", "zbuffer", "--classpath", text).mistake("text.jar is not a jar")
        val unborn = jar(UnbornRenderer::class.java, name = "unborn.jar")
        conformance("--strategy", "unborn", "--classpath", unborn)
            .mistake("a renderer on the class path cannot be loaded")
        conformance().mistake("--strategy")
        conformance("--strategy", "zbuffer", "--rule", "rule_5_2_tiesGoToTheFirst")
            .mistake("no rule", "; did you mean '$ties'?")
        conformance("--strategy", "zbuffer", "--seed", "x").mistake("'x' is not a whole number")
        conformance("--strategy", "zbuffer", "--seed", "1", "--explore").mistake("exclude each other")
        judge("--strategy", "zbuffer", "--tries", "0").mistake("--tries: must be in 0.001..1000000")
        val full = folder.resolve("full").apply { writeText("a file") }
        conformance("--strategy", "zbuffer", "--rule", ties, "--report", full).mistake("full")
        assertFalse(folder.resolve("full/report.html").exists())
        for (name in listOf("a.pdf", "b.htm", "none/c.html")) {
            zcli("conformance", "--strategy", "zbuffer", "--report", folder.resolve(name)).mistake(name)
        }
    }

    /** As `-o` of `zcli report`. */
    @Test
    fun aReportCanBeAPageAlone() {
        val page = folder.resolve("page.html")
        judge("--strategy", "zbuffer", "--rule", ties, "--tries", "0.05", "--report", page).done()
        assertTrue("</html>" in page.readText())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun twoStrategiesAreComparedOnFramesOfAnySize() {
        val jar = jar(FickleRenderer::class.java)
        val corpus = folder.resolve("corpus")
        val words = arrayOf("--against", "zbuffer", "--corpus", corpus, "--minutes")
        val same = zcli("conformance", "--strategy", "hierarchical", *words, "0.01").done()
        assertTrue("hierarchical against zbuffer: " in same.text && "no picture differs" in same.text, same.text)
        assertTrue(corpus.resolve("recipes.txt").exists())
        val other = zcli("conformance", "--strategy", "fickle", "--classpath", jar, *words, "0.03")
        assertEquals(1, other.code)
        assertTrue(Regex("against zbuffer: .* differs?; ") in other.text, other.text)
    }

    @Test
    fun whatHasNoEffectWithAgainstIsRefused() {
        val against = arrayOf<Any>("conformance", "--strategy", "lazy", "--against", "zbuffer", "--minutes", "0.01")
        val report = folder.resolve("report")
        val words = mapOf(
            "--explore" to null, "--tries" to "2", "--rule" to "5.2", "--waivers" to "none.txt", "--frames" to "none",
            "--verify" to "none.json", "--report" to report, "--deadline" to "3", "--in-process" to null,
            "--json" to null,
        )
        for ((option, value) in words) {
            zcli(*against, option, *listOfNotNull(value).toTypedArray()).mistake("$option has no effect with --against")
        }
        assertFalse(report.exists())
        for (option in listOf("--minutes", "--corpus")) {
            conformance("--strategy", "zbuffer", option, "1").mistake("$option needs --against")
        }
    }

    @Test
    fun framesOfOnesOwnAreCounted() {
        val frames = folder.resolve("frames")
        val rule = "rule_7_1_userFramesAreDrawnCorrectly"
        val words = arrayOf<Any>("--tries", "0.05", "--strategy", "zbuffer", "--rule", rule, "--frames", frames)
        for (where in listOf(arrayOf("--in-process"), arrayOf("--in-process", "--quiet"))) {
            val first = zcli("conformance", *where, *words)
            assertEquals(ExitCode.DONE, first.code, first.errors)
            assertTrue("zcli: warning: --frames: there was no folder $frames" in first.errors, first.errors)
            assertTrue(frames.toFile().list().isNullOrEmpty())
            assertTrue("zcli: warning: --frames: no scene file" in zcli("conformance", *where, *words).errors)
            frames.toFile().delete()
        }
        folder.resolve("frames").createDirectory().wedge()
        assertTrue("1 frame of your own in $frames\n" in zcli("conformance", "--in-process", *words).errors)
        assertEquals("", conformance(*words.drop(2).toTypedArray()).done().errors)
        frames.resolve("bad.json").writeText("{")
        conformance(*words.drop(2).toTypedArray()).mistake("a file of the frames folder cannot be read", "bad.json")
    }

    @Test
    fun programsAreTestedByScenes() {
        val nothing = "exit 3; : {scene} {picture}"
        val words = arrayOf("conformance", "--quiet", "--rule", "2.6", "--tries", "0.05")
        val run = zcli(*words, "--program", nothing, "--jobs", "1").done()
        assertTrue("conforms: 1 rule, 1 not supported" in run.text, run.text)
        val baseline = folder.resolve("known.csv")
        val failed = zcli(*words, "--program", "true {scene} {picture}", "--baseline", baseline)
        assertEquals(ExitCode.DIFFERENT, failed.code, failed.errors)
        assertTrue("18-spheres-01,wrong" in baseline.readText())
        zcli(*words, "--program", "true {scene} {picture}", "--baseline", baseline).done()
    }

    @Test
    fun optionsOfProgramsThatHaveNoEffectAreMistakes() {
        val program = "draw {scene} {picture}"
        zcli("conformance", "--program", "draw").mistake("--program: the command must have {scene}")
        val both = zcli("conformance", "--program", program, "--strategy", "lazy")
        both.mistake("--strategy has no effect with --program")
        zcli("conformance", "--program", program, "--rule", "8.1").mistake("no rule '8.1'")
        zcli("conformance", "--jobs", "2").mistake("--jobs needs --program")
        zcli("conformance", "--baseline", "a.csv").mistake("--baseline needs --program")
        zcli("conformance", "--export", "a", "--program", program).mistake("--program has no effect with --export")
    }
}
