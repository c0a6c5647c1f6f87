package dev.lazyz.cli.batch

import dev.lazyz.cli.input.Input
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.OutputTemplate
import dev.lazyz.cli.output.Placeholder
import dev.lazyz.cli.output.printable
import dev.lazyz.cli.render.Outputs
import dev.lazyz.cli.render.PictureFile
import dev.lazyz.cli.render.StatsForm
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.scenes.writers.animation.AnimationFormat
import dev.lazyz.world.camera.FittedViewpoint.View
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name

/** What becomes of the pictures. */
internal enum class Kind { STILLS, ANIMATIONS, SHEET }

/**
 * The pictures of an input from one [view], null for the side that the options choose.
 *
 * @property files a file for each frame, one for an animation of all, or none if they are cells of a sheet
 * @property firstCell the number of the first picture among all of the batch
 */
internal class ViewPlan(val view: View?, val files: List<Path>, val firstCell: Int, val labels: List<String>)

/** The pictures of an [input]. */
internal class InputPlan(val input: String, val views: List<ViewPlan>)

/**
 * What a batch renders, and to which files: known, and checked, before anything is read.
 *
 * @throws Mistake if options contradict each other, two pictures would have the same file, or a file cannot be written
 *   or is an input
 */
internal class BatchPlan(private val request: BatchRequest) {
    private val series = request.series
    private val views: List<View?> = request.views.ifEmpty { listOf(null) }

    /** Pictures from each view. */
    val frames: Int = series.turntable ?: 1

    /** Pictures of each input. */
    val perInput: Int = Math.multiplyExact(views.size, frames)

    private val template = OutputTemplate(request.output ?: usualOutput())

    val kind: Kind = when {
        series.isSheet -> Kind.SHEET
        series.turntable != null && Placeholder.FRAME !in template.placeholders -> Kind.ANIMATIONS
        else -> Kind.STILLS
    }

    /** The file of the contact sheet. */
    val sheet: Path get() = Path.of(checkNotNull(template.name) { "a sheet is one file" })

    val inputs: List<InputPlan>

    /** The files that are replaced. */
    val replaced: OutputPlaces

    init {
        requireSense()
        val labels = InputLabels(request.inputs)
        inputs = request.inputs.mapIndexed { number, input -> plan(number, input, labels) }
        requireDistinct()
        val files = if (kind == Kind.SHEET) {
            listOf(sheet)
        } else {
            inputs.flatMap { input -> input.views.flatMap { it.files } }
        }
        files.forEach { check(it) }
        replaced = OutputPlaces(files.flatMap { PictureFile.places(it) }.map { "-o" to it })
        request.inputs.forEach { request.shown(it).requireKept(replaced) }
    }

    /** Whether the animations are GIF files, which are in memory until they are complete. */
    private val isGif: Boolean = kind == Kind.ANIMATIONS && template.text.endsWith(".gif", ignoreCase = true)

    /** Returns the bytes in which the frames of an animation, of so many pixels each, are kept. */
    fun collected(pixels: Long): Long = if (isGif) frames * pixels * GIF_BYTES_PER_PIXEL + GIF_BYTES else 0

    /** Returns why an animation cannot have frames of [width] x [height] pixels, or null if it can. */
    fun obstacle(width: Int, height: Int): String? = if (isGif) AnimationFormat.GIF.obstacle(width, height) else null

    private fun usualOutput(): String = when {
        series.isSheet -> "contact-sheet.png"
        views.size > 1 -> "{stem}_{view}.png"
        else -> "{stem}.png"
    }

    private fun requireSense() {
        val places = template.placeholders
        if (template.text == Outputs.STANDARD_OUTPUT) {
            throw Mistake("several pictures cannot go to standard output; use -o with a name such as {stem}_{view}.png")
        }
        if (request.inputs.size > 1 && "-" in request.inputs) {
            throw Mistake("standard input cannot be one of several inputs")
        }
        if (series.columns != null && kind != Kind.SHEET) throw Mistake("--columns needs --contact-sheet")
        if (series.framesPerSecond != null && kind != Kind.ANIMATIONS) {
            throw Mistake(
                if (series.turntable == null) {
                    "--frames-per-second needs --turntable"
                } else {
                    "--frames-per-second is for one file with all frames; these are single pictures"
                },
            )
        }
        if (kind == Kind.SHEET && places.isNotEmpty()) {
            throw Mistake("-o ${template.text}: a contact sheet is one file, so its name has no placeholders")
        }
        if (Placeholder.FRAME in places && series.turntable == null) throw Mistake("{frame} in -o needs --turntable")
    }

    private fun plan(number: Int, word: String, labels: InputLabels): InputPlan {
        val input = Input(word, null)
        val plans = views.mapIndexed { at, view ->
            val files = when (kind) {
                Kind.SHEET -> emptyList()
                Kind.ANIMATIONS -> listOf(file(number, input, word, view, 0))
                Kind.STILLS -> List(frames) { file(number, input, word, view, it) }
            }
            val first = number * perInput + at * frames
            ViewPlan(view, files, first, List(frames) { label(labels[number], view, it) })
        }
        return InputPlan(word, plans)
    }

    private fun label(name: String, view: View?, frame: Int): String = listOfNotNull(
        name,
        view?.name?.lowercase(),
        if (series.turntable == null) null else "${frame + 1}",
    ).joinToString(" ")

    private fun file(number: Int, input: Input, word: String, view: View?, frame: Int): Path {
        val name = template.expand { placeholder ->
            when (placeholder) {
                Placeholder.DIR -> input.folder
                Placeholder.STEM -> named(input.baseName, placeholder, input)
                Placeholder.NAME -> named(input.baseName?.let { Path.of(word).name }, placeholder, input)
                Placeholder.EXT -> named(input.baseName?.let { Path.of(word).extension }, placeholder, input)
                Placeholder.VIEW -> view?.name?.lowercase() ?: request.viewName
                Placeholder.INDEX -> numbered(number, request.inputs.size)
                Placeholder.FRAME -> numbered(frame, frames)
            }
        }
        return Path.of(name)
    }

    private fun named(text: String?, placeholder: Placeholder, input: Input): String = text?.ifEmpty { null } ?: run {
        val remedy = if (input.baseName == null) {
            "use ${Placeholder.INDEX.word}"
        } else {
            "${Placeholder.NAME.word} is the name with its extension, if it has one"
        }
        throw Mistake("-o ${template.text}: ${input.name} has no ${placeholder.word}; $remedy")
    }

    /** Returns the number from 1, with leading zeros, so that names sort in its order. */
    private fun numbered(number: Int, of: Int): String = "${number + 1}".padStart("$of".length, '0')

    private fun requireDistinct() {
        val users = HashMap<Path, String>()
        for (input in inputs) {
            for (view in input.views) {
                for (file in view.files) {
                    val user = listOfNotNull(input.input, view.view?.name?.lowercase()).joinToString(", ")
                    val other = users.put(file.toAbsolutePath().normalize(), user)
                    if (other != null) {
                        // A misspelt option is an input, too: report that first
                        for (word in request.inputs) Input(word, request.shown(word).format).requireNamed()
                        throw Mistake(clash(file, other, user))
                    }
                }
            }
        }
    }

    private fun check(file: Path) {
        OutputFile.requireEnding(file, "-o", endings)
        if (template.placeholders.isEmpty()) {
            OutputFile.requirePlace(file)
        } else {
            OutputFile.requireFolderOrPlaceForIt(file)
        }
        if (request.output == null && Files.exists(file)) {
            throw Mistake("$file exists; to replace it, use -o '${template.text}'")
        }
    }

    private fun clash(file: Path, first: String, second: String): String {
        val used = template.placeholders
        if (used.isEmpty() && file.extension.isEmpty()) {
            val names = if (views.size > 1) "{stem}_{view}.png" else "{stem}.png"
            val folder = template.text.trimEnd('/')
            return "$file is no name of several pictures; for a folder of them, use -o '$folder/$names'"
        }
        val missing = when {
            views.size > 1 && Placeholder.VIEW !in used -> Placeholder.VIEW
            used.none { it == Placeholder.STEM || it == Placeholder.NAME } -> Placeholder.STEM
            Placeholder.DIR !in used && Input(first, null).folder != Input(second, null).folder -> Placeholder.DIR
            else -> Placeholder.INDEX
        }
        return "two pictures would be written to $file: of $first and of $second; add ${missing.word} to -o"
    }

    private val endings: List<String>
        get() = when (kind) {
            Kind.STILLS -> PictureFile.ENDINGS
            Kind.ANIMATIONS -> listOf(".png", ".apng", ".gif")
            Kind.SHEET -> listOf(".png")
        }

    private companion object {
        /** The colour, and the number of the palette in the image that is written. */
        const val GIF_BYTES_PER_PIXEL = 5L

        /** The histogram and the palette. */
        const val GIF_BYTES = 12L shl 20
    }
}

/**
 * What the [inputs] are called in labels and messages: the names of their files, without extension. Those that would be
 * the same get what tells them apart, the extension or so many folders as are necessary.
 */
internal class InputLabels(private val inputs: List<String>) {
    private val labels: List<String> = inputs.map { label(it, 0, false) }.toMutableList().also { all ->
        val levels = inputs.maxOfOrNull { Path.of(it).nameCount } ?: 0
        for (same in all.indices.groupBy { all[it] }.values.filter { it.size > 1 }) {
            val ways = (0 until levels).asSequence().flatMap { listOf(it to false, it to true) }
            val others = same.map { inputs[it] }.distinct()
            val (folders, isWhole) = ways.firstOrNull { (folders, isWhole) ->
                others.map { label(it, folders, isWhole) }.distinct().size == others.size
            } ?: continue
            for (number in same) all[number] = label(inputs[number], folders, isWhole)
        }
    }

    /** Returns the label of the input with this number. */
    operator fun get(number: Int): String = labels[number]

    /** Returns a label of [word] with so many [folders], and with its extension if it [isWhole]. */
    private fun label(word: String, folders: Int, isWhole: Boolean): String {
        val input = Input(word, null)
        val base = input.baseName ?: return printable(input.name)
        val path = input.file ?: return base
        val above = (path.parent?.map { "$it" }.orEmpty()).takeLast(folders)
        return printable((above + if (isWhole) path.name else base).joinToString("/"))
    }
}

/**
 * The options of `zcli render` for several pictures; null if the user did not give the option.
 *
 * @property inputs the inputs, with folders replaced by their files
 * @property shown returns what to show of the input with the given name
 * @property views the sides of `--views`; empty for the side that the other options choose
 * @property viewName the name of that side
 * @property output the value of `-o`
 * @property series the pictures of each input and view
 * @property blanks what happens if a picture is blank
 * @property args the words of the command line, for bug reports
 */
internal class BatchRequest(
    val inputs: List<String>,
    val shown: (String) -> ShownInput,
    val views: List<View>,
    val viewName: String,
    val output: String?,
    val series: Series,
    val strategy: String?,
    val choices: Choices,
    val stats: StatsForm?,
    val blanks: BlankPictures,
    val args: List<String>,
)

/**
 * The options about the pictures of each input and view, and what becomes of them; null if the user did not give the
 * option.
 *
 * @property turntable number of steps
 * @property isSheet whether all pictures become cells of one contact sheet
 */
internal class Series(val turntable: Int?, val framesPerSecond: Int?, val isSheet: Boolean, val columns: Int?)
