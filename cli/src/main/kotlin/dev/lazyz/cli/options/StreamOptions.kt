package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.render.StreamRequest

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
