package dev.lazyz.cli.options

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.split
import com.github.ajalt.clikt.parameters.options.transformAll
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Selector
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.ReferencePolicy
import dev.lazyz.scenes.pictures.NamedValues
import java.time.Duration
import kotlin.math.ceil

/** The help text of INPUT. */
internal const val INPUT_HELP: String =
    "A model (.obj, .stl, .ply, .off, .3mf, .gltf, .glb), a scene file (.json), the name of a built-in scene " +
        "(see 'zcli scenes'), or - for standard input"

/** The option `--classpath`. */
internal fun ParameterHolder.classPath() = option(
    "--classpath",
    metavar = "JAR",
    help = "Also load strategies from here: a jar with an entry META-INF/services/dev.lazyz.Renderer, or a jar " +
        "that it needs; repeat the option for more",
).multiple()

/** The option `--strategy` of commands that compare strategies. */
internal fun ParameterHolder.comparedStrategies() = severalStrategies(
    "Compare this strategy; for more, separate ids by commas, or repeat the option; all others are compared with " +
        "the first; default: all of 'zcli strategies'",
)

/** An option `--strategy` for several, separated by commas or repeated. */
internal fun ParameterHolder.severalStrategies(help: String) = option(
    "--strategy",
    metavar = "ID",
    help = help,
    completionCandidates = Completions.lists { Strategies.ids() },
).split(",").transformAll { it.flatten() }

/** Options of what is printed to standard error, and of the exit code. */
internal class MessageOptions : OptionGroup("Messages and exit code") {
    private val isQuiet by option(
        "--quiet",
        help = "Print no progress to standard error, only warnings and errors; default: what is done is shown if it " +
            "is a terminal; otherwise, long work prints a line every ten seconds",
    ).flag()

    private val isBlankMistake by option(
        "--fail-blank",
        help = "Exit code 1, and an error in place of a warning, if there is nothing to see in a picture: it is all " +
            "background, or has one colour; files are still written",
    ).flag()

    /** Applies the options to [streams], and returns what happens if a picture is blank. */
    fun applyTo(streams: Streams): BlankPictures {
        streams.isQuiet = isQuiet
        return BlankPictures(isBlankMistake)
    }
}

/** Options that change time and memory of the rendering. */
internal class CostOptions : OptionGroup("Cost (the picture stays the same; see 'zcli strategies --long')") {
    private val memoryBudget by option(
        "--memory-budget",
        help = "Maximum working memory of a strategy that can limit it, without the picture and the scene: bytes, or " +
            "with k, m, g (64k, 16MiB); default: no limit. --memory, in contrast, is for the whole program",
    ).bytes()

    private val coherence by option(
        "--coherence",
        help = "How late shading proceeds from pixel to pixel: direct (each separately), incremental (by steps) or " +
            "adaptive (the cheaper one); default: direct",
    ).oneOf("MODE", NamedValues.words(Coherence.entries))

    private val threads by option("--threads", help = "Number of threads, 1 or more; default: one per processor")
        .count { RenderOptions(threads = it) }

    private val tileSize by option(
        "--tile-size",
        help = "Width and height of tiles, a power of two in 8..512; default: ${RenderOptions().tileSize}",
    ).count { RenderOptions(tileSize = it) }

    fun choices(selector: Selector? = null) = Choices(memoryBudget, coherence, threads, tileSize, selector)
}

/** Options that limit what the input can use. */
internal class LimitOptions : OptionGroup("Limits (for untrusted input)") {
    private val isOutsideAllowed by option(
        "--allow-outside",
        help =
        "Follow references (textures, material libraries, buffers, meshes) that lead out of the input's folder; " +
            "default: such files count as missing",
    ).flag()

    private val decoded by option(
        "--max-decoded",
        help =
        "Maximum memory for decoded input: bytes, or with k, m, g; default: 128m plus 512 times the size of the " +
            "files, at most half of Java's memory",
    ).bytes()

    private val triangles by option("--max-triangles", help = "Maximum triangles; default: no limit").count()

    private val vertices by option("--max-vertices", help = "Maximum vertices; default: no limit").count()

    private val texels by option("--max-texels", help = "Maximum pixels of all textures; default: no limit").count()

    private val items by option(
        "--max-items",
        help = "Maximum items such as objects, nodes, materials and properties; default: ${LoadLimits.DEFAULT_ITEMS}",
    ).count()

    private val nesting by option(
        "--max-nesting",
        help = "Maximum depth of nested lists and objects in a scene file, glTF or 3MF, 1..1000; default: " +
            "${LoadLimits.DEFAULT_NESTING}",
    ).count(1..1000)

    private val seconds by option(
        "--max-seconds",
        help = "Maximum processor time for reading and rendering an input, 0..1000000; on the wall, ten times as " +
            "long; default: no limit",
    ).number("SECONDS", 0.0..1e6, " seconds")

    /** The most processor time for an input, from reading to the last picture; null without a limit. */
    val time: Duration? get() = seconds?.let { Duration.ofMillis(ceil(it * MILLISECONDS).toLong()) }

    /** The option that was given of those that have no effect if a model is read part by part, or null. */
    val wholeOption: String? get() = decoded?.let { "--max-decoded" }

    /** Returns the limits, with [spoolBytes] as most bytes of temporary files. */
    fun limits(spoolBytes: Long?) = LoadLimits(
        decodedBytes = decoded,
        triangles = triangles ?: Long.MAX_VALUE,
        vertices = vertices ?: Long.MAX_VALUE,
        texels = texels ?: Long.MAX_VALUE,
        nesting = nesting ?: LoadLimits.DEFAULT_NESTING,
        spoolBytes = spoolBytes,
        items = items ?: LoadLimits.DEFAULT_ITEMS,
        references = if (isOutsideAllowed) ReferencePolicy.ANYWHERE else ReferencePolicy.WITHIN_FOLDER,
    )

    private companion object {
        const val MILLISECONDS = 1000
    }
}
