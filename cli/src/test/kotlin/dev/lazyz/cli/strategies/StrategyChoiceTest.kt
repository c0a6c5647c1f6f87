package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Selector
import dev.lazyz.cli.CapableRenderer
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.argb
import dev.lazyz.cli.glass
import dev.lazyz.cli.image
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.strategies.Renderers
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The choice of a strategy that supports what the flags and the scene need. */
class StrategyChoiceTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = folder.resolve("out.png")

    private fun render(input: Any, vararg options: Any): Zrun =
        zcli("render", input, "-o", out, "--size", "40x30", "--stats=json", *options)

    private fun strategyOf(input: Any, vararg options: Any): String = render(input, *options).done().stat("strategy")

    private fun firstWith(vararg capabilities: Capability): String =
        Renderers.all().first { it.capabilities.containsAll(capabilities.toSet()) }.id

    private fun withCapable(block: () -> Unit) = withRenderers(folder, CapableRenderer::class.java.name, block = block)

    private fun assertNoPicture() = assertEquals(listOf<String>(), folder.listDirectoryEntries("*.png").map { it.name })

    @Test
    fun theFirstIsTakenIfNothingIsAsked() = assertEquals(Renderers.all().first().id, strategyOf("teapot"))

    @Test
    fun theFirstThatHeedsTheFlagsIsTaken() {
        assertEquals(firstWith(Capability.MEMORY_BUDGET), strategyOf("teapot", "--memory-budget", "1k"))
        assertEquals(firstWith(Capability.COHERENCE), strategyOf("teapot", "--coherence", "incremental"))
        assertEquals(firstWith(Capability.SELECTION), strategyOf("teapot", "--select", "farthest"))
        withCapable {
            assertEquals(firstWith(Capability.PARALLEL), strategyOf("teapot", "--threads", "2"))
            assertEquals(firstWith(Capability.PARALLEL), strategyOf("teapot", "--tile-size", "8"))
            val both = firstWith(Capability.SELECTION, Capability.PARALLEL)
            assertEquals(both, strategyOf("teapot", "--threads", "2", "--select", "count"))
        }
    }

    @Test
    fun aTranslucentSceneJustWorks() {
        val id = strategyOf(folder.glass())
        assertEquals(firstWith(Capability.TRANSPARENCY), id)
        val blended = out.image.argb()
        val opaque = render(folder.glass(), "--opaque").done()
        assertEquals(Renderers.all().first().id, opaque.stat("strategy"))
        assertNotEquals(blended, out.image.argb())
        withCapable {
            val both = firstWith(Capability.TRANSPARENCY, Capability.PARALLEL)
            assertEquals(both, strategyOf(folder.glass(), "--threads", "2"))
            assertEquals(blended, out.image.argb())
        }
    }

    @Test
    fun flagsReachTheStrategy() = withCapable {
        val flags = "--memory-budget 64k --coherence adaptive --threads 3 --tile-size 32 --select kth:2".split(" ")
        render("teapot", "--strategy", "capable", *flags.toTypedArray()).done()
        val asked = checkNotNull(CapableRenderer.asked)
        assertEquals(65_536L to Coherence.ADAPTIVE, asked.memoryBudget to asked.coherence)
        assertEquals(3 to 32, asked.threads to asked.tileSize)
        assertEquals(Selector.kthNearest(2), asked.selector)

        render("teapot", "--strategy", "capable", "--select", "FARTHEST").done()
        assertSame(Selector.farthest(), CapableRenderer.asked?.selector)
        assertEquals(null, CapableRenderer.asked?.memoryBudget)
    }

    @Test
    fun aStrategyThatDoesNotHeedAFlagIsAMistake() {
        val flags = listOf("--memory-budget 1k", "--coherence direct", "--select count", "--threads 2", "--tile-size 8")
        for (flag in flags) {
            val (name, value) = flag.split(" ")
            render("teapot", "--strategy", "zbuffer", name, value)
                .mistake("strategy 'zbuffer' does not support $name (", "See 'zcli strategies --long'")
        }
        render("teapot", "--strategy", "zbuffer", "--memory-budget", "1", "--select", "blend")
            .mistake("--memory-budget (hybrid, lazy", "--select (lists")
        render("no-such-input", "--strategy", "zbuffer", "--select", "count").mistake("does not support --select")
        assertNoPicture()
    }

    @Test
    fun aStrategyThatDoesNotBlendIsAMistakeForATranslucentScene() {
        for (id in Renderers.builtIn.filter { Capability.TRANSPARENCY !in it.capabilities }.map { it.id }) {
            render(folder.glass(), "--strategy", id)
                .mistake("the scene is translucent, and strategy '$id' does not blend (tiled, lists", "--opaque")
            assertNoPicture()
        }
        render(folder.glass(), "--memory-budget", "1k")
            .mistake("no strategy that supports --memory-budget (hybrid, lazy", "blends")
        assertNoPicture()
        render(folder.glass(), "--memory-budget", "1k", "--opaque").done()
    }

    @Test
    fun eachStrategyShowsTheNearestOfOpaqueSurfaces() {
        for (id in listOf("zbuffer", "lazy")) {
            assertEquals(id, strategyOf("teapot", "--strategy", id, "--select", "nearest"))
        }
        assertEquals(Renderers.all().first().id, strategyOf("teapot", "--select", "nearest"))
        strategyOf("teapot", "--shading-rate", "pixel", "--select", "nearest")
        strategyOf("teapot", "--memory-budget", "1k", "--select", "nearest")
    }

    @Test
    fun theNearestOfTranslucentSurfacesIsSelected() {
        assertEquals(firstWith(Capability.SELECTION), strategyOf(folder.glass(), "--select", "nearest"))
        render(folder.glass(), "--select", "nearest", "--strategy", "tiled")
            .mistake("strategy 'tiled' does not support --select (lists")
        render(folder.glass(), "--select", "nearest", "--shading-rate", "pixel").done()
        strategyOf(folder.glass(), "--select", "nearest", "--strategy", "tiled", "--opaque")
    }

    @Test
    fun selectorsShowDifferentSurfaces() {
        val ways = listOf("nearest", "farthest", "kth:2", "count", "blend")
        val pictures = ways.associateWith { way ->
            render(folder.glass(), "--select", way).done()
            out.image.argb()
        }
        assertEquals(ways.size, pictures.values.toSet().size, "each another picture")
        render(folder.glass()).done()
        assertEquals(pictures["blend"], out.image.argb(), "a translucent scene is blended")
        val counts = pictures.getValue("count").filter { it != -1 }.toSet()
        assertEquals(setOf(0xFF440154.toInt(), 0xFF46327E.toInt()), counts, "one or two behind each pixel")
    }
}
