package dev.lazyz.cli.render

import dev.lazyz.cli.ProjectFiles
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.image
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.statIn
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `zcli render --ref` compares the picture with a reference. */
class ReferenceTest {
    @TempDir
    lateinit var folder: Path

    private val reference get() = folder.resolve("ref.png")

    private fun render(vararg options: Any): Zrun = zcli("render", "teapot", "--size", "40x30", *options)

    private fun files() = folder.listDirectoryEntries().map { it.name }.sorted()

    @Test
    fun theSamePictureIsAcceptedAndNotWritten() {
        render("-o", reference).done()
        for (strategy in listOf("tiled", "scanline")) {
            assertEquals("", render("--ref", reference, "--strategy", strategy).done().text)
        }
        assertEquals(listOf("ref.png"), files())
        assertFalse(Path.of("teapot.png").exists())
    }

    @Test
    fun anotherPictureIsDifferent() {
        render("-o", reference).done()
        val before = reference.readBytes()
        val run = render("--ref", reference, "--zoom", "1.01", "--diff", folder.resolve("where.png"))
        assertEquals(ExitCode.DIFFERENT, run.code)
        assertEquals("", run.text)
        assertTrue(run.errors.startsWith("teapot differs from $reference\n"), run.errors)
        assertTrue("of 1,200 pixels differ, within columns " in run.errors, run.errors)
        assertEquals(listOf("ref.png", "where.png"), files())
        assertArrayEquals(before, reference.readBytes())
        assertEquals(40, folder.resolve("where.png").image.width)
    }

    @Test
    fun thePictureIsWrittenTooIfItIsAskedFor() {
        render("-o", reference).done()
        val output = folder.resolve("out.png")
        assertEquals(ExitCode.DIFFERENT, render("--ref", reference, "--background", "red", "-o", output).code)
        assertEquals(ExitCode.DIFFERENT, zcli("diff", reference, output).code)
        val piped = render("--ref", reference, "-o", "-").done()
        assertArrayEquals(reference.readBytes(), piped.output)
    }

    /** A golden file of `lazyz-testing`, which a test in JUnit has written. */
    @Test
    fun goldenFilesOfJunitAreReferences() {
        val golden = ProjectFiles.folderOf("testing").resolve("src/test/resources/golden/teapot.png")
        val rate = arrayOf("--shading-rate", "sample")
        zcli("render", "teapot", "--size", "120x90", "--aa", "2", *rate, "--ref", golden).done()
        assertEquals(ExitCode.DIFFERENT, zcli("render", "teapot", "--size", "120x90", "--ref", golden).code)
    }

    @Test
    fun statisticsHaveTheComparison() {
        render("-o", reference, "--background", "white").done()
        val same = render("--ref", reference, "--background", "white", "--stats=json").done().text
        assertEquals("true", statIn(same.substringAfter("\"reference\":"), "identical"))
        val other = render("--ref", reference, "--background", "fffffe", "--stats=json")
        assertEquals(ExitCode.DIFFERENT, other.code)
        assertEquals("1.0", statIn(other.text, "largestDifference"))
        assertTrue("\"millis\"" in other.text)
        render("--ref", reference, "--background", "fffffe", "--ref-threshold", "1").done()
    }

    @Test
    fun aMissingReferenceIsAMistakeWithTheCommandThatCreatesIt() {
        val output = folder.resolve("out.png")
        val run = render("--ref", reference, "-o", output, "--diff=where.png", "--ref-threshold", "3", "--aa", "1")
        run.mistake("there is no reference $reference", "zcli render -o $reference teapot --size 40x30 --aa 1")
        assertEquals(listOf<String>(), files())
        val command = run.errors.lines().single { it.startsWith("zcli render") }.split(" ").drop(1)
        zcli(*command.toTypedArray()).done()
        render("--ref", reference, "--aa", "1").done()
    }

    @Test
    fun optionsAreLeftOutOfACommand() {
        val names = setOf("-o", "--ref")
        fun without(line: String) = CommandLine.without(line.split(" "), names).joinToString(" ")
        assertEquals("render a b", without("render -o x a --ref=y -oz b --ref q"))
        assertEquals("render --refs -- -o x", without("render --refs --ref q -- -o x"))
        assertEquals("zcli render 'a b' ''", CommandLine.of(listOf("render", "a b", "")))
        val words = listOf("a&b", "it's", "{name}.png")
        assertEquals("zcli 'a&b' 'it'\\''s' '{name}.png'", CommandLine.of(words))
    }

    @Test
    fun mistakesAreReportedBeforeAnythingIsWritten() {
        render("-o", reference).done()
        val text = folder.resolve("text.png").apply { writeText("text") }
        val output = folder.resolve("out.png")
        render("--ref", text, "-o", output).mistake("$text: it is no image")
        render("--ref", reference, "-o", reference).mistake("--ref and -o must be different files")
        render("--ref", reference, "--diff", reference).mistake("--ref and --diff must be different files")
        render("--ref", reference, "--diff", output, "-o", output).mistake("-o and --diff must be different files")
        render("--ref", reference, "--diff", "where.ppm").mistake("--diff must end in .png")
        render("--diff", output).mistake("--diff needs --ref")
        render("--ref-threshold", "1").mistake("--ref-threshold needs --ref")
        assertFalse(output.exists())
    }
}
