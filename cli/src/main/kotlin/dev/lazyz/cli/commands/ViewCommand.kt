package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import dev.lazyz.cli.input.NamedInputs
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.INPUT_HELP
import dev.lazyz.cli.options.LimitOptions
import dev.lazyz.cli.options.ParameterOptions
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.view.ViewJob
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureParameters

/** `zcli view`: declares the options. [ViewJob] does the work. */
internal class ViewCommand(private val streams: Streams) : Command("view") {
    private val inputs by argument(
        "INPUT",
        help = "$INPUT_HELP; or a folder: all models and scene files in it",
        completionCandidates = Completions.inputs,
    ).multiple(required = true)
    private val reading by ParameterOptions(ParameterGroup.READING)
    private val picture by ParameterOptions(
        ParameterGroup.PICTURE, mapOf(PictureParameters.SIZE to "960x640, of the window when it opens"),
    )
    private val light by ParameterOptions(ParameterGroup.LIGHT)
    private val camera by ParameterOptions(ParameterGroup.CAMERA)
    private val lines by ParameterOptions(ParameterGroup.LINES)
    private val limits by LimitOptions()

    override fun help(context: Context): String =
        "Shows models in a window, to be turned, cut and picked with the mouse or the keyboard.\n\nThe menus of the " +
            "window list what keys do. It reads a file again when it changes, and copies the picture, or the command " +
            "'zcli render' that makes it. It needs a display, but no graphics driver."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli view part.stl" to "a model",
        "zcli view models/ --edges --light three-point" to "all models of a folder, one after the other",
    )

    override fun run() {
        val settings = listOf(reading, picture, light, camera, lines)
            .fold(ParameterOptions.NONE) { all, group -> group.addTo(all) }
        val named = NamedInputs(inputs, settings[PictureParameters.FORMAT])
        val shown = named.all.map { ShownInput(it, settings, limits.limits(null), limits.time, false) }.toList()
        ViewJob(shown, streams).run()
    }
}
