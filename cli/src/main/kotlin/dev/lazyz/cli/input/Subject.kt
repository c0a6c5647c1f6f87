package dev.lazyz.cli.input

import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.pictures.NoPictureException
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import java.nio.file.Path
import java.time.Duration

/**
 * What to show of an input.
 *
 * @property isCameraPrinted whether to print the camera of each picture
 * @throws NoPictureException if two options exclude each other
 */
internal class Subject(
    val input: String,
    val settings: PictureSettings,
    limits: LoadLimits,
    val timeLimit: Duration?,
    val isCameraPrinted: Boolean,
) {
    val format: SceneFormat? = settings[PictureParameters.FORMAT]
    val loading: LoadOptions = settings.loadOptions(limits)
    private val texture = settings[PictureParameters.TEXTURE]
    private val matcap = settings[PictureParameters.MATCAP]

    init {
        settings.check()
    }

    /**
     * Checks that no output replaces a file that the options name.
     *
     * @throws dev.lazyz.cli.output.Mistake otherwise
     */
    fun requireKept(outputs: OutputPlaces) {
        outputs.requireNone(listOfNotNull(Input(input, format).file), "an input")
        outputs.requireNone(listOfNotNull(texture), "the input of --texture")
        outputs.requireNone(listOfNotNull(matcap), "the input of --matcap")
    }

    /** The files that the options name. */
    val files: List<Path> get() = listOfNotNull(Input(input, format).file, texture, matcap)
}
