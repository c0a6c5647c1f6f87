package dev.lazyz.cli

import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Version
import java.io.BufferedOutputStream
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.UncheckedIOException
import java.nio.file.AccessDeniedException
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Failures in the middle of a run. */
class FailureTest {
    @TempDir
    lateinit var folder: Path

    /** Throws after [bytes] bytes. */
    private class Breaking(private val bytes: Int, private val message: String) : OutputStream() {
        private val taken = ByteArrayOutputStream()

        override fun write(byte: Int) {
            if (taken.size() >= bytes) throw IOException(message)
            taken.write(byte)
        }
    }

    @Test
    fun ourBugIsReportedWithAllThatAReportNeeds() = withRenderers(folder, BuggyRenderer::class.java.name) {
        val run = zcli("render", "teapot", "--strategy", "buggy", "-o", folder.resolve("a b.png"), "--size", "40x30")
        assertEquals(70, run.code)
        for (
        part in listOf(
            "https://github.com/lazyz/lazyz/issues",
            "zcli ${Version.text}",
            "Java ${System.getProperty("java.version")}",
            "zcli render teapot --strategy buggy -o '",
            "IllegalStateException: the cursor ran away",
            "\tat dev.lazyz.cli.",
        )
        ) {
            assertTrue(part in run.errors, "'$part' is missing in: ${run.errors}")
        }
        assertEquals("", run.text)
    }

    @Test
    fun whatAFileHoldsDoesNotSteerTheTerminal() {
        val file = folder.resolve("red.ply")
        file.writeText("ply\nformat ascii 1.0\nelement vertex 1\nproperty \u001b[31mred x\nend_header\n0\n")
        val run = zcli("render", file, "-o", "-").mistake("\"?[31mred\"")
        assertTrue(run.errors.none { it.isISOControl() && it != '\n' }, run.errors)
    }

    @Test
    fun filesAreWholeOrNotThere() = withRenderers(folder, BuggyRenderer::class.java.name) {
        val old = folder.resolve("old.png").apply { writeText("old") }
        val options = arrayOf("--strategy", "buggy", "--size", "40x30", "--depth-out", folder.resolve("new.pfm"))
        for (picture in listOf(old, folder.resolve("new.png"), folder.resolve("new.ppm"))) {
            assertEquals(70, zcli("render", "teapot", "-o", picture, *options).code)
        }
        assertEquals(listOf("old.png", "services"), folder.listDirectoryEntries().map { it.name }.sorted())
        assertEquals("old", old.readText())
    }

    /** Java reports some failures of files in the middle of a stream in this form. */
    @Test
    fun aFileThatFailsInTheMiddleOfAStreamIsAMistake() {
        val cause = AccessDeniedException("a/b")
        assertEquals("a/b: permission denied", Failure.mistake(UncheckedIOException(cause)))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun outOfMemoryIsReportedInWords() = withRenderers(folder, GreedyRenderer::class.java.name) {
        zcli("render", "teapot", "--strategy", "greedy", "-o", folder.resolve("x.png"))
            .mistake("out of memory (Java heap space)", "-Xmx", "smaller --size")
        assertEquals(listOf("services"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun aClosedPipeIsNoError() {
        for (bytes in listOf(0, 100)) {
            val pipe = Breaking(bytes, "Broken pipe")
            assertEquals(0 to "", zcliWriting(pipe, "", "render", "teapot", "-o", "-", "--size", "40x30"))
            assertEquals(0 to "", zcliWriting(pipe, "", "scenes"))
            assertEquals(0 to "", zcliWriting(pipe, "", "--help"))
        }
    }

    @Test
    fun aClosedPipeIsReportedWhenAFileWasWantedToo() {
        val options = arrayOf("render", "teapot", "-o", "-", "--size", "40x30", "--depth-out", folder.resolve("x.pfm"))
        val (code, errors) = zcliWriting(Breaking(100, "Broken pipe"), "", *options)
        assertEquals(2, code)
        assertTrue("x.pfm was not written" in errors, errors)
        assertEquals(listOf<Path>(), folder.listDirectoryEntries())
    }

    @Test
    fun whatElseAPictureIsForIsReportedWhenThePipeIsClosed() {
        val render = listOf("render", "teapot", "-o", "-", "--size", "40x30")
        val data = listOf("--aov", "depth=${folder.resolve("d.npy")}")
        val (code, errors) = zcliWriting(Breaking(100, "Broken pipe"), "", *(render + data).toTypedArray())
        assertEquals(2, code)
        assertTrue("d.npy may not have been written" in errors, errors)

        val reference = folder.resolve("ref.png").also { zcli("render", "teapot", "-o", it, "--size", "40x30").done() }
        val compared = render + listOf("--ref", "$reference")
        val (other, words) = zcliWriting(Breaking(100, "Broken pipe"), "", *compared.toTypedArray())
        assertEquals(2, other)
        assertTrue("was not compared with $reference" in words, words)
    }

    @Test
    fun allPicturesAreWrittenThoughNobodyReadsTheirNumbers() {
        val names = listOf("teapot", "city", "star")
        val output = listOf("--size", "30x20", "--stats=json", "--threads", "1", "-o", "$folder/{stem}.png")
        val words = (listOf("render") + names + output).toTypedArray()
        assertEquals(0 to "", zcliWriting(Breaking(10, "Broken pipe"), "", *words))
        for (name in names) assertTrue(folder.resolve("$name.png").exists(), name)
        val sheet = listOf("--size", "30x20", "--contact-sheet", "--stats=json", "-o", "$folder/sheet.png")
        val ofAll = (listOf("render") + names + sheet).toTypedArray()
        assertEquals(0 to "", zcliWriting(Breaking(10, "Broken pipe"), "", *ofAll))
        assertTrue(folder.resolve("sheet.png").exists())
    }

    @Test
    fun theResultOfAComparisonRemainsWithoutAReader() {
        val pictures = listOf("white", "red").map { color ->
            folder.resolve("$color.png").also {
                zcli("render", folder.wedge(), "-o", it, "--color", color, "--size", 8)
            }
        }
        val pipe = BufferedOutputStream(Breaking(0, "Broken pipe"), 1 shl 20)
        assertEquals(1 to "", zcliWriting(pipe, "", "diff", "${pictures[0]}", "${pictures[1]}"))
    }

    /** Exit code 1 would mean that pictures differ. */
    @Test
    fun aFullDiskIsAnErrorForAnswersToo() {
        val pictures = listOf("white", "red").map { color ->
            folder.resolve("$color.png").also {
                zcli("render", folder.wedge(), "-o", it, "--color", color, "--size", 8)
            }
        }
        val diff = listOf("diff") + pictures
        val picture = listOf("render", "teapot", "-o", "-", "--size", "40x30")
        val answers =
            listOf(picture, listOf("scenes"), listOf("--help"), listOf("--version"), listOf("render", "--help"))
        for (words in listOf(diff, diff + "--json") + answers) {
            // What a process writes is buffered, and fails when it is flushed
            val disk = BufferedOutputStream(Breaking(0, "No space left on device"), 1 shl 20)
            val (code, errors) = zcliWriting(disk, "", *words.toTypedArray())
            assertEquals("zcli: error: cannot write to standard output: No space left on device\n", errors, "$words")
            assertEquals(2, code, "$words")
        }
    }

    @Test
    fun aPictureOfOneColourIsDoneWithAWarning() {
        val options = arrayOf("--light", "flat", "--size", "40x30", "--aa", "1", "--stats=json")
        val picture = folder.resolve("x.png")
        val run = zcli("render", folder.wedge(), "-o", picture, *options, "--color", "white")
        assertEquals(0, run.code)
        assertTrue("zcli: warning: all pixels have the same colour" in run.errors, run.errors)
        assertEquals("true", run.stat("blank"))
        val series =
            zcli("render", folder.wedge(), "-o", folder.resolve("{view}.png"), *options, "--views", "front,iso")
        assertEquals(2, Regex("all pixels have the same colour").findAll(series.errors).count(), series.errors)
        zcli("render", folder.wedge(), "-o", picture, *options, "--background", "black").done()
    }
}
