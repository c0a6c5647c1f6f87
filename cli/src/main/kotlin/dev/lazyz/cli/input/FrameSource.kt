package dev.lazyz.cli.input

import dev.lazyz.RenderOptions
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Streams
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.scenes.pictures.NoPictureException
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureDrawing
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.View
import java.nio.file.Path
import java.time.Duration

/**
 * Reads the input that [shown] names, and creates the frame that the options describe.
 *
 * @param loading how to read it
 */
internal class FrameSource(
    private val shown: ShownInput,
    private val streams: Streams,
    loading: LoadOptions = shown.loading,
) {
    val input = Input(shown.input, shown.format, loading)

    /** The files that the options name. */
    val files: List<Path> get() = shown.files

    /** Reads the input, and prints its warnings. */
    fun load(): LoadedScene = read().also { warn(it.warnings) }

    /** Opens the input to be read part by part, with temporary files in [spool], and prints its warnings. */
    fun stream(spool: Path): StreamedScene {
        if (shown.loading.animationTime != null) {
            streams.warning("files that are read part by part have no animation, so the requested time has no effect")
        }
        streams.progress("looking through ${input.name} ...")
        return input.stream(streams, spool).also { warn(it.loaded.warnings) }
    }

    private fun warn(warnings: List<String>) {
        warnings.take(MAX_WARNINGS).forEach { streams.warning(it) }
        val rest = warnings.size - MAX_WARNINGS
        if (rest > 0) streams.warning("and $rest more")
    }

    /** Reads the input without printing its warnings. */
    fun read(): LoadedScene {
        streams.progress("reading ${input.name} ...")
        return input.load(streams)
    }

    /**
     * Checks that no output replaces a file that [loaded] was read from.
     *
     * @throws Mistake otherwise
     */
    fun requireKept(loaded: LoadedScene, outputs: OutputPlaces) {
        outputs.requireNone(loaded.files, "a file that ${input.name} refers to")
    }

    /** Returns the settings of the picture, seen from [view] or, if that is null, from the side that they choose. */
    fun settings(view: View?): PictureSettings =
        if (view == null) shown.settings else shown.settings.seenFrom(view)

    /**
     * Returns the picture of [loaded], seen from [view] as [settings] says. It is set up by the threads of [options]. A
     * printed camera begins with [name], unless it is null.
     */
    fun frame(loaded: LoadedScene, options: RenderOptions, view: View? = null, name: String? = null): PictureFrame =
        settings(view).frame(loaded, options, observer(name))

    /** Returns the lines of such a picture. */
    fun drawing(
        loaded: LoadedScene,
        options: RenderOptions,
        view: View? = null,
        name: String? = null,
    ): PictureDrawing = settings(view).drawing(loaded, options, observer(name))

    /** Returns what prints the messages about a picture. A printed camera begins with [name], unless it is null. */
    fun observer(name: String?): PictureObserver = Messages(name)

    /** Returns a picture of nothing, of the size that the options choose. */
    fun blank(options: RenderOptions): PictureFrame {
        val others = PictureParameters.all.filter {
            it.group in listOf(ParameterGroup.CAMERA, ParameterGroup.LIGHT, ParameterGroup.LINES) ||
                it == PictureParameters.TEXTURE
        }
        val settings = others.fold(shown.settings) { all, other -> all.without(other) }
        return settings.frame(LoadedScene(Scene(emptyList()), emptyList()), options)
    }

    private inner class Messages(private val picture: String?) : PictureObserver(input.name, shown.loading.limits) {
        private var progress: Progress? = null

        override fun warning(message: String) = streams.warning(message)

        override fun camera(camera: Camera, up: UpAxis) {
            if (!shown.isCameraPrinted) return
            val words = PictureSettings().seenBy(camera, up).options.joinToString(" ")
            streams.note((if (picture == null) words else "$picture: $words") + "\n")
        }

        override fun shadows(directions: Int) {
            streams.progress("computing shadows ...")
            progress = Progress(streams, directions, "directions", "shadows")
        }

        override fun shadowed() {
            progress?.advance()
        }

        override fun setUp(size: ImageSize) = streams.progress("setting up $size ...")
    }

    private companion object {
        const val MAX_WARNINGS = 20
    }
}

/**
 * What to show of an input.
 *
 * @property isCameraPrinted whether to print the camera of each picture
 * @throws NoPictureException if two options exclude each other
 */
internal class ShownInput(
    val input: String,
    val settings: PictureSettings,
    limits: LoadLimits,
    val timeLimit: Duration?,
    val isCameraPrinted: Boolean,
) {
    val format: SceneFormat? = settings[PictureParameters.FORMAT]
    val loading: LoadOptions = settings.loadOptions(limits)

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
        for ((parameter, file) in settings.files) outputs.requireNone(listOf(file), "the input of --${parameter.name}")
    }

    /** The files that the options name. */
    val files: List<Path> get() = listOfNotNull(Input(input, format).file) + settings.files.values
}
