package dev.lazyz.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option

/**
 * `zcli compare`: declares the options; [CompareJob] does the work.
 *
 * @param args the words of the command line, for the report of a bug
 */
internal class CompareCommand(private val streams: Streams, private val args: List<String>) : Command("compare") {
    private val input by argument("INPUT", help = INPUT_HELP)
    private val comparing by ComparingOptions()
    private val reading by ReadingOptions()
    private val picture by PictureOptions()
    private val camera by CameraOptions()
    private val cost by CostOptions()

    override fun help(context: Context): String =
        "Renders a model or a scene with all strategies, checks that they give the same picture, and tells what each " +
            "took.\n\nColour, depth and visible surface of every pixel are compared, without tolerance. Exit code 1: " +
            "the strategies' pictures differ, or a strategy failed."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli compare city" to "all strategies, one row each",
        "zcli compare model.glb --size 1024x768 --opaque --repeat 5" to "all of them; times are medians of five",
        "zcli compare teapot --strategy zbuffer --strategy lazy --json" to "two of them, for a script",
    )

    override fun run() {
        val request = CompareRequest(
            subject = subject(input, reading, picture, camera),
            strategies = comparing.strategies.distinct(),
            choices = cost.choices(),
            repeat = comparing.repeat,
        )
        val comparison = CompareJob(request, streams).run()
        streams.print(if (comparing.isJson) Json.of(comparison.entries) + "\n" else ComparisonTable.of(comparison))
        for (bug in comparison.bugs) streams.messages.println(Failure.bugReport(bug, args.toTypedArray()))
        if (!comparison.isGood) throw ProgramResult(ExitCode.DIFFERENT)
    }
}

/** What `zcli compare` is asked to do. Without [strategies], all are compared. */
internal class CompareRequest(
    val subject: Subject,
    val strategies: List<String>,
    val choices: Choices,
    val repeat: Int,
)

/** What to compare, and how to tell. */
private class ComparingOptions : OptionGroup("Comparing") {
    val strategies by option(
        "--strategy",
        metavar = "ID",
        help = "Compare this strategy; say it again for each further one; the first is what the others are held " +
            "against; default: all of 'zcli strategies'",
    ).multiple()

    val repeat by option(
        "--repeat",
        help = "Render so many times with each, 1..1000, and tell the median of the times; default: 1, which " +
            "includes the time that Java takes to warm up",
    ).count(1..1000).default(1)

    val isJson by option("--json", help = "Tell it as one JSON object").flag()
}
