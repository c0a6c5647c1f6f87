package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.ReferencePolicy
import java.time.Duration

/** How much the input may ask for. */
internal class LimitOptions : OptionGroup("Limits (for input from strangers)") {
    private val areOthersAllowed by option(
        "--allow-outside",
        help =
        "Follow references (textures, material libraries, buffers, meshes) that lead out of the input's folder; " +
            "default: they count as missing",
    ).flag()

    private val decoded by option(
        "--max-decoded",
        help =
        "Most memory for what is read from the input, in bytes, or with k, m, g; default: 128m and 512 times the " +
            "size of the files, at most half of Java's memory",
    ).bytes()

    private val triangles by option("--max-triangles", help = "Most triangles of the input; default: no limit").count()

    private val vertices by option("--max-vertices", help = "Most vertices of the input; default: no limit").count()

    private val texels by option("--max-texels", help = "Most pixels of all its textures; default: no limit").count()

    private val nesting by option(
        "--max-nesting",
        help = "Most lists and objects within each other in a scene file, glTF or 3MF, 1..1000; default: " +
            "${LoadLimits.DEFAULT_NESTING}",
    ).count(1..1000)

    private val seconds by option("--max-seconds", help = "Most seconds for reading, 0..1000000; default: no limit")
        .number("SECONDS", 0.0..1e6, " seconds")

    /** How much the input may ask for. */
    fun limits() = LoadLimits(
        decodedBytes = decoded,
        triangles = triangles ?: Long.MAX_VALUE,
        vertices = vertices ?: Long.MAX_VALUE,
        texels = texels ?: Long.MAX_VALUE,
        nesting = nesting ?: LoadLimits.DEFAULT_NESTING,
        time = seconds?.let { Duration.ofNanos((it * 1e9).toLong()) },
        references = if (areOthersAllowed) ReferencePolicy.ANYWHERE else ReferencePolicy.WITHIN_FOLDER,
    )
}
