package dev.lazyz.cli.batch

import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.render.StatsForm
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.world.View

/**
 * The options of `zcli render` for several pictures; null if the user did not give the option.
 *
 * @property inputs the inputs, with folders replaced by their files
 * @property subject returns what to show of the input with the given name
 * @property views the sides of `--views`; empty for the side that the other options choose
 * @property viewName the name of that side
 * @property output the value of `-o`
 * @property series the pictures of each input and view
 * @property blanks what happens if a picture is blank
 * @property args the words of the command line, for bug reports
 */
internal class BatchRequest(
    val inputs: List<String>,
    val subject: (String) -> Subject,
    val views: List<View>,
    val viewName: String,
    val output: String?,
    val series: Series,
    val strategy: String?,
    val choices: Choices,
    val stats: StatsForm?,
    val blanks: BlankPictures,
    val args: List<String>,
)

/**
 * The options about the pictures of each input and view, and what becomes of them; null if the user did not give the
 * option.
 *
 * @property turntable number of steps
 * @property isSheet whether all pictures become cells of one contact sheet
 */
internal class Series(val turntable: Int?, val framesPerSecond: Int?, val isSheet: Boolean, val columns: Int?)
