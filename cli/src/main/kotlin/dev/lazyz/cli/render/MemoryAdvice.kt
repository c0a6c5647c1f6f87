package dev.lazyz.cli.render

import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.SceneFormat

/**
 * A step of a rendering that does not fit into memory.
 *
 * @property what what does not fit
 * @property need how many bytes it needs, if that is known
 * @property streamed the format of the model, if it can be read part by part, and is not yet
 */
internal class Shortage(val what: String, val need: Long?, val streamed: SceneFormat? = null)

/**
 * The memory with which a whole rendering fits.
 *
 * @property bytes the bytes, or null if that is not known
 * @property isEstimate whether it is not measured, but estimated by the size of the model
 */
internal class Enough(val bytes: Long?, val isEstimate: Boolean = false)

/** The mistake that a rendering does not fit into memory. [enough] bytes would do, if that is known. */
internal class MemoryRefusal(message: String, val enough: Long?) : Mistake(message)

/**
 * What to do if a rendering of [request] does not fit into memory.
 *
 * @param allowed the bytes of `--memory`
 * @param memory the bytes of them that can be used
 */
internal class MemoryAdvice(private val request: RenderRequest, private val allowed: Long, private val memory: Long) {
    /** Whether Java was started with less memory than `--memory` allows, and not only keeps a part for itself. */
    private val isHeapSmaller = memory < allowed / 4 * 3

    /**
     * Returns the mistake to report.
     *
     * @param shortage the first step that does not fit
     * @param plan the plan that needs the least, if there is one
     * @param canShrink whether a smaller picture would fit
     */
    fun refusal(
        shortage: Shortage,
        enough: Enough,
        plan: RenderPlan? = null,
        canShrink: Boolean = false,
    ): MemoryRefusal {
        val verb = if (shortage.need == null) "needs more" else "needs ${Bytes.readable(shortage.need + TENTH)}"
        val usable = Bytes.readable(memory)
        val limit = when {
            isHeapSmaller -> "and Java was started with only $usable (-Xmx)"
            memory < allowed -> "and --memory allows $usable (${Bytes.readable(allowed)} less a reserve)"
            else -> "and --memory allows $usable"
        }
        val steps = "${larger(enough)}${stream(shortage.streamed)}${smaller(canShrink)}"
        val text = "${shortage.what} $verb, $limit\n${plan?.explain().orEmpty()}$steps See 'zcli render --help'."
        return MemoryRefusal(text, enough.bytes)
    }

    private fun larger(enough: Enough): String {
        val amount = enough.bytes?.let { "${((it + it / MARGIN) shr 20) + SLACK}m" }
        val origin = if (enough.isEstimate) ", an estimate by the size of the model" else ""
        return when {
            isHeapSmaller && amount != null -> "Start Java with -Xmx$amount, and use --memory $amount$origin."
            isHeapSmaller -> "Start Java with a larger -Xmx, and use a larger --memory."
            amount != null -> "Use --memory $amount$origin."
            else -> "Use a larger --memory; how much is enough is not known."
        }
    }

    /** With the parts that a model is read in, most models need less memory. */
    private fun stream(format: SceneFormat?): String =
        StreamRequest.loss(format)?.let { " Or add --stream; $it." }.orEmpty()

    private fun smaller(canShrink: Boolean): String {
        if (!canShrink) return ""
        val ways = listOfNotNull(
            "a smaller --size", "a --region",
            "--aa 1".takeIf { request.shown.settings.run { factor > 1 && !hasOcclusion } },
            "a .ppm file".takeIf { request.output?.endsWith(".ppm") == false },
        )
        return " These need less: ${ways.dropLast(1).joinToString()} or ${ways.last()}."
    }

    private companion object {
        /** Rounds up in the tenths of a mebibyte that are printed. */
        const val TENTH = (1L shl 20) / 10

        /**
         * The memory that is named is larger than what was found to be enough by one part in so many, and mebibytes:
         * what is in memory is measured again, and varies.
         */
        const val MARGIN = 16
        const val SLACK = 3
    }
}
