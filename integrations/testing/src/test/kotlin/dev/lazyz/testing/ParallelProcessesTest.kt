package dev.lazyz.testing

import dev.lazyz.scenes.pictures.Picture
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import kotlin.concurrent.thread
import kotlin.io.path.exists
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Several processes write one page, and a class begins anew in each. */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class ParallelProcessesTest {
    @TempDir
    lateinit var folder: Path

    private fun start(vararg words: String): Process {
        val java = Path.of(System.getProperty("java.home"), "bin", "java")
        val path = System.getProperty("java.class.path")
        val main = "dev.lazyz.testing.ParallelProcessesTestKt"
        val command = listOf("$java", "-XX:TieredStopAtLevel=1", "-cp", path, main, "$folder") + words
        return ProcessBuilder(command).inheritIO().start()
    }

    private fun shown(): List<String> =
        Regex("<h2>(.*)</h2>\n<p>(.*)</p>").findAll(folder.resolve("index.html").readText())
            .map { it.groupValues[2] + " " + it.groupValues[1] }.toList()

    @Test
    fun allFailuresOfTheLastRunAreShown() {
        val first = listOf(start("ATest", "20"), start("BTest", "20"))
        assertEquals(listOf(0, 0), first.map { it.waitFor() })
        val all = listOf("ATest", "BTest").flatMap { test -> (10..29).map { "$test $it.png" } }
        assertEquals(all, shown())

        val second = listOf(start("ATest", "2"), start("BTest", "0"))
        assertEquals(listOf(0, 0), second.map { it.waitFor() })
        assertEquals(listOf("ATest 10.png", "ATest 11.png"), shown())

        // A class that passes removes its failures, and the last of them the page
        TestReport(GoldenSettings(folder, folder), "ATest").begin()
        assertFalse(folder.resolve("index.html").exists())
    }

    @Test
    fun aReportWaitsForOthers() {
        FileChannel.open(folder.resolve(".lock"), CREATE, WRITE).use { channel ->
            val lock = channel.lock()
            val other = thread { main(arrayOf("$folder", "ATest", "1")) }
            other.join(200)
            assertTrue(other.isAlive)
            assertFalse(folder.resolve("ATest").exists())
            lock.release()
            other.join()
        }
        assertEquals(listOf("ATest 10.png"), shown())
    }
}

/** Adds failures of a class in the number that is given; arguments: folder, class, number. */
internal fun main(args: Array<String>) {
    val report = TestReport(GoldenSettings(Path.of("."), Path.of(args[0])), args[1])
    report.begin()
    for (i in 0 until args[2].toInt()) {
        val picture = ActualPicture(Picture.ofArgb(1, 1, intArrayOf(i))) { byteArrayOf(i.toByte()) }
        report.add(GoldenFailure("${10 + i}.png", "wrong", null, picture, null))
    }
}
