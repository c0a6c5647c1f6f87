package dev.lazyz.cli.render

import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.strategies.Choices
import java.nio.file.Path

/** The output format of statistics. */
internal enum class StatsForm { TABLE, JSON }

/**
 * The options of `zcli render`; null if the user did not give the option.
 *
 * @property blanks what happens if the picture is blank
 * @property streamingForMemory how the model is read part by part if [memory] requires it
 */
internal class RenderRequest(
    val subject: Subject,
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
