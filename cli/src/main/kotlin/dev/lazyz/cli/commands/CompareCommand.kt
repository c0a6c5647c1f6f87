package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.compare.CompareJob
import dev.lazyz.cli.compare.CompareRequest
import dev.lazyz.cli.compare.CompareSeveralJob
import dev.lazyz.cli.compare.ComparisonTable
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.NamedInputs
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.INPUT_HELP
import dev.lazyz.cli.options.PictureCommand
import dev.lazyz.cli.options.classPath
import dev.lazyz.cli.options.comparedStrategies
import dev.lazyz.cli.options.count
import dev.lazyz.cli.options.listOf
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.StrategyPath
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.world.camera.FittedViewpoint.View

/**
 * `zcli compare`: declares the options. [CompareJob] and [CompareSeveralJob] do the work.
 *
 * @param args the words of the command line, for bug reports
 */
internal class CompareCommand(private val streams: Streams, private val args: List<String>) :
    PictureCommand<ComparingOptions>("compare", ComparingOptions()) {
    private val inputs by argument(
        "INPUT",
        help = "$INPUT_HELP; or a folder: all models and scene files in it",
        completionCandidates = Completions.inputs,
    ).multiple(required = true)

    override fun help(context: Context): String =
        "Renders models or scenes with all strategies, checks that the pictures are the same, and prints time and " +
            "memory of each strategy. For several inputs, or a folder, it prints one line per input.\n\nColour, " +
            "depth and visible surface of every pixel are compared, without tolerance. Exit code 1: pictures " +
            "differ, or a strategy failed; 2: neither, but an input could not be read."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli compare city" to "all strategies, one row per strategy",
        "zcli compare model.glb --size 1024x768 --opaque --repeat 5" to "an opaque model; times are medians of five",
        "zcli compare teapot --strategy zbuffer --strategy lazy --json" to "two strategies, for a script",
        "zcli compare models a.obj city --size 160x120 --views iso,front,back" to "several inputs, from three sides",
    )

    override fun run() {
        val blanks = outcome.applyTo(streams)
        end(blanks.code(StrategyPath.with(own.classPath) { compare(blanks) }))
    }

    private fun compare(blanks: BlankPictures): Int {
        val views = own.views.orEmpty()
        val directed = settings.directed
        if (views.isNotEmpty() && directed != null) throw Mistake("--views cannot be combined with $directed")
        val request = CompareRequest(own.strategies.distinct(), cost.choices(), own.repeat, views, blanks)
        if (inputs.count { it == "-" } > 1) throw Mistake("standard input can be only one of the inputs")
        val named = NamedInputs(inputs, settings[PictureParameters.FORMAT])
        if (named.isSingle && views.size < 2) {
            val shown = shown(inputs.single())
            return TimeLimit.OF_PROCESS.hold(shown.timeLimit, shown.input) { compareOne(request, shown) }
        }
        return CompareSeveralJob(request, streams, ::shown, args).run(named.all, own.isJson)
    }

    private fun compareOne(request: CompareRequest, shown: ShownInput): Int {
        val source = FrameSource(shown, streams)
        val job = CompareJob(request, streams)
        val comparison = job.compare(source, source.load(), request.views.singleOrNull())
        request.blanks.report(comparison.blank, streams)
        streams.print(if (own.isJson) comparison.toJson() + "\n" else ComparisonTable.of(comparison))
        for (bug in comparison.bugs) streams.messages.println(Failure.bugReport(bug, args.toTypedArray()))
        return if (comparison.isGood) ExitCode.DONE else ExitCode.DIFFERENT
    }
}

/** Options that choose what to compare, and how to print the result. */
internal class ComparingOptions : OptionGroup("Comparing") {
    val strategies by comparedStrategies()

    val classPath by classPath()

    val views by option(
        "--views",
        help = "Look from each of these sides, separated by commas, such as iso,front,back, each at most " +
            "once; default: the options of the camera",
    ).listOf("SIDES", NamedValues.words(View.entries))

    val repeat by option(
        "--repeat",
        help = "Render this many times with each strategy, 1..1000, and print the median time; default: 1, which " +
            "includes the time that Java needs to warm up",
    ).count(1..1000).default(1)

    val isJson by option("--json", help = "Print one JSON object, or JSON lines for several inputs").flag()
}
