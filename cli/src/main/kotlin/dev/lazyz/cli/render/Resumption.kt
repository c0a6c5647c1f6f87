package dev.lazyz.cli.render

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Version
import dev.lazyz.scenes.LoadedScene
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.security.DigestInputStream
import java.security.MessageDigest

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
        return sha.digest().joinToString("") { "%02x".format(it) }
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
