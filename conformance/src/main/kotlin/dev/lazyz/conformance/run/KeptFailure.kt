package dev.lazyz.conformance.run

import dev.lazyz.conformance.report.ReportFiles
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.rules.AllRules
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Saves the frames of failures when the suite runs as a test of a build, where there is no report. */
internal object KeptFailure {
    /**
     * Writes the files of a [failed] rule, and returns a text with their location and the command that reproduces the
     * failure.
     */
    fun of(test: AllRules, settings: Settings, failed: RuleResult): String {
        val failure = checkNotNull(failed.failure)
        val judged = StrategyInfo(test.renderer())
        val report = settings.report(judged, null, listOf(failed), failed.milliseconds, isOnDisk = false)
        val folder = folder().resolve(test.javaClass.simpleName)
        val kept = try {
            Files.createDirectories(folder)
            val files = ReportFiles(report, folder).write(failure, folder, failed.rule)
            if (files.isEmpty()) "" else "saved in $folder: ${files.joinToString()}\n"
        } catch (e: IOException) {
            "not saved: $e\n"
        }
        return "${kept}seed ${report.seed}; again: ${report.commandFor(failed.rule)}"
    }

    /** The folder that the system property names, or a folder in the build directory. */
    private fun folder(): Path {
        System.getProperty(SuiteProperties.OUTPUT)?.let { return Path.of(it) }
        val build = listOf("target", "build").map { Path.of(it) }.firstOrNull { Files.isDirectory(it) }
        return (build ?: Path.of(System.getProperty("java.io.tmpdir"))).resolve("lazyz-conformance")
    }
}
