package dev.lazyz.cli.render

import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneMemoryException
import java.nio.file.Files
import java.nio.file.Path

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
        val subject = request.subject
        return subject.settings.wholeModel
            ?: request.aovs.files.firstOrNull()?.first?.substringBefore(' ')
            ?: "--max-decoded".takeIf { subject.loading.limits.decodedBytes != null }
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
