package dev.lazyz.conformance

import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectory
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/**
 * The same run gives the same report except for times, in the same process or in another. The default build tests this
 * with a wrong renderer and few rules.
 */
class SameReportTest {
    @TempDir
    lateinit var folder: Path

    private fun timeless(json: String) = json.replace(Regex("\"milliseconds\": \\d+"), "\"milliseconds\": 0")

    @TestFactory
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun againAndInAnotherProcess(): List<DynamicTest> {
        val renderers = if (TestEffort.isFull) listOf("wrong", "right") else listOf("wrong by few rules")
        return renderers.map { dynamicTest(it) { assertSameReport(it) } }
    }

    private fun assertSameReport(renderer: String) {
        val files = SupervisedFiles(folder.resolve(renderer).createDirectory())
        val command = files.command(renderer)

        // A report says whether its process has the Vector API, which this one has
        val words = listOf(command.first(), "--add-modules", "jdk.incubator.vector") + command.drop(1)
        val process = ProcessBuilder(words).redirectErrorStream(true).start()
        val first = timeless(SupervisedRun.conformance(renderer).run().toJson())
        if (TestEffort.isFull) assertEquals(first, timeless(SupervisedRun.conformance(renderer).run().toJson()))
        val printed = process.inputStream.reader().readText()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES))
        assertEquals(0, process.exitValue()) { printed }
        assertEquals(first, timeless(files.report.readText()))
        assertEquals(renderer == "right", "\"conformant\": true" in first)
    }
}
