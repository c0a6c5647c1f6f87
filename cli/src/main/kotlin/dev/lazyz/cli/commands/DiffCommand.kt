package dev.lazyz.cli.commands

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.convert
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.diff.DifferenceText
import dev.lazyz.cli.diff.writeMarked
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.number
import dev.lazyz.cli.options.path
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.Streams
import dev.lazyz.scenes.pictures.FileValues
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference

/** `zcli diff`: compares the pixels of two image files. */
internal class DiffCommand(private val streams: Streams) : Command("diff") {
    private val expected by argument(
        "EXPECTED",
        help = "The picture as it should be: a PNG, PPM, TGA, TIFF, BMP, GIF, WBMP or JPEG file",
        completionCandidates = CompletionCandidates.Path,
    ).convert { FileValues().read(it) }

    private val actual by argument(
        "ACTUAL",
        help = "The picture to compare with it, in one of these formats, too",
        completionCandidates = CompletionCandidates.Path,
    ).convert { FileValues().read(it) }

    private val threshold by option(
        "--threshold",
        help = "The greatest difference of a channel that is accepted, 0..255, in 8-bit code values; default: 0",
    ).number("CODES", 0.0..255.0, "").default(0.0)

    private val diff by option(
        "--diff",
        help = "Write a picture of the differences, a .png file: yellow to red where the pictures differ",
    ).path()

    private val isJson by option("--json", help = "Print one JSON object").flag()

    override fun help(context: Context): String =
        "Compares the pixels of two image files, and prints how many differ, by how much, and where.\n\nFile " +
            "format and encoding do not matter, only pixels. Exit code 1: the pictures differ, or their sizes do; 2: " +
            "a file could not be read."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli diff golden.png new.png" to "equal, or the number of pixels that differ",
        "zcli diff golden.png new.png --diff where.png" to "also a picture of where they differ",
        "zcli diff golden.png new.png --threshold 2 --json" to "small differences are accepted; for a script",
    )

    override fun run() {
        diff?.let {
            OutputFile.check(it, "--diff", listOf(".png"))
            OutputFile.requireDistinct(listOf("EXPECTED" to expected, "--diff" to it))
            OutputFile.requireDistinct(listOf("ACTUAL" to actual, "--diff" to it))
        }

        val difference = PictureDifference.between(Picture.read(expected), Picture.read(actual), threshold)
        diff?.let {
            difference.writeMarked(it)
            streams.remark("wrote $it")
        }
        val text = DifferenceText("$expected", "$actual", difference)
        streams.print(if (isJson) Json.of(text.toJson()) + "\n" else text.lines)
        if (!difference.isMatch) throw ProgramResult(ExitCode.DIFFERENT)
    }
}
