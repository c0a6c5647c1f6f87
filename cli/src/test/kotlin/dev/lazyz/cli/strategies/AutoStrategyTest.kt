package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.cli.CapableRenderer
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.glass
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.strategies.Renderers
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `--strategy auto` and `--explain`. */
class AutoStrategyTest {
    @TempDir
    lateinit var folder: Path

    private fun render(input: Any, vararg options: Any): Zrun =
        zcli("render", input, "-o", folder.resolve("out.png"), "--size", "40x30", "--stats=json", *options)

    private fun auto(input: Any, vararg options: Any): Zrun = render(input, "--strategy", "auto", *options)

    @Test
    fun autoHeedsFlagsAndTheScene() {
        val budgeted = auto("teapot", "--memory-budget", "1k").done().stat("strategy")
        assertTrue(Capability.MEMORY_BUDGET in Strategies.find(budgeted).capabilities, budgeted)
        assertEquals("lists", auto("teapot", "--select", "farthest").done().stat("strategy"))
        val blending = auto(folder.glass()).done().stat("strategy")
        assertTrue(Capability.TRANSPARENCY in Strategies.find(blending).capabilities, blending)
        auto("teapot", "--memory-budget", "1k", "--select", "count").mistake("no single strategy supports all of")
        auto(folder.glass(), "--memory-budget", "1k").mistake("blends")
    }

    @Test
    fun explainPrintsTheFrameAndEachStrategy() {
        val run = auto("city", "--explain")
        assertEquals(ExitCode.DONE, run.code)
        val lines = run.errors.trimEnd().lines()
        val frame = Regex("frame: 160 x 120 samples, \\d+ primitives, all opaque; about .* a primitive")
        assertTrue(lines[0].matches(frame), run.errors)
        assertTrue(lines[1].matches(Regex("threads: \\d+; memory: [\\d.]+ MiB")), run.errors)
        val ids = lines.drop(2).dropLast(1).map { it.trim().substringBefore(' ') }
        assertEquals(Renderers.all().map { it.id }.toSet(), ids.toSet())
        val reason = if (run.stat("strategy") == ids.first()) "it is expected" else "no other is expected"
        assertTrue(lines.last().startsWith("chosen: ${run.stat("strategy")}, because $reason to be"), run.errors)
    }

    @Test
    fun explainPrintsWhyOthersAreRuledOut() {
        val run = render(folder.glass(), "--explain")
        assertTrue(Regex("zbuffer .*ruled out: lacks transparency").containsMatchIn(run.errors), run.errors)
        assertTrue("some translucent" in run.errors, run.errors)
        assertTrue("because it is the first of 'zcli strategies' that is capable of this" in run.errors, run.errors)
        val budget = auto("teapot", "--memory-budget", "1k", "--explain").errors
        assertTrue(Regex("tiled .*ruled out: lacks memory budget").containsMatchIn(budget), budget)
    }

    @Test
    fun explainPrintsWhatAutoWouldHaveChosen() {
        val best = auto("city").done().stat("strategy")
        val other = Renderers.builtIn.first { it.id != best }.id
        val text = render("city", "--strategy", other, "--explain").errors
        assertTrue("chosen: $other, because --strategy names it; --strategy auto would choose $best" in text, text)
        assertFalse("would choose" in render("city", "--strategy", best, "--explain").errors)
    }

    @Test
    fun thirdPartiesAreTakenOnlyWhereNoOtherCan() = withRenderers(folder, CapableRenderer::class.java.name) {
        assertTrue(auto("teapot").done().stat("strategy") != "capable")
        assertEquals("capable", auto("teapot", "--memory-budget", "1k", "--select", "count").done().stat("strategy"))
        val text = auto("teapot", "--explain").errors
        assertTrue(Regex("capable +not measured").containsMatchIn(text), text)
    }
}
