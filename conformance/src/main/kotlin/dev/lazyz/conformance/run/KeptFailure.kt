package dev.lazyz.conformance.run

import dev.lazyz.conformance.report.ReportFiles
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.rules.AllRules
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Where the suite, run as a test of a build, keeps what a rule failed on: there is no report to hold it. */
internal object KeptFailure {
    /** Writes the files of a [failed] rule, and returns words that say where they are and how to see the failure again. */
    fun of(test: AllRules, settings: Settings, failed: RuleResult): String {
        val failure = checkNotNull(failed.failure)
        val report = settings.report(StrategyInfo(test.renderer()), null, listOf(failed), failed.milliseconds)
        val folder = folder().resolve(test.javaClass.simpleName)
        val kept = try {
            Files.createDirectories(folder)
            val files = ReportFiles(report, folder).write(failure, folder, failed.rule)
            if (files.isEmpty()) "" else "kept in $folder: ${files.joinToString()}\n"
        } catch (e: IOException) {
            "nothing kept: $e\n"
        }
        return "${kept}seed ${report.seed}; again: ${report.commandFor(failed.rule)}"
    }

    /** What the property says, or a folder of the build's. */
    private fun folder(): Path {
        System.getProperty(SuiteProperties.OUTPUT)?.let { return Path.of(it) }
        val build = listOf("target", "build").map { Path.of(it) }.firstOrNull { Files.isDirectory(it) }
        return (build ?: Path.of(System.getProperty("java.io.tmpdir"))).resolve("lazyz-conformance")
    }
}
