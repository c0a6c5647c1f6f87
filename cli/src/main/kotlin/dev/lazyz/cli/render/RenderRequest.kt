package dev.lazyz.cli.render

import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.strategies.Choices
import java.nio.file.Path

/** How to tell what the rendering took. */
internal enum class StatsForm { TABLE, JSON }

/** What `zcli render` is asked to do, as the user said it; null means: not said. */
internal class RenderRequest(
    val subject: Subject,
    val output: String?,
    val depthOutput: Path?,
    val strategy: String?,
    val choices: Choices,
    val isExplained: Boolean,
    val stats: StatsForm?,
)
