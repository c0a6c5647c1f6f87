package dev.lazyz.cli.compare

import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.world.View

/**
 * The options of `zcli compare`.
 *
 * @property strategies ids; if empty, all strategies
 * @property views the sides to look from, one after the other; if empty, the camera of the subject
 * @property blanks what happens if a picture is blank
 */
internal class CompareRequest(
    val strategies: List<String>,
    val choices: Choices,
    val repeat: Int,
    val views: List<View>,
    val blanks: BlankPictures,
)
