package dev.lazyz.cli.strategies

import dev.lazyz.cli.BuggyRenderer
import dev.lazyz.cli.SecondZBuffer
import dev.lazyz.cli.UnbornRenderer
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.nio.file.Path
import java.util.ServiceConfigurationError
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The list of renderers, including third-party ones. */
class RendererListTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun thirdPartiesComeBehindTheBuiltIns() = withRenderers(folder, BuggyRenderer::class.java.name) {
        assertEquals(Renderers.builtIn.map { it.id } + "buggy", Renderers.all().map { it.id })
        assertEquals(BuggyRenderer::class.java, Renderers.find("buggy")?.javaClass)
        val last = zcli("strategies").done().text.trimEnd().lines().last()
        assertTrue(last.matches(Regex("buggy {2,}fails half way")), last)
    }

    @Test
    fun twoOfOneIdAreAMistakeThatNamesBoth() = withRenderers(folder, SecondZBuffer::class.java.name) {
        val clash = assertThrows(IllegalStateException::class.java) { Renderers.find("zbuffer") }
        for (part in listOf("'zbuffer'", ZBufferRenderer::class.java.name, SecondZBuffer::class.java.name)) {
            assertTrue(part in clash.message.orEmpty(), "${clash.message}")
        }
        zcli("strategies").mistake("two renderers have the id 'zbuffer'", SecondZBuffer::class.java.name)
    }

    @Test
    fun oneThatCannotBeLoadedIsAMistake() = withRenderers(folder, UnbornRenderer::class.java.name) {
        assertThrows(ServiceConfigurationError::class.java) { Renderers.all() }
        val run = zcli("strategies")
        assertEquals(2, run.code)
        assertTrue("cannot be loaded" in run.errors && "UnbornRenderer" in run.errors, run.errors)
    }
}
