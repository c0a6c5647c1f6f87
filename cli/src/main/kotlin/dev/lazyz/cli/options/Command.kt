package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.text.EditDistance

/** The base class of all commands of zcli: sets how arguments are read and how help is formatted. */
internal abstract class Command(name: String) : CoreCliktCommand(name) {
    init {
        context {
            // The name of a file may begin with @
            readArgumentFile = null
            helpFormatter = { HelpText }
            suggestTypoCorrection = { word, names -> listOfNotNull(EditDistance.nearest(word, names)) }
        }
    }

    /** Ends the program with [code], unless all is well. */
    protected fun end(code: Int) {
        if (code != ExitCode.DONE) throw ProgramResult(code)
    }
}

/**
 * The base class of commands that look at how strategies render a picture, with the options of the picture and of cost.
 *
 * @param group the options of the command itself, which come first in the help
 * @param usualSize the size of the picture if the user does not choose; null means that of the scene
 * @param usualFactor samples a pixel in each direction if the user does not choose
 */
internal abstract class PictureCommand<G : OptionGroup>(
    name: String,
    group: G,
    private val usualSize: ImageSize? = null,
    private val usualFactor: Int = 1,
) : Command(name) {
    /** The options of the command itself. */
    protected val own: G by group
    private val reading by ParameterOptions(ParameterGroup.READING)
    private val picture by ParameterOptions(
        ParameterGroup.PICTURE,
        mapOf(PictureParameters.AA to "$usualFactor") +
            usualSize?.let { mapOf(PictureParameters.SIZE to "$it") }.orEmpty(),
    )
    private val light by ParameterOptions(ParameterGroup.LIGHT)
    private val camera by CameraOptions()
    private val lines by ParameterOptions(ParameterGroup.LINES)
    protected val cost: CostOptions by CostOptions()
    private val limits by LimitOptions()
    protected val outcome: MessageOptions by MessageOptions()

    /** What the options choose. */
    protected val settings: PictureSettings by lazy {
        val usual = ParameterOptions.NONE.withDefault(PictureParameters.AA, usualFactor)
        val sized = if (usualSize == null) usual else usual.withDefault(PictureParameters.SIZE, usualSize)
        listOf(reading, picture, light, camera, lines).fold(sized) { all, group -> group.addTo(all) }
    }

    /** Returns what the options show of [input]. */
    protected fun shown(input: String): ShownInput =
        ShownInput(input, settings, limits.limits(null), limits.time, camera.isPrinted)
}
