package dev.lazyz.cli.render

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Version
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneMemoryException
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.security.DigestInputStream
import java.security.MessageDigest
import java.util.HexFormat

/** The output format of statistics. */
internal enum class StatsForm { TABLE, JSON }

/**
 * The options of `zcli render`; null if the user did not give the option.
 *
 * @property blanks what happens if the picture is blank
 * @property streamingForMemory how the model is read part by part if [memory] requires it
 */
internal class RenderRequest(
    val shown: ShownInput,
    val output: String?,
    val depthOutput: Path?,
    val aovs: AovOutputs,
    val strategy: String?,
    val choices: Choices,
    val isExplained: Boolean,
    val stats: StatsForm?,
    val reference: ReferenceRequest?,
    val streaming: StreamRequest?,
    val streamingForMemory: StreamRequest,
    val resumption: Resumption?,
    val memory: Long?,
    val blanks: BlankPictures,
)

/**
 * The request to read a model part by part, without keeping it in memory.
 *
 * @property spool the folder of temporary files
 */
internal class StreamRequest(spool: Path?) {
    val spool: Path = spool ?: Path.of(System.getProperty("java.io.tmpdir"))

    init {
        if (!Files.isDirectory(this.spool)) throw Mistake("--spool: ${this.spool} is not a folder")
    }

    /** Returns an option of [request] that needs the whole model, or null. */
    fun obstacle(request: RenderRequest): String? {
        val shown = request.shown
        return shown.settings.wholeModel
            ?: request.aovs.files.firstOrNull()?.first?.substringBefore(' ')
            ?: "--max-decoded".takeIf { shown.loading.limits.decodedBytes != null }
    }

    /**
     * Checks that no option of [request] needs the whole model.
     *
     * @throws Mistake otherwise
     */
    fun requirePossible(request: RenderRequest) {
        val option = obstacle(request)
        if (option != null) {
            throw Mistake("$option needs the whole model in memory; it cannot be combined with --stream")
        }
    }

    /** Whether a model can be read part by part for [request], with a strategy of [choice]. */
    fun isPossible(request: RenderRequest, choice: StrategyChoice): Boolean =
        choice.canStream && obstacle(request) == null

    /**
     * Calls [prepare], which reads a model of [format] as a whole for [request] and sets it up. If it does not fit into
     * memory, and could be read part by part, the message says so.
     */
    fun <T> advised(request: RenderRequest, format: SceneFormat?, choice: StrategyChoice, prepare: () -> T): T {
        val loss = loss(format).takeIf { isPossible(request, choice) } ?: return prepare()
        val advice = "add --stream, which reads it in parts ($loss)"
        try {
            return prepare()
        } catch (full: SceneMemoryException) {
            throw Mistake("${full.source}: ${full.problem}; $advice; or ${full.remedy}")
        } catch (full: OutOfMemoryError) {
            throw Mistake("${Failure.mistake(full)}, or $advice")
        }
    }

    companion object {
        /** Returns what a model of [format] loses if it is read part by part, or null if it cannot be. */
        fun loss(format: SceneFormat?): String? = when (format) {
            SceneFormat.STL -> "each triangle then has its own normal"
            SceneFormat.PLY, SceneFormat.OBJ ->
                "each triangle then has its own normal, and materials and textures are not read"
            else -> null
        }
    }
}

/**
 * The option `--resume`: a picture that is interrupted can be completed by the same command.
 *
 * @param args the words of the command line
 */
internal class Resumption(private val args: List<String>) {
    /** Returns what the picture of [loaded], which was read from [source], depends on. */
    fun facts(source: FrameSource, loaded: LoadedScene): Map<String, String> = mapOf(
        "zcli" to Version.text,
        "options" to CommandLine.of(CommandLine.without(args, VALUES).filter { it !in SWITCHES }),
        "files" to (source.files + loaded.files).joinToString(" ") { hash(it) },
    )

    /** Throws [Mistake] if there is another option, of these [others], for which all rows must be rendered. */
    fun requirePossible(picture: Path?, isStandardInput: Boolean, others: List<String>) {
        if (picture == null || !PictureFile.isPyramid(picture)) throw Mistake("$OPTION needs -o NAME.dzi")
        if (isStandardInput) throw Mistake("$OPTION needs an input that can be read again, not standard input")
        val other = others.firstOrNull() ?: return
        throw Mistake("$OPTION cannot be combined with $other, which needs the whole picture at once")
    }

    private fun hash(file: Path): String {
        val sha = MessageDigest.getInstance("SHA-256")
        DigestInputStream(Files.newInputStream(file), sha).use { it.transferTo(OutputStream.nullOutputStream()) }
        return HexFormat.of().formatHex(sha.digest())
    }

    companion object {
        const val OPTION = "--resume"

        /** Options that do not change the picture, with and without a value. */
        private val VALUES = setOf(
            "-o", "--output", "--threads", "--tile-size", "--memory-budget", "--coherence", "--strategy", "--memory",
            "--spool", "--max-spool",
        )
        private val SWITCHES =
            setOf(OPTION, "--quiet", "--stats", "--stats=json", "--stats=table", "--explain", "--print-camera")
    }
}
