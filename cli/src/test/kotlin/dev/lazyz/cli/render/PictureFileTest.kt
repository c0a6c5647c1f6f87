package dev.lazyz.cli.render

import dev.lazyz.Region
import dev.lazyz.cli.BuggyRenderer
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.writers.AlphaChannel
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class PictureFileTest {
    private fun warnings(name: String?, size: Int) =
        PictureFile.warnings(name?.let { Path.of(it) }, Region(0, 0, size, size), AlphaChannel.DROP)

    @Test
    fun beyondAGigapixelAPyramidIsBetter() {
        for (name in listOf("a.png", "a.ppm", null)) {
            assertEquals(emptyList<String>(), warnings(name, 31_622))
            val warning = warnings(name, 100_000).single()
            assertTrue("10.0 gigapixels" in warning && "-o NAME.dzi" in warning, warning)
        }
        assertEquals(emptyList<String>(), warnings("a.dzi", 100_000))
    }

    /** The renderer fails at once, so that nothing of the picture is rendered. */
    @Test
    fun theWarningComesBeforeTheWork(@TempDir folder: Path) {
        val words = arrayOf("render", "teapot", "--size", "40000", "--aa", "1", "--strategy", "buggy")
        withRenderers(folder, BuggyRenderer::class.java.name) {
            for (names in listOf(listOf("a.png"), listOf("{stem}.png"), listOf("-"))) {
                val run = zcli(*words, "-o", if (names[0] == "-") "-" else folder.resolve(names[0]))
                assertTrue("the picture has 1.6 gigapixels" in run.errors, run.errors)
            }
        }
    }
}
