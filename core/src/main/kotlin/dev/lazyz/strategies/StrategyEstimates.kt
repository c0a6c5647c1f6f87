package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer

/**
 * What a renderer is expected to take for a frame. Immutable.
 *
 * @property renderer configured as asked
 * @property milliseconds set-up and rendering in a warm JVM, or NaN if it was never measured
 * @property bytes most memory held at a time besides scene and picture, or NaN if it was never measured
 * @property ruledOut why it cannot be chosen, or null
 */
public class StrategyEstimate internal constructor(
    public val renderer: Renderer,
    public val milliseconds: Double,
    public val bytes: Double,
    public val ruledOut: String?,
) {
    override fun toString(): String =
        "StrategyEstimate(${renderer.id}, $milliseconds ms, $bytes bytes, ruledOut=$ruledOut)"
}

/**
 * What all renderers are expected to take for a frame, see [Renderers.estimates]. Immutable.
 *
 * @property numbers what the estimates are made of
 * @property threads as asked
 * @property memory most bytes that a renderer may hold
 * @property all every renderer: those that can be chosen by ascending time, never measured ones behind them, then those that
 *   are ruled out
 */
public class StrategyEstimates private constructor(
    public val numbers: FrameNumbers,
    public val threads: Int,
    public val memory: Long,
    public val all: List<StrategyEstimate>,
    private val usual: StrategyEstimate?,
) {
    /**
     * The one to choose, or null if all are ruled out: the first in the order of [Renderers.all] that is not ruled out, unless
     * another is expected to be [StrategyModel.DOUBT] times as fast; then the fastest.
     */
    public val best: StrategyEstimate?
        get() {
            if (usual == null) return null
            val fastest = all.first()
            return if (usual.milliseconds > StrategyModel.DOUBT * fastest.milliseconds) fastest else usual
        }

    /** Returns lines for people: the frame's numbers, then each renderer with time, memory and why it is ruled out. */
    public fun explain(): String = buildString {
        val kind = if (numbers.isTranslucent) "some translucent" else "all opaque"
        append("frame: ${numbers.columns} x ${numbers.rows}, ${numbers.primitives} primitives, $kind; ")
        append("about %.2f fragments a sample, ".format(null, numbers.depthComplexity))
        append("%.1f rows a primitive\n".format(null, numbers.primitiveRows / maxOf(1, numbers.primitives)))
        append("threads: $threads; memory: ${mebibytes(memory.toDouble())}\n")
        for (estimate in all) {
            val time = if (estimate.milliseconds.isNaN()) "not measured" else time(estimate.milliseconds)
            val bytes = if (estimate.bytes.isNaN()) "" else mebibytes(estimate.bytes)
            val reason = estimate.ruledOut?.let { "  ruled out: $it" }.orEmpty()
            append("  %-13s %12s %12s%s\n".format(null, estimate.renderer.id, time, bytes, reason))
        }
    }

    override fun toString(): String = "StrategyEstimates(best=${best?.renderer?.id}, $numbers)"

    internal companion object {
        private const val MEBIBYTE = 1024.0 * 1024.0

        fun of(
            renderers: List<Renderer>,
            frame: Frame,
            options: RenderOptions,
            needs: Set<Capability>,
            memory: Long,
        ): StrategyEstimates {
            val numbers = FrameNumbers.of(frame)
            val implied = listOfNotNull(
                Capability.TRANSPARENCY.takeIf { numbers.isTranslucent },
                Capability.MEMORY_BUDGET.takeIf { options.memoryBudget != null },
                Capability.SELECTION.takeIf { options.selector != null },
            )
            val estimates = renderers.map {
                estimate(it.configured(options), numbers, options, needs + implied, memory)
            }
            val (possible, impossible) = estimates.partition { it.ruledOut == null }
            // Sorting is stable, and NaN comes last
            val sorted = possible.sortedBy { it.milliseconds } + impossible
            return StrategyEstimates(numbers, options.threads, memory, sorted, possible.firstOrNull())
        }

        private fun estimate(
            renderer: Renderer,
            numbers: FrameNumbers,
            options: RenderOptions,
            needs: Set<Capability>,
            memory: Long,
        ): StrategyEstimate {
            val missing = needs.sorted() - renderer.capabilities
            val bytes = StrategyModel.bytes(renderer.id, numbers, options.memoryBudget)
            val ruledOut = when {
                missing.isNotEmpty() -> "lacks " + missing.joinToString { it.name.lowercase().replace('_', ' ') }
                bytes > memory -> "needs about ${mebibytes(bytes)}"
                else -> null
            }
            val time = StrategyModel.milliseconds(renderer.id, numbers, options.threads)
            return StrategyEstimate(renderer, time, bytes, ruledOut)
        }

        private fun mebibytes(bytes: Double): String = "%.1f MiB".format(null, bytes / MEBIBYTE)

        private fun time(milliseconds: Double): String = "%.2f ms".format(null, milliseconds)
    }
}
