package dev.lazyz.cli.render

import dev.lazyz.Image
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.Version
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneMemoryException
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.aov.AovFormat
import dev.lazyz.scenes.aov.AovPicture
import dev.lazyz.scenes.writers.writePng
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

/** A file for [aovs]. */
internal class AovOutput(val aovs: List<Aov>, val path: Path) {
    override fun toString(): String = "${aovs.joinToString(",") { it.id }}=$path"
}

/**
 * The files of arbitrary output variables: [data], and [pictures] with legends.
 */
internal class AovOutputs(private val data: List<AovOutput>, private val pictures: List<AovOutput>) {
    /** All that is to be computed. */
    val aovs: Set<Aov> = (data + pictures).flatMap { it.aovs }.toSet()

    /** The files, each with its option. */
    val files: List<Pair<String, Path>> =
        data.map { "$DATA $it" to it.path } + pictures.map { "$PICTURE $it" to it.path }

    /** Memory for each pixel of a picture. */
    val bytesPerPixel: Long = aovs.sumOf { Int.SIZE_BYTES * it.channels.size } + (if (pictures.isEmpty()) 0L else 12L)

    init {
        for (output in data) {
            OutputFile.check(output.path, DATA, AovFormat.entries.map { ".${it.id}" })
            val format = checkNotNull(AovFormat.ofPath(output.path))
            if (output.aovs.size > 1 && format != AovFormat.NPZ) {
                throw Mistake("$DATA: a .${format.id} file has room for one AOV; use .npz for several: ${output.path}")
            }
            for (aov in output.aovs) format.obstacle(aov)?.let { throw Mistake("$DATA ${aov.id}=${output.path}: $it") }
        }
        for (output in pictures) {
            OutputFile.check(output.path, PICTURE, listOf(".png"))
            if (output.aovs.size > 1) throw Mistake("$PICTURE: a picture shows one AOV; repeat the option for more")
        }
    }

    /** Writes all files. Each appears only when it is complete. */
    fun write(images: AovImages) {
        for (output in data) {
            try {
                AovFiles.write(output.path, output.aovs.map { images[it] })
            } catch (unfit: IllegalArgumentException) {
                throw Mistake(unfit.message.orEmpty())
            }
        }
        for (output in pictures) picture(images[output.aovs.single()]).writePng(output.path)
    }

    private fun picture(image: AovImage): Image = try {
        AovPicture.of(image)
    } catch (tooLarge: ArithmeticException) {
        throw Mistake("$PICTURE: ${image.width}x${image.height} with a legend are too many pixels; use a --region")
    }

    private companion object {
        const val DATA = "--aov"
        const val PICTURE = "--aov-picture"
    }
}
