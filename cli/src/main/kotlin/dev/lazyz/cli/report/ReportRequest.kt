package dev.lazyz.cli.report

import dev.lazyz.cli.compare.CompareRequest
import dev.lazyz.cli.input.Subject
import java.nio.file.Path

/**
 * The options of `zcli report`.
 *
 * @property compared what is compared, without views
 * @property command the command line that makes the report, without the output
 */
internal class ReportRequest(val subject: Subject, val output: Path, val compared: CompareRequest, val command: String,)
