package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.diff.DifferenceText
import dev.lazyz.cli.diff.ModelDiffJob
import dev.lazyz.cli.diff.writeMarked
import dev.lazyz.cli.input.Input
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.PictureCommand
import dev.lazyz.cli.options.number
import dev.lazyz.cli.options.path
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.scenes.pictures.FileValues
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings

/** `zcli diff`: compares two models, or the pixels of two image files. [ModelDiffJob] does the work for models. */
internal class DiffCommand(private val streams: Streams) :
    PictureCommand<DiffOptions>("diff", DiffOptions(), usualFactor = PictureSettings.USUAL_FACTOR) {
    private val old by argument(
        "OLD",
        help = "A model, as INPUT of 'zcli render'; or a picture: a PNG, PPM, WebP, KTX2, TGA, TIFF, BMP, GIF, WBMP " +
            "or JPEG file",
        completionCandidates = Completions.inputs,
    )

    private val new by argument(
        "NEW",
        help = "What to compare with it, of the same kind",
        completionCandidates = Completions.inputs,
    )

    override fun help(context: Context): String =
        "Shows what changed from one model to another, or compares the pixels of two image files.\n\nModels: " +
            "pictures of both by one camera, and of what was added, removed and moved; volume, area, bounds and " +
            "counts, of all and of each part. Images: how many pixels differ, by how much, and where; file format " +
            "and encoding do not matter. All is compared exactly. An input is a model if its name says so, or with " +
            "--format. Exit code 1: they differ; 2: a file could not be read."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli diff old.stl new.stl -o diff.html" to "what changed in a model, as a page with pictures",
        "zcli diff old.3mf new.3mf --view iso --edges -o diff --json" to "a folder with pictures; for a script",
        "zcli diff golden.png new.png --diff where.png" to "two pictures, and a third of where they differ",
        "zcli diff golden.png new.png --threshold 2 --json" to "small differences are accepted; for a script",
    )

    override fun run() {
        own.diff?.let { OutputFile.check(it, "--diff", listOf(".png")) }
        val (isOldModel, isNewModel) = listOf(old, new).map { isModel(it) }
        if (isOldModel != isNewModel) {
            val (model, other) = if (isOldModel) old to new else new to old
            throw Mistake("$model is a model and $other is none by its name: compare two models, or two pictures")
        }
        val areEqual = if (isOldModel) areEqualModels() else areEqualPictures()
        end(if (areEqual) ExitCode.DONE else ExitCode.DIFFERENT)
    }

    private fun isModel(word: String): Boolean =
        Input(word, settings[PictureParameters.FORMAT]).let { it.isBuiltin || it.statedFormat != null }

    private fun areEqualModels(): Boolean {
        if (own.threshold != null) throw Mistake("--threshold is for pictures: models are compared exactly")
        if (old == "-" && new == "-") throw Mistake("standard input can be only one of the inputs")
        val blanks = outcome.applyTo(streams)
        val (first, second) = shown(old) to shown(new)
        val job = ModelDiffJob(first, second, own.output, own.diff, cost.choices(), blanks, streams)
        val isEqual = TimeLimit.OF_PROCESS.hold(first.timeLimit, "$old and $new") { job.run(own.isJson) }
        return isEqual && blanks.code(ExitCode.DONE) == ExitCode.DONE
    }

    private fun areEqualPictures(): Boolean {
        val chosen = PictureParameters.all.firstOrNull { settings[it] != null }?.let { "--$it" }
            ?: own.output?.let { "-o" }
        if (chosen != null) throw Mistake("$chosen is for models, and the inputs are none by their names")
        val (expected, actual) = listOf("OLD" to old, "NEW" to new).map { (name, word) ->
            try {
                FileValues().read(word)
            } catch (illegal: IllegalArgumentException) {
                throw Mistake("$name: ${illegal.message}")
            }
        }
        own.diff?.let {
            OutputFile.requireDistinct(listOf("OLD" to expected, "--diff" to it))
            OutputFile.requireDistinct(listOf("NEW" to actual, "--diff" to it))
        }
        val difference =
            PictureDifference.between(Picture.read(expected), Picture.read(actual), own.threshold ?: 0.0)
        own.diff?.let {
            difference.writeMarked(it)
            streams.remark("wrote $it")
        }
        val text = DifferenceText("$expected", "$actual", difference)
        streams.print(if (own.isJson) Json.of(text.toJson()) + "\n" else text.lines)
        return difference.isMatch
    }
}

/** Options of the comparison. */
internal class DiffOptions : OptionGroup("Comparing") {
    val output by option(
        "-o",
        "--output",
        help = "Of models: where to write the result as a page with pictures: ${ReportPlace.HELP}, " +
            "beside before.png, after.png and difference.png",
    ).path("OUT")

    val diff by option(
        "--diff",
        help = "Write a picture of the differences, a .png file: of models, green: added, red: removed, blue: moved, " +
            "yellow: recolored; of pictures, yellow to red where they differ",
    ).path()

    val threshold by option(
        "--threshold",
        help = "Of pictures: the greatest difference of a channel that is accepted, 0..255, in 8-bit code values; " +
            "default: 0",
    ).number("CODES", 0.0..255.0, "")

    val isJson by option("--json", help = "Print one JSON object").flag()
}
