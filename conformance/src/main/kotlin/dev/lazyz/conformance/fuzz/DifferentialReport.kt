package dev.lazyz.conformance.fuzz

import dev.lazyz.conformance.results.counted
import java.util.Locale

/**
 * The result of comparing two renderers on many frames. Immutable and thread safe.
 *
 * @property expected id of the renderer that is assumed to be correct
 * @property actual id of the other renderer
 * @property frames number of frames that both rendered
 * @property remembered number of frames from the corpus among them
 * @property pairs number of pairs of traits that occurred
 * @property differences for each frame that differs: the first sample, both values, the frame as code, its recipe
 * @property milliseconds duration
 */
public class DifferentialReport internal constructor(
    public val expected: String,
    public val actual: String,
    public val frames: Long,
    public val remembered: Long,
    public val pairs: Int,
    public val differences: List<String>,
    public val milliseconds: Long,
) {
    /** Whether all pictures are equal. */
    public val isEqual: Boolean get() = differences.isEmpty()

    /** Returns a summary for people. */
    public fun toText(): String = buildString {
        for (difference in differences) append(difference).append("\n\n")
        val verdict = when (differences.size) {
            0 -> "no picture differs"
            1 -> "1 picture differs"
            else -> "${differences.size} pictures differ"
        }
        append("$actual against $expected: ${counted(frames, "frame")}, $remembered of them from the corpus, ")
        append("${counted(pairs.toLong(), "pair")} of traits; $verdict; ")
        append("%.1f s\n".format(Locale.ROOT, milliseconds / 1000.0))
    }

    override fun toString(): String = "DifferentialReport($actual against $expected, $frames frames, " +
        "${differences.size} differences)"
}
