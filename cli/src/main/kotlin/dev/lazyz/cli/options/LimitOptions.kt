package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.ReferencePolicy
import java.time.Duration
import kotlin.math.ceil

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
