package dev.lazyz.cli.trace

import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.strategies.Choices
import java.nio.file.Path

/**
 * The options of `zcli trace`.
 *
 * @property strategies ids of one strategy or two; if empty, the usual one
 * @property steps pictures from the first call to the last
 * @property blanks what happens if the picture is blank
 */
internal class TraceRequest(
    val subject: Subject,
    val output: Path,
    val strategies: List<String>,
    val choices: Choices,
    val steps: Int,
    val framesPerSecond: Int,
    val blanks: BlankPictures,
)
