package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.RawOption
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.aov.Aov
import dev.lazyz.cli.batch.Series
import dev.lazyz.cli.render.AovOutput
import dev.lazyz.cli.render.AovOutputs
import dev.lazyz.cli.render.StreamRequest
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.text.EditDistance
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.world.camera.FittedViewpoint.View
import java.nio.file.Path

/** Options for several pictures. */
internal class SeriesOptions : OptionGroup("Several pictures") {
    val views by option(
        "--views",
        help = "Look from each of these sides, separated by commas, such as iso,front,top, each at most once; a " +
            "picture for each",
    ).listOf("SIDES", NamedValues.words(View.entries))

    private val turntable by option(
        "--turntable",
        help =
        "N pictures, 2..${PictureOutput.MAX_STEPS}, of a turn around the up axis: an animation, -o ends in .png, " +
            ".apng or .gif; or a file for each, if -o contains {frame}",
    ).count(2..PictureOutput.MAX_STEPS)

    private val framesPerSecond by option(
        "--frames-per-second",
        help = "Speed of the animation, 1..${Animation.MAX_FRAMES_PER_SECOND}; default: " +
            "${Animation.DEFAULT_FRAMES_PER_SECOND}",
    ).count(1..Animation.MAX_FRAMES_PER_SECOND)

    private val isSheet by option(
        "--contact-sheet",
        help = "One .png file with all pictures, each with its name below; the default of --size is then 256x256",
    ).flag()

    private val columns by option("--columns", help = "Pictures in a row of the contact sheet, 1..1000")
        .count(1..MOST_COLUMNS)

    fun series() = Series(turntable, framesPerSecond, isSheet, columns)

    private companion object {
        const val MOST_COLUMNS = 1000
    }
}

/** Options of arbitrary output variables. */
internal class AovOptions : OptionGroup("Data of pixels (AOVs)") {
    private val data by option(
        "--aov",
        help = "Write what is known of each pixel as data: ${NamedValues.list(ids)}; the extension of FILE " +
            "chooses the format, .pfm, .npy, .png (16 bits), .npz, which takes several, AOV,AOV=FILE.npz, or " +
            "all=FILE.npz, or, for object, .json, a list of visible parts with their names; repeat for more files",
    ).output().multiple()

    private val pictures by option(
        "--aov-picture",
        help = "Write a picture of the same data, with colours and a legend, a .png file; repeat for more",
    ).output().multiple()

    /** What the options ask for. */
    val outputs: AovOutputs get() = AovOutputs(data, pictures)

    private fun RawOption.output() = convert("AOV=FILE", Completions.names { ids + ALL }) { text ->
        val file = text.substringAfter('=', "")
        val words = text.substringBefore('=').lowercase()
        if (file.isEmpty() || words.isEmpty()) fail("'$text' is not AOV=FILE, such as depth=depth.png")
        val aovs = if (words == ALL) {
            Aov.entries
        } else {
            val known = words.split(',')
            known.groupBy { it }.values.firstOrNull { it.size > 1 }?.let { fail("'${it[0]}' is named twice: $text") }
            known.map { word ->
                Aov.ofId(word)
                    ?: fail("'$word' is not one of $ALL, ${ids.joinToString()}${EditDistance.hint(word, ids + ALL)}")
            }
        }
        AovOutput(aovs, Path.of(file))
    }

    private companion object {
        const val ALL = "all"
        val ids = Aov.entries.map { it.id }
    }
}

/** Options of models that are larger than memory. */
internal class StreamOptions : OptionGroup("Large models") {
    private val isStreamed by option(
        "--stream",
        help = "Read the triangles while they are rendered, and do not keep them: for an .stl, .ply or .obj file of " +
            "any size. Each triangle has its own normal; materials and textures are not read. The default strategy, " +
            "zbuffer, hybrid and hierarchical support it; only the default strategy blends translucent surfaces",
    ).flag()

    private val spool by option(
        "--spool",
        help = "The folder for temporary files of --stream and --memory, which take about as much space as the " +
            "model, and a copy of standard input; default: the folder for temporary files of the system",
    ).path("FOLDER")

    /** Most bytes of temporary files, or null. */
    val spoolBytes by option(
        "--max-spool",
        help = "Maximum size of these temporary files: bytes, or with k, m, g; default: the free space, less 64 MiB",
    ).bytes()

    /** What the options ask for, or null. */
    val request: StreamRequest? get() = if (isStreamed) forMemory else null

    /** How a model is read part by part, if that is necessary. */
    val forMemory: StreamRequest get() = StreamRequest(spool)

    /** The option that was given of those that have an effect only if a model is read part by part, or null. */
    val spoolOption: String? get() = if (spool != null) "--spool" else spoolBytes?.let { "--max-spool" }
}

/** Options of the memory of the whole program. */
internal class MemoryOptions : OptionGroup("Memory") {
    val bytes by option(
        "--memory",
        help =
        "Stay within this memory for Java's objects: bytes, or with k, m, g. Chooses strategy, threads, tiles and " +
            "passes accordingly, or refuses and says what would fit; --explain prints the plan. The launcher " +
            "script starts Java with -Xmx of this size; with java -jar, add it yourself. --memory-budget, in " +
            "contrast, is for the working memory of some strategies",
    ).bytes()
}
