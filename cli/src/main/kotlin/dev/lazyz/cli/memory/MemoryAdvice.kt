package dev.lazyz.cli.memory

import dev.lazyz.cli.input.Input
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.render.RenderRequest
import dev.lazyz.cli.render.StreamRequest
import dev.lazyz.planning.RenderPlan

/** What to do if a rendering of [request] does not fit into the [allowed] bytes of `--memory`. */
internal class MemoryAdvice(private val request: RenderRequest, private val allowed: Long) {
    /**
     * Returns the mistake to report.
     *
     * @param what what does not fit
     * @param need how many bytes it needs, if that is known
     * @param plan the plan that needs the least, if there is one
     */
    fun refusal(what: String, need: Long?, input: Input, plan: RenderPlan? = null): Mistake {
        val memory = Bytes.readable(allowed)
        val problem = if (need == null) {
            "$what does not fit into --memory $memory"
        } else {
            "$what needs ${Bytes.readable(need)}, and --memory allows $memory"
        }
        val enough = if (need == null) 2 * allowed else need + need / MARGIN
        val remedies = listOfNotNull(
            "--memory ${(enough shr 20) + 1}m" + if (plan == null) " or more" else "",
            "--stream (each triangle then has its own normal)".takeIf { canStream(input) },
            "--aa 1".takeIf { plan != null && request.subject.antiAliasing.wanted > 1 },
            "a smaller --size or a --region".takeIf { plan != null },
            "-o with .ppm".takeIf { plan != null && request.output?.endsWith(".ppm") == false },
        )
        val use = remedies.dropLast(1).joinToString() + (if (remedies.size > 1) " or " else "") + remedies.last()
        return Mistake("$problem\n${plan?.explain().orEmpty()}Use $use. See 'zcli render --help'.")
    }

    private fun canStream(input: Input): Boolean =
        request.streaming == null && input.canStream && StreamRequest(null).obstacle(request) == null

    private companion object {
        /** The memory that is named is larger by one part in so many than what was found to be enough. */
        const val MARGIN = 32
    }
}
