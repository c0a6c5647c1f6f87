package dev.lazyz.cli.output

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.PixelHash
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.tiled.Tiled

/**
 * What a rendering took, by name, in the order in which it is told. The names are an interface to scripts.
 *
 * @param picture the samples that were rendered
 */
internal class Statistics(
    input: String,
    strategy: Renderer,
    picture: Region,
    counters: Counters,
    tally: Tally,
    warnings: Int,
    nanoseconds: Long,
) {
    val entries: Map<String, Any> = mapOf(
        "input" to input,
        "strategy" to strategy.id,
    ) + (if (strategy is Tiled) mapOf("kernel" to strategy.kernel) else emptyMap()) + mapOf(
        "width" to picture.width,
        "height" to picture.height,
    ) + counted(counters, picture) + mapOf(
        "visible" to tally.visible,
        "coverage" to tally.visible.toDouble() / picture.size,
        "blank" to (tally.visible == 0L),
        "warnings" to warnings,
        "millis" to millis(nanoseconds),
        "pixelHash" to tally.hash(),
    )

    /** Returns one JSON object in one line. */
    fun toJson(): String = Json.of(entries)

    companion object {
        /** What the counters say of rendering [picture]. */
        fun counted(counters: Counters, picture: Region): Map<String, Any> = mapOf(
            "primitives" to counters.primitives,
            "fragments" to counters.fragments,
            "overdraw" to counters.fragments.toDouble() / picture.size,
            "depthEvaluations" to counters.depthEvaluations,
            "depthPasses" to counters.depthPasses,
            "shadingCalls" to counters.shadingCalls,
            "shadingStarts" to counters.shadingStarts,
            "shadingSteps" to counters.shadingSteps,
            "longestChain" to counters.longestChain,
            "peakSuspensions" to counters.peakSuspensions,
            "peakBytes" to counters.peakBytes,
        )

        /** Milliseconds with one decimal. */
        fun millis(nanoseconds: Long): Double = nanoseconds / 100_000 / 10.0
    }
}

/** Looks at the rows on their way: how much is visible, and the picture's identity. */
internal class Tally(private val width: Int, isHashed: Boolean) : RowSink {
    private val hash = if (isHashed) PixelHash() else null

    /** Samples so far at which some primitive is visible. */
    var visible = 0L
        private set

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        var count = 0
        for (x in 0 until width) if (primitive[x] != DepthTest.BACKGROUND) count++
        visible += count
        hash?.add(argb, width)
    }

    /** Returns [dev.lazyz.Image.pixelHash] of the rows. Call it once, after the last. */
    fun hash(): String = checkNotNull(hash) { "nobody asked for a hash" }.digest()
}
