package dev.lazyz.cli.compare

import dev.lazyz.cli.input.View
import dev.lazyz.cli.strategies.Choices

/**
 * How `zcli compare` is to compare.
 *
 * @property strategies ids; all if there are none
 * @property views the sides to look from, one after the other; as the subject has it if there are none
 */
internal class CompareRequest(
    val strategies: List<String>,
    val choices: Choices,
    val repeat: Int,
    val views: List<View>,
)
