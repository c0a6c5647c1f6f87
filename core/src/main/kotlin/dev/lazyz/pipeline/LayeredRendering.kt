package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.FrameParts
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.Workers

/**
 * Renders a streamed frame that has translucent primitives, with a pass over the parts for each area of the picture. An
 * area is a band of rows, or a part of one row, that is so small that [LayeredSamples] hold it: if an area has too many
 * translucent fragments, the pass ends, and begins again for half of the area.
 *
 * Memory: [mostBytes] or what one row takes, whichever is more, and three parts. A single sample may take more. Used by
 * one thread.
 *
 * @param mostBytes most bytes of an area, unless one row takes more
 * @param mostBytesOfASample most bytes of an area that is a single sample, if this is more
 */
internal class LayeredRendering(
    private val frame: Frame,
    private val parts: FrameParts,
    private val workers: Workers,
    mostBytes: Long,
    mostBytesOfASample: Long = bandBytes(null),
) {
    private val region = frame.region
    private val bytesPerRow = BYTES_PER_SAMPLE * region.width
    private val mostBytes = mostBytes.coerceIn(minOf(bytesPerRow, MOST_BYTES), MOST_BYTES)
    private val mostBytesOfASample = maxOf(mostBytesOfASample, this.mostBytes)
    private val counters = Counters.Builder()

    /** Renders all parts, and passes every row to [sink]. */
    fun run(sink: RowSink): Counters {
        var rows = (mostBytes / bytesPerRow).coerceIn(1, region.height.toLong()).toInt()
        var width = region.width
        var top = region.rowStart
        var left = region.columnStart
        val row = CollectedRow(region)
        while (top < region.rowEnd) {
            val area = Region(left, top, minOf(left + width, region.columnEnd), minOf(top + rows, region.rowEnd))
            val most = if (area.size == 1L) mostBytesOfASample else mostBytes
            val samples = LayeredSamples(frame.raster, area, most, counters)
            val (fragments, depthPasses) = counters.fragments to counters.depthPasses
            if (!draw(area, samples)) {
                require(area.size > 1) { "${tooMany(area)}: ${remedy()}" }

                // The passes over its halves count these fragments; a fragment counts once (contract rule 8.1)
                counters.fragments = fragments
                counters.depthPasses = depthPasses
                if (area.height > 1) rows = (area.height + 1) / 2 else width = (area.width + 1) / 2
                continue
            }
            counters.peakBytes = maxOf(counters.peakBytes, samples.bytes)
            if (area.width == region.width) samples.handOut(sink) else samples.handOut(row.from(left))
            left = area.columnEnd
            if (left == region.columnEnd) {
                if (area.width < region.width) row.handOut(top, sink)
                left = region.columnStart
                top = area.rowEnd
            }
        }
        counters.primitives = parts.size.toLong()
        return counters.build()
    }

    private fun tooMany(area: Region) =
        "column ${area.columnStart} of row ${area.rowStart} has more translucent fragments than fit into memory"

    private fun remedy() =
        "they may take $mostBytesOfASample bytes; allow more memory (-Xmx), " +
            "or make the frame opaque with asOpaque()"

    /** Draws all primitives within [area]. Returns false if there is not enough memory. */
    private fun draw(area: Region, samples: LayeredSamples): Boolean {
        inOrder(parts.reaching(area), workers) { part ->
            for (number in 0 until part.content.size) {
                if (!samples.draw(part.content.primitives[number], part.first + number)) return false
            }
        }
        return true
    }

    /** A row that arrives in pieces. */
    private class CollectedRow(private val region: Region) {
        private val argb by lazy { IntArray(region.width) }
        private val depths by lazy { IntArray(region.width) }
        private val indices by lazy { IntArray(region.width) }

        /** Takes the piece that begins at [column]. */
        fun from(column: Int) = RowSink { _, argb, depth, primitive ->
            val start = column - region.columnStart
            argb.copyInto(this.argb, start)
            depth.copyInto(depths, start)
            primitive.copyInto(indices, start)
        }

        fun handOut(y: Int, sink: RowSink) = sink.row(y, argb, depths, indices)
    }

    companion object {
        /** Bytes of an area for each of its samples, with room for as many translucent fragments as samples. */
        const val BYTES_PER_SAMPLE: Long = LayeredSamples.BYTES_PER_SAMPLE + LayeredSamples.BYTES_PER_LAYER

        /** With more memory, the colours of an area would not fit into one array. */
        private const val MOST_BYTES = 1L shl 34
    }
}
