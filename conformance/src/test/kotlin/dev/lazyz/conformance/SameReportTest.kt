package dev.lazyz.conformance

import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/** The same run gives the same report but for times, whether in the same process or in another. */
class SameReportTest {
    @TempDir
    lateinit var folder: Path

    private fun timeless(json: String) = json.replace(Regex("\"milliseconds\": \\d+"), "\"milliseconds\": 0")

    @ParameterizedTest
    @ValueSource(strings = ["right", "wrong"])
    fun againAndInAnotherProcess(renderer: String) {
        val files = SupervisedFiles(folder)
        val process = ProcessBuilder(files.command(renderer)).redirectErrorStream(true).start()
        val first = timeless(SupervisedRun.conformance(renderer).run().toJson())
        if (renderer == "wrong") assertEquals(first, timeless(SupervisedRun.conformance(renderer).run().toJson()))
        val printed = process.inputStream.reader().readText()
        assertTrue(process.waitFor(120, TimeUnit.SECONDS))
        assertEquals(0, process.exitValue()) { printed }
        assertEquals(first, timeless(files.report.readText()))
        assertEquals(renderer == "right", "\"conformant\": true" in first)
    }
}
