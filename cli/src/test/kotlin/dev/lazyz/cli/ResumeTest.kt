package dev.lazyz.cli

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Pyramids whose process is ended in the middle. */
class ResumeTest {
    @TempDir
    lateinit var folder: Path

    private val child by lazy { ChildZcli(folder) }
    private val size = listOf("--size", "3200x4300", "--region", "100,200,3000x4000")
    private val words = listOf("render", "teapot") + size + listOf("--aa", "1", "--threads", "1", "--quiet", "-o")

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun aTerminatedPyramidLeavesNothing() {
        val process = child.start(words + "a.dzi")
        child.await(process, "no tiles") {
            folder.listDirectoryEntries(".a_files.*.d").any { it.resolve("12/0_1.png").exists() }
        }
        process.destroy()
        child.code(process)
        assertEquals(listOf("errors.txt"), folder.listDirectoryEntries().map { it.name })
        assertEquals("", child.errors)
    }

    /** Kills a run twice, in the middle of tiles; the third one completes the picture. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aKilledPyramidIsCompletedToTheSameBytes() {
        val tiles = folder.resolve("a_files.partial/tiles/12")
        for (tile in listOf("0_2.png", "11_7.png")) {
            val process = child.start(words + listOf("a.dzi", "--resume"))
            child.await(process, "no tiles") { tiles.resolve(tile).exists() }
            process.destroyForcibly()
            child.code(process)
            assertFalse(folder.resolve("a.dzi").exists())
        }
        val kept = tiles.resolve("3_1.png")
        val time = Files.getLastModifiedTime(kept)
        val stats = child.start(words + listOf("a.dzi", "--resume", "--stats=json"))
        val height = statIn(stats.inputStream.readAllBytes().decodeToString(), "height").toInt()
        assertEquals(0, child.code(stats), child.errors)
        assertTrue(height <= 4000 - 7 * 254, "$height rows were rendered")
        assertEquals(time, Files.getLastModifiedTime(folder.resolve("a_files/12/3_1.png")))

        assertEquals(0, child.code(child.start(words + "b.dzi")), child.errors)
        val (resumed, whole) = listOf("a", "b").map { content(folder.resolve("${it}_files")) }
        assertEquals(whole, resumed)
        assertEquals(Files.readString(folder.resolve("b.dzi")), Files.readString(folder.resolve("a.dzi")))
        val names = setOf("a.dzi", "a_files", "b.dzi", "b_files", "errors.txt")
        assertEquals(names, folder.listDirectoryEntries().map { it.name }.toSet())
    }

    /** The scaled-down twin of a picture of ten gigapixels in 256 MB: one that alone would take 92 MB, in 40 MB. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun pyramidsLargerThanTheHeapAreStreamed() {
        val options = listOf("--size", "6000x4000", "--aa", "1", "-o", "a.dzi")
        val process = child.start(listOf("render", "teapot") + options, listOf("-Xmx40m"))
        assertEquals(0, child.code(process), child.errors)
    }

    private fun content(folder: Path): Map<String, Int> = Files.walk(folder).use { all ->
        all.filter { Files.isRegularFile(it) }.toList()
            .associate { "${folder.relativize(it)}" to Files.readAllBytes(it).contentHashCode() }
    }
}
