package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.INPUT_HELP
import dev.lazyz.cli.options.PictureCommand
import dev.lazyz.cli.options.classPath
import dev.lazyz.cli.options.count
import dev.lazyz.cli.options.severalStrategies
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.StrategyPath
import dev.lazyz.cli.trace.TraceJob
import dev.lazyz.cli.trace.TraceRequest
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.writers.animation.Animation
import java.nio.file.Path

/** `zcli trace`: declares the options. [TraceJob] does the work. */
internal class TraceCommand(private val streams: Streams) :
    PictureCommand<FilmOptions>("trace", FilmOptions(), ImageSize(320, 240)) {
    private val input by argument("INPUT", help = INPUT_HELP, completionCandidates = Completions.inputs)

    override fun help(context: Context): String =
        "Makes a film of the order in which a strategy shades a picture.\n\nEach step shows some more shading calls: " +
            "pixels get their colours, and calls whose colour does not become part of the picture are pink. Two " +
            "strategies are shown side by side, with equally many calls at each step. Prints the numbers of calls. A " +
            "film has one sample per pixel and the order of one thread, so --threads, --aa above 1 and filters other " +
            "than box are refused."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli trace teapot --strategy lazy -o order.gif" to "the order of one strategy",
        "zcli trace city --strategy zbuffer,lazy -o both.png" to "two side by side, as an animated PNG",
        "zcli trace city --strategy zbuffer,lazy -o both.html" to "the same as a page, to go step by step",
        "zcli trace model.obj --strategy hybrid --memory-budget 64k -o budget.gif" to "what a budget changes",
        "zcli trace city --strategy painter --steps 200 --frames-per-second 25 -o slow.gif" to "longer and smoother",
    )

    override fun run() {
        val blanks = outcome.applyTo(streams)
        val choices = cost.choices()
        if ("--threads" in choices.needs) {
            throw Mistake("--threads cannot be used here: the order of shading calls is that of one thread")
        }
        val shown = shown(input)
        val request =
            TraceRequest(shown, own.output, own.strategies, choices, own.steps, own.framesPerSecond, blanks)
        StrategyPath.with(own.classPath) {
            TimeLimit.OF_PROCESS.hold(shown.timeLimit, input) { TraceJob(request, streams).run() }
        }
        end(blanks.code(ExitCode.DONE))
    }
}

/** Options of the film. */
internal class FilmOptions : OptionGroup("Film") {
    val output by option(
        "-o",
        "--output",
        metavar = "OUT",
        help = "The file of the film: .gif; .png or .apng; or .html, a page with controls",
    )
        .convert { Path.of(it) }
        .required()

    val strategies by severalStrategies(
        "The strategy; for two, separate them by a comma, or repeat the option; default: as for render",
    )

    val classPath by classPath()

    val steps by option("--steps", help = "Pictures from the first call to the last, 2..1000; default: $USUAL_STEPS")
        .count(2..MOST_STEPS)
        .default(USUAL_STEPS)

    val framesPerSecond by option(
        "--frames-per-second",
        help = "Speed of the animation, 1..${Animation.MAX_FRAMES_PER_SECOND}; default: " +
            "${Animation.DEFAULT_FRAMES_PER_SECOND}",
    ).count(1..Animation.MAX_FRAMES_PER_SECOND).default(Animation.DEFAULT_FRAMES_PER_SECOND)

    private companion object {
        const val USUAL_STEPS = 72
        const val MOST_STEPS = 1000
    }
}
