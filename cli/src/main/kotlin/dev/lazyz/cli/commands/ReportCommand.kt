package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import dev.lazyz.cli.compare.CompareRequest
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.INPUT_HELP
import dev.lazyz.cli.options.PictureCommand
import dev.lazyz.cli.options.classPath
import dev.lazyz.cli.options.comparedStrategies
import dev.lazyz.cli.options.count
import dev.lazyz.cli.options.path
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.report.ReportJob
import dev.lazyz.cli.report.ReportRequest
import dev.lazyz.cli.strategies.StrategyPath

/**
 * `zcli report`: declares the options. [ReportJob] does the work.
 *
 * @param args the words of the command line, for the page and for bug reports
 */
internal class ReportCommand(private val streams: Streams, private val args: List<String>) :
    PictureCommand<ReportOptions>("report", ReportOptions()) {
    private val input by argument("INPUT", help = INPUT_HELP, completionCandidates = Completions.inputs)

    override fun help(context: Context): String =
        "Renders a model or a scene with all strategies, and writes a page of HTML with pictures, counters, heat " +
            "maps and charts.\n\nThe page shows whether all pictures are the same, what each strategy did, where, " +
            "and in which order. It is one file, without scripts, and loads nothing. Its result is printed. Exit " +
            "code 1: pictures differ, or a strategy failed; the page is written and says so."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli report city -o city.html" to "all strategies on a built-in scene",
        "zcli report model.glb --size 1024x768 --view iso --opaque -o model.html" to "your own model, opaque",
        "zcli report part.stl --strategy zbuffer --strategy lazy --repeat 9 -o part.html" to "two, measured longer",
    )

    override fun run() {
        val blanks = outcome.applyTo(streams)
        val shown = shown(input)
        val compared = CompareRequest(own.strategies.distinct(), cost.choices(), own.repeat, emptyList(), blanks)
        val command = CommandLine.of(CommandLine.without(args, setOf("-o", "--output")) + listOf("-o", "report.html"))
        val report = StrategyPath.with(own.classPath) {
            TimeLimit.OF_PROCESS.hold(shown.timeLimit, input) {
                ReportJob(ReportRequest(shown, own.output, compared, command), streams).run()
            }
        }
        for (bug in report.bugs) streams.messages.println(Failure.bugReport(bug, args.toTypedArray()))
        end(blanks.code(if (report.isGood) ExitCode.DONE else ExitCode.DIFFERENT))
    }
}

/** Options of the page. */
internal class ReportOptions : OptionGroup("Report") {
    val output by option("-o", "--output", help = "Where to write the report: ${ReportPlace.HELP}")
        .path("OUT")
        .required()

    val strategies by comparedStrategies()

    val classPath by classPath()

    val repeat by option(
        "--repeat",
        help = "Render this many times with each strategy, 1..1000, to measure the median time; default: 5",
    ).count(1..1000).default(5)
}
