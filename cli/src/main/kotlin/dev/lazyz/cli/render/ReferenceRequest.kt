package dev.lazyz.cli.render

import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.OutputTemplate
import java.nio.file.Path

/**
 * With what `zcli render` compares the picture.
 *
 * @property file the reference, an image file
 * @property threshold the greatest difference of a channel that is accepted, 0..255
 * @property diff the file for a picture of the differences, or null
 * @param args the words of the command line
 */
internal class ReferenceRequest(
    val file: Path,
    val threshold: Double,
    val diff: Path?,
    private val args: List<String>,
) {
    /** The command that renders the same picture to [file]. */
    val creation: String
        get() {
            val kept = CommandLine.without(args, setOf("-o", "--output", "--ref", "--ref-threshold", "--diff"))
            return CommandLine.of(kept.take(1) + listOf("-o", OutputTemplate.of("$file")) + kept.drop(1))
        }
}
