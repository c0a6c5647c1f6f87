package dev.lazyz.cli

import dev.lazyz.cli.output.ExitCode
import java.nio.file.Path
import kotlin.io.path.exists
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** `--fail-blank` in all commands that render. */
class FailBlankTest {
    @TempDir
    lateinit var folder: Path

    private val size = arrayOf<Any>("--size", "20x16", "--aa", "1")

    private fun blank(vararg words: Any): Zrun {
        val run = zcli(*words, *size, "--fail-blank")
        assertEquals(ExitCode.DIFFERENT, run.code, run.errors)
        assertTrue("zcli: error: " in run.errors && "warning" !in run.errors.replace(NO_FACETS, ""), run.errors)
        return run
    }

    @Test
    fun picturesWithoutAnythingAreErrors() {
        val empty = folder.emptyModel()
        for ((command, file) in listOf("render" to "a.png", "report" to "a.html", "trace" to "a.gif")) {
            blank(command, empty, "-o", folder.resolve(file))
            assertTrue(folder.resolve(file).exists(), "the file is still written")
        }
        blank("compare", empty)
        blank("compare", "teapot", empty)
        blank("render", "teapot", empty, "-o", folder.resolve("{stem}.png"))
        blank("render", "teapot", empty, "--contact-sheet", "-o", folder.resolve("sheet.png"))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun picturesOfOneColourAreErrorsToo() {
        val white = arrayOf("--color", "white", "--light", "flat")
        for (words in listOf(
            arrayOf("render", folder.wedge(), "-o", folder.resolve("a.png")), arrayOf("compare", folder.wedge()),
            arrayOf("trace", folder.wedge(), "-o", folder.resolve("a.gif")),
            arrayOf("report", folder.wedge(), "-o", folder.resolve("a.html"), "--strategy", "lazy"),
        )) {
            val run = blank(*words, *white)
            assertTrue("all pixels have the same colour" in run.errors, run.errors)
        }
    }

    @Test
    fun whereSomethingIsVisibleItChangesNothing() {
        zcli("render", "teapot", *size, "--fail-blank", "-o", folder.resolve("a.png")).done()
        zcli("compare", "teapot", "city", *size, "--fail-blank").done()
    }

    @Test
    fun anInputThatFailsIsTheWorseOutcome() {
        val run = zcli(
            "render", folder.emptyModel(), folder.resolve("none.stl"), *size, "--fail-blank",
            "-o", folder.resolve("{stem}.png"),
        )
        assertEquals(ExitCode.MISTAKE, run.code, run.errors)
    }

    @Test
    fun aPyramidThatIsCompletedCannotBeLookedAt() {
        val resumed = arrayOf("--resume", "--fail-blank", "-o", folder.resolve("a.dzi"))
        zcli("render", "teapot", *resumed).mistake("--resume cannot be combined with --fail-blank")
    }

    private companion object {
        val NO_FACETS = Regex("zcli: warning: .*there are no facets, so there is nothing to see")
    }
}
