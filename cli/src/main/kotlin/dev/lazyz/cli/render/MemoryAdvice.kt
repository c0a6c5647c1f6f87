package dev.lazyz.cli.render

import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.planning.RenderPlan
import dev.lazyz.scenes.SceneFormat

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
     * @param what what does not fit
     * @param need how many bytes it needs, if that is known
     * @param plan the plan that needs the least, if there is one
     * @param canShrink whether a smaller picture would fit
     * @param streamed the format of the model, if it can be read part by part, and is not yet
     */
    fun refusal(
        what: String,
        need: Long?,
        plan: RenderPlan? = null,
        canShrink: Boolean = false,
        streamed: SceneFormat? = null,
    ): Mistake {
        val verb = if (need == null) "needs more" else "needs ${Bytes.readable(need + TENTH)}"
        val usable = Bytes.readable(memory)
        val limit = when {
            isHeapSmaller -> "and Java was started with only $usable (-Xmx)"
            memory < allowed -> "and --memory allows $usable (${Bytes.readable(allowed)} less a reserve)"
            else -> "and --memory allows $usable"
        }
        val steps = "${larger(need)}${stream(streamed)}${smaller(canShrink)}"
        return Mistake("$what $verb, $limit\n${plan?.explain().orEmpty()}$steps See 'zcli render --help'.")
    }

    private fun larger(need: Long?): String {
        val enough = need?.let { "${((it + it / MARGIN) shr 20) + SLACK}m" }
        return when {
            isHeapSmaller && enough != null -> "Start Java with -Xmx$enough, and use --memory $enough."
            isHeapSmaller -> "Start Java with a larger -Xmx, and use a larger --memory."
            enough != null -> "Use --memory $enough."
            else -> "Use a larger --memory; how much is enough is not known."
        }
    }

    /** With the parts that a model is read in, most models need less memory. */
    private fun stream(format: SceneFormat?): String = when (format) {
        SceneFormat.STL -> " Or add --stream; each triangle then has its own normal."
        SceneFormat.PLY, SceneFormat.OBJ ->
            " Or add --stream; each triangle then has its own normal, and materials and textures are not read."
        else -> ""
    }

    private fun smaller(canShrink: Boolean): String {
        if (!canShrink) return ""
        val ways = listOfNotNull(
            "a smaller --size", "a --region",
            "--aa 1".takeIf { request.subject.antiAliasing.wanted > 1 && !request.subject.light.hasOcclusion },
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
