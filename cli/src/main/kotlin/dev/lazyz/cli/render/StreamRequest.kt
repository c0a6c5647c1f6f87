package dev.lazyz.cli.render

import dev.lazyz.cli.output.Mistake
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
        return subject.lineWork.wholeModel ?: subject.light.wholeModel ?: subject.antiAliasing.wholeModel
            ?: request.aovs.files.firstOrNull()?.first?.substringBefore(' ')
            ?: "--texture".takeIf { subject.texture != null }
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
}
