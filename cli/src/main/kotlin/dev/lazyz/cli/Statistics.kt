package dev.lazyz.cli

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.PixelHash
import dev.lazyz.Raster
import dev.lazyz.RowSink

/** What a rendering took, by name, in the order in which it is told. The names are an interface to scripts. */
internal class Statistics(
    input: String,
    strategy: String,
    raster: Raster,
    counters: Counters,
    tally: Tally,
    warnings: Int,
    nanoseconds: Long,
) {
    val entries: List<Pair<String, Any>> = listOf(
        "input" to input,
        "strategy" to strategy,
        "width" to raster.width,
        "height" to raster.height,
        "primitives" to counters.primitives,
        "fragments" to counters.fragments,
        "overdraw" to counters.fragments.toDouble() / raster.size,
        "depthEvaluations" to counters.depthEvaluations,
        "depthPasses" to counters.depthPasses,
        "shadingCalls" to counters.shadingCalls,
        "shadingStarts" to counters.shadingStarts,
        "shadingSteps" to counters.shadingSteps,
        "longestChain" to counters.longestChain,
        "peakSuspensions" to counters.peakSuspensions,
        "peakBytes" to counters.peakBytes,
        "visible" to tally.visible,
        "coverage" to tally.visible.toDouble() / raster.size,
        "blank" to (tally.visible == 0L),
        "warnings" to warnings,
        "millis" to nanoseconds / 100_000 / 10.0,
        "pixelHash" to tally.hash(),
    )

    /** Returns one JSON object (RFC 8259) in one line of ASCII. */
    fun toJson(): String = entries.joinToString(", ", "{", "}") { (key, value) ->
        "\"$key\": " + if (value is String) quoted(value) else value.toString()
    }

    private fun quoted(text: String): String = buildString {
        append('"')
        for (char in text) {
            when {
                char == '"' || char == '\\' -> append('\\').append(char)
                char in ' '..'~' -> append(char)
                else -> append("\\u").append(char.code.toString(16).padStart(4, '0'))
            }
        }
        append('"')
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
