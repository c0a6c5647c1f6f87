package dev.lazyz.conformance.run

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.RendererConformance
import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import dev.lazyz.conformance.mutants.wrappers.MannerMistakes
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** The user's folder of frames. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class FrameFolderTest {
    @TempDir
    lateinit var folder: Path

    private val own = RuleNames.frames
    private val triangle = """{"lazyz": 1, "size": [97, 5], "camera": {"screen": {}}, "surfaces": []}"""
    private val mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"

    private fun conformance(make: () -> Renderer) = Conformance(make).tries(0.1).frames(folder)

    @Test
    fun sceneFilesAndMeshesAreTriedAndOtherFilesAreLeftAlone() {
        folder.resolve("a.json").writeText(triangle)
        folder.resolve("b.obj").writeText(mesh)
        folder.resolve("notes.txt").createFile()
        folder.resolve("more.json").createDirectories()
        assertEquals(listOf(97L * 5, 64L * 48), FrameFolder(folder).cases.map { it.frame.raster.size })
        val report = conformance { PlainRenderer() }.rule(own).run()
        assertTrue(report.isConformant, report.toText())
        assertEquals(4, report.distribution.frames)
    }

    @Test
    fun theyAreTriedBeforeAllElse() {
        val order = ArrayList<String>()
        val conformance = conformance { PlainRenderer() }.rule("4.3").rule(own).rule("9.6")
        val report = conformance.listener { rule, _, _ -> order.add(rule.name) }.run()
        assertEquals(own, order.first())
        assertEquals(report.results.map { it.rule }, SuiteRule.all.filter { it.name in order })
    }

    @Test
    fun frameThatIsWrongIsReported() {
        folder.resolve("a.json").writeText(triangle)
        val result = conformance { MannerMistakes.widthOf97() }.rule(own).run().results.single()
        assertEquals(RuleOutcome.FAILED, result.outcome)
        assertTrue("a.json" in result.message, result.message)
        assertEquals(listOf("a.json"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun frameThatARuleFailsOnIsKeptAndTriedFromThenOn() {
        val new = folder.resolve("new")
        fun run(rule: String) = Conformance { BasicMistakes.lastWinsTies() }.tries(1.0).frames(new).rule(rule).run()
        assertTrue(run(own).isConformant)
        run(RuleNames.ties)
        val kept = new.listDirectoryEntries().single().name
        assertTrue(kept.startsWith("${RuleNames.ties}-") && kept.endsWith(".json"), kept)
        assertEquals(RuleOutcome.FAILED, run(own).results.single().outcome)
        run(RuleNames.ties)
        assertEquals(1, new.listDirectoryEntries().size)
    }

    @Test
    fun fileThatCannotBeReadIsAMistake() {
        folder.resolve("bad.json").writeText("{")
        val bad = assertThrows(FramesException::class.java) { conformance { PlainRenderer() }.rule(own).run() }
        assertTrue("bad.json" in bad.message.orEmpty(), bad.message)
        val file = folder.resolve("file").createFile()
        assertThrows(FramesException::class.java) { Conformance { PlainRenderer() }.frames(file).rule(own).run() }
    }

    @Test
    fun propertyNamesTheFolderOfATest() {
        folder.resolve("a.json").writeText(triangle)
        SuiteRun.withProperty(RendererConformance.FRAMES, folder.toString()) {
            assertEquals(2, Conformance { PlainRenderer() }.tries(0.1).rule(own).run().distribution.frames)
        }
    }

    @Test
    fun testMayHaveFramesOfItsOwn() {
        val rules = arrayOf(own, RuleNames.ties)
        val run = SuiteRun.of(WithFrames::class, tries = 0.01, *rules)
        assertEquals(emptySet<String>(), run.failures.keys)
        assertEquals(2, run.report.results.single { it.rule.name == own }.distribution.frames)
        assertEquals(setOf(own), SuiteRun.of(WithFramesThatAreWrong::class, tries = 0.01, *rules).failures.keys)
    }
}

/** A frame whose width does not occur among the suite's frames. */
private val frame = Frame(Raster(97, 2), emptyList())

class WithFrames : RendererConformance() {
    override fun renderer(): Renderer = ZBufferRenderer()

    override fun frames(): List<FrameCase> = listOf(FrameCase(frame, "what makes it, for messages"))
}

internal class WithFramesThatAreWrong : RendererConformance() {
    override fun renderer(): Renderer = MannerMistakes.widthOf97()

    override fun frames(): List<FrameCase> = listOf(FrameCase(frame, "Frame(Raster(97, 2), emptyList())"))
}
