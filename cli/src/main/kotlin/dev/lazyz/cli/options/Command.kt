package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.Nearest
import dev.lazyz.scenes.ImageSize

/** The base class of all commands of zcli: sets how arguments are read and how help is formatted. */
internal abstract class Command(name: String) : CoreCliktCommand(name) {
    init {
        context {
            // The name of a file may begin with @
            readArgumentFile = null
            helpFormatter = { HelpText }
            suggestTypoCorrection = { word, names -> listOfNotNull(Nearest.of(word, names)) }
        }
    }
}

/**
 * The base class of commands that look at how strategies render a picture, with the options of the picture and of cost.
 *
 * @param group the options of the command itself, which come first in the help
 * @param usualSize the size of the picture if the user does not choose; null means that of the scene
 */
internal abstract class PictureCommand<G : OptionGroup>(name: String, group: G, usualSize: ImageSize? = null) :
    Command(name) {
    /** The options of the command itself. */
    protected val own: G by group
    protected val reading: ReadingOptions by ReadingOptions()
    private val picture by PictureOptions(usualSize = usualSize)
    private val light by LightOptions()
    protected val camera: CameraOptions by CameraOptions()
    private val lines by LineOptions()
    protected val cost: CostOptions by CostOptions()
    private val limits by LimitOptions()
    protected val outcome: MessageOptions by MessageOptions()

    /** Returns what the options show of [input]. */
    protected fun subject(input: String): Subject =
        subject(input, reading, limits, picture, light, camera, lines)
}
