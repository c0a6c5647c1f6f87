package dev.lazyz.testing

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.writers.toPng
import java.nio.file.Files
import java.nio.file.Path
import java.util.Collections
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.opentest4j.AssertionFailedError
import org.opentest4j.FileInfo

/** Pictures are compared with files, and files are written in update mode only. */
class GoldensTest {
    @TempDir
    lateinit var folder: Path

    private val golden get() = folder.resolve("golden/a.png")
    private val output get() = folder.resolve("target/golden-pictures")
    private val printed: MutableList<String> = Collections.synchronizedList(ArrayList())

    private fun image(color: Int, width: Int = 4) =
        Image(width, 2, IntArray(2 * width) { color }, IntArray(2 * width), IntArray(2 * width), Counters.NONE)

    private fun goldens(isUpdate: Boolean = false, workspace: Path? = null) =
        Goldens(GoldenSettings(folder, output, isUpdate, isGradle = false, workspace) { printed.add(it) })

    private fun assertion(image: Image, goldens: Goldens = goldens()) =
        PictureAssertion(goldens) { ActualPicture(Picture.of(image)) { image.toPng() } }

    private fun failure(assertion: PictureAssertion, path: String = "golden/a.png"): AssertionFailedError =
        assertThrows(AssertionFailedError::class.java) { assertion.matches(path) }

    private fun written(image: Image) {
        golden.parent.createDirectories()
        golden.writeBytes(image.toPng())
    }

    private fun files(): List<String> = Files.walk(folder).use { all ->
        all.filter { Files.isRegularFile(it) }.map { it.name }.sorted().toList()
    }

    @Test
    fun theSamePictureMatchesAndWritesNothing() {
        written(image(RED))
        assertion(image(RED)).matches("golden/a.png")
        assertion(image(RED)).matches("$golden")
        assertEquals(listOf("a.png"), files())
        assertEquals(emptyList<String>(), printed)
    }

    @Test
    fun anotherPictureFailsWithFilesAndAPage() {
        written(image(RED))
        val before = golden.readBytes()
        val failure = failure(assertion(image(RED + 1)))
        val lines = failure.message!!.lines()
        assertEquals("the picture differs from the golden file", lines[0])
        assertEquals("8 of 8 pixels differ, within columns 0 to 3, rows 0 to 1", lines[1])
        assertEquals("first at column 0, row 0: expected #ff0000ff, but was #ff0001ff", lines[2])
        assertEquals("largest difference of a channel: 1 of 255; mean: 0.25", lines[3])
        assertEquals("  expected    $golden", lines[4])
        val command = "mvn test -Dtest=GoldensTest -Dlazyz.golden.update=true"
        assertEquals("If the actual picture is right, make it the golden file: $command", lines.last())
        assertEquals(9, lines.size)

        val (actual, difference) = listOf("actual", "difference").map { word ->
            Path.of(lines.single { it.startsWith("  $word ") }.substringAfterLast(' '))
        }
        assertArrayEquals(image(RED + 1).toPng(), actual.readBytes())
        assertEquals("#ffcf00ff", Picture.read(difference).color(0, 0))
        val page = Path.of(lines[7].substringAfterLast(' ')).readText()
        assertEquals(3, Regex("src=\"data:image/png;base64,").findAll(page).count())
        for (word in listOf("<h2>golden/a.png</h2>", GoldensTest::class.java.name, lines[1], "1 different")) {
            assertTrue(word in page) { "$word is not in $page" }
        }
        assertArrayEquals(before, (failure.expected.value as FileInfo).contents)
        assertEquals("$actual", (failure.actual.value as FileInfo).path)
        assertArrayEquals(before, golden.readBytes())
        assertEquals(emptyList<String>(), printed)
    }

    @Test
    fun theSameFailureIsShownOnce() {
        written(image(RED))
        repeat(2) { failure(assertion(image(RED + 1))) }
        failure(assertion(image(RED + 2)))
        failure(assertion(image(RED + 2)), "other/a.png")
        assertTrue("3 different" in output.resolve("index.html").readText())
    }

    @Test
    fun aMissingFileFailsAndIsNotWritten() {
        val lines = failure(assertion(image(RED))).message!!.lines()
        assertEquals("there is no golden file", lines[0])
        assertTrue(lines.last().endsWith("mvn test -Dtest=GoldensTest -Dlazyz.golden.update=true"), lines.last())
        assertFalse(golden.exists())
        assertTrue("expected: none" in output.resolve("index.html").readText())
    }

    @Test
    fun otherSizesAndDamagedFilesFail() {
        written(image(RED, width = 5))
        val sizes = failure(assertion(image(RED)).withThreshold(255.0)).message
        assertTrue("the sizes differ: expected 5x2, but was 4x2" in sizes!!, sizes)
        golden.writeBytes("text".toByteArray())
        assertTrue(failure(assertion(image(RED))).message!!.startsWith("the golden file is no image"))
        val damaged = PictureAssertion(goldens()) { ActualPicture(Picture.decode(ByteArray(3))) { ByteArray(3) } }
        assertTrue(failure(damaged).message!!.startsWith("the picture cannot be compared with golden/a.png: <bytes>"))
    }

    @Test
    fun smallDifferencesAreAcceptedIfAskedFor() {
        written(image(RED))
        assertion(image(RED + 3)).withThreshold(3.0).matches("golden/a.png")
        failure(assertion(image(RED + 3)).withThreshold(2.9))
        val scene = SceneAssertion(Scenes.teapot(), goldens()).at(3, 2)
        for (wrong in listOf(-1.0, 256.0, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) { assertion(image(RED)).withThreshold(wrong) }
            assertThrows(IllegalArgumentException::class.java) { scene.withThreshold(wrong) }
        }
        assertThrows(IllegalArgumentException::class.java) { assertion(image(RED)).matches("golden/a.jpg") }
    }

    @Test
    fun updateModeWritesWhatIsMissingOrDifferent() {
        assertion(image(RED), goldens(isUpdate = true)).matches("golden/a.png")
        assertArrayEquals(image(RED).toPng(), golden.readBytes())
        assertEquals(listOf("lazyz: wrote golden file $golden, 4x2"), printed)
        assertion(image(RED)).matches("golden/a.png")

        // The same pixels in another file are left as they are
        val other = folder.resolve("golden/b.png")
        other.writeBytes(image(RED).toPng() + 0)
        val before = other.readBytes()
        assertion(image(RED), goldens(isUpdate = true)).matches("golden/b.png")
        assertArrayEquals(before, other.readBytes())

        val replaced = folder.resolve("golden/c.png")
        for (bytes in listOf(image(RED + 1).toPng(), "text".toByteArray())) {
            val path = if (replaced.exists()) folder.resolve("golden/d.png") else replaced
            path.writeBytes(bytes)
            assertion(image(RED), goldens(isUpdate = true)).matches("$path")
            assertArrayEquals(image(RED).toPng(), path.readBytes())
            assertEquals("lazyz: replaced golden file $path, 4x2", printed.last())
        }
        assertEquals(listOf("a.png", "b.png", "c.png", "d.png"), files())
    }

    /** Otherwise the last of several strategies would decide, and their difference would not be seen. */
    @Test
    fun updateModeDoesNotAcceptTwoPicturesForOneFile() {
        assertion(image(RED), goldens(isUpdate = true)).matches("golden/a.png")
        assertion(image(RED), goldens(isUpdate = true)).matches("golden/a.png")
        failure(assertion(image(RED + 1), goldens(isUpdate = true)))
        assertArrayEquals(image(RED).toPng(), golden.readBytes())
    }

    @Test
    fun workflowsOfGithubGetAnAnnotation() {
        failure(assertion(image(RED), goldens(workspace = folder)))
        val line = printed.single()
        assertTrue(line.startsWith("::error file=golden/a.png,title=Golden picture::there is no golden file%0A"), line)
        assertFalse('\n' in line)
        val elsewhere = Annotation.of(Path.of("/w"), Path.of("/x/a,b.png"), "50% of\nit")
        assertEquals("::error file=/x/a%2Cb.png,title=Golden picture::50%25 of%0Ait", elsewhere)
    }

    @Test
    fun threadsDoNotDisturbEachOther() {
        val threads = Executors.newFixedThreadPool(8)
        try {
            val jobs = (1..40).map { Callable { failure(assertion(image(RED + it)), "golden/${it % 5}.png").message } }
            val messages = threads.invokeAll(jobs).map { it.get()!! }
            val page = output.resolve("index.html").readText()
            assertTrue("40 different" in page)
            val actual = messages.map { text -> text.lines().single { "  actual " in it }.substringAfterLast(' ') }
            assertEquals(40, actual.toSet().size)
            for ((i, path) in actual.withIndex()) {
                assertArrayEquals(image(RED + i + 1).toPng(), Path.of(path).readBytes())
            }
        } finally {
            threads.shutdown()
        }
    }

    private companion object {
        const val RED = 0xFFFF0000.toInt()
    }
}
