package dev.lazyz.cli.report

import dev.lazyz.Image
import dev.lazyz.aov.AovImage
import dev.lazyz.cli.compare.Comparison
import dev.lazyz.cli.compare.Outcome
import dev.lazyz.cli.output.counted
import dev.lazyz.scenes.aov.VisibleObject

/**
 * What is seen of a rendering besides its cost.
 *
 * @property image the pixels
 * @property calls the number of shading calls of each pixel
 * @property order the shading calls in their order, if samples are pixels and there are not too many
 */
internal class Portrait(val image: Image, val calls: AovImage, val order: OrderMap?) {
    /** See [Image.pixelHash]. */
    val hash: String = image.pixelHash()
}

/**
 * What a report says about one strategy.
 *
 * @property outcome the result of the comparison; failed if the [portrait] could not be made
 * @property portrait there if the strategy has rendered
 */
internal class ReportEntry(val id: String, val summary: String, val outcome: Outcome, val portrait: Portrait?) {
    /** What was measured, or null if there is no picture. */
    val rendered: Outcome.Rendered? get() = outcome as? Outcome.Rendered

    /** Why there is no picture, in a few words; empty if there is one. */
    val obstacle: String
        get() = when (outcome) {
            is Outcome.NotBlending -> "does not blend"
            is Outcome.Failed -> "failed"
            is Outcome.Rendered -> ""
        }
}

/**
 * The content of a report: one input, rendered with all strategies.
 *
 * @property comparison times, counters and differences
 * @property entries one for each strategy, in their order
 * @property overdraw the fragments of each pixel, for all strategies the same; null if all failed
 * @property parts what is visible of each surface
 */
internal class Report(
    val input: String,
    val command: String,
    val comparison: Comparison,
    val entries: List<ReportEntry>,
    val overdraw: AovImage?,
    val parts: List<VisibleObject>,
) {
    /** The pixel hash of the picture with which all others are compared, or null if all strategies failed. */
    val hash: String? = comparison.reference?.image?.pixelHash()

    /** The shortest time of a strategy, in nanoseconds, at least 1. */
    val fastest: Long = maxOf(entries.mapNotNull { it.rendered?.nanoseconds }.minOrNull() ?: 1, 1)

    /** Returns whether [entry] has the picture of the others: each time it was compared, and in this report. */
    fun isIdentical(entry: ReportEntry): Boolean =
        entry.rendered != null && entry.rendered?.difference == null && entry.portrait?.hash == hash

    /** The strategies that rendered, or failed to. */
    val tried: List<ReportEntry> get() = entries.filter { it.outcome !is Outcome.NotBlending }

    /** Whether no strategy failed, and all pictures are equal. */
    val isGood: Boolean get() = tried.all { isIdentical(it) }

    /** See [Comparison.bugs]. */
    val bugs: List<Throwable> get() = Comparison.bugs(entries.map { it.id to it.outcome })

    /** The result in one line. */
    val verdict: String
        get() {
            val pixels = comparison.shot.pixels
            val equal = tried.count { isIdentical(it) }
            val skipped = entries.size - tried.size
            val rest = if (skipped == 0) "" else "; $skipped cannot blend translucent surfaces"
            val size = counted(pixels.size, "pixel")
            val result = when {
                isGood && equal == 1 -> "Only one strategy, so nothing was compared; $size"
                isGood -> "Identical: all $equal strategies give the same bits at all $size"
                else -> "Not identical: $equal of ${tried.size} strategies give the same bits at all $size"
            }
            return "$result, pixel hash ${hash ?: "none"}$rest"
        }
}
