package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.batch.Series
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.world.camera.FittedViewpoint.View

/** Options for several pictures. */
internal class SeriesOptions : OptionGroup("Several pictures") {
    val views by option(
        "--views",
        help = "Look from each of these sides, separated by commas, such as iso,front,top, each at most once; a " +
            "picture for each",
    ).listOf("SIDES", NamedValues.words(View.entries))

    private val turntable by option(
        "--turntable",
        help =
        "N pictures, 2..${PictureOutput.MAX_STEPS}, of a turn around the up axis: an animation, -o ends in .png, " +
            ".apng or .gif; or a file for each, if -o contains {frame}",
    ).count(2..PictureOutput.MAX_STEPS)

    private val framesPerSecond by option(
        "--frames-per-second",
        help = "Speed of the animation, 1..${Animation.MAX_FRAMES_PER_SECOND}; default: " +
            "${Animation.DEFAULT_FRAMES_PER_SECOND}",
    ).count(1..Animation.MAX_FRAMES_PER_SECOND)

    private val isSheet by option(
        "--contact-sheet",
        help = "One .png file with all pictures, each with its name below; the default of --size is then 256x256",
    ).flag()

    private val columns by option("--columns", help = "Pictures in a row of the contact sheet, 1..1000")
        .count(1..MOST_COLUMNS)

    fun series() = Series(turntable, framesPerSecond, isSheet, columns)

    private companion object {
        const val MOST_COLUMNS = 1000
    }
}
