package dev.lazyz.conformance.strangers3

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink

/** Bands of rows, whose columns are divided until a block is small; blocks draw from near to far and reject. */
internal class ColumnSplit(options: RenderOptions = RenderOptions(), mistake: Mistake? = null) :
    Third("columns", options, mistake) {
    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY)

    override fun configured(options: RenderOptions): Renderer = ColumnSplit(options.requireSupportedBy(this), mistake)

    override fun render(frame: Frame, sink: RowSink): Counters {
        when (mistake) {
            Mistake.COLUMNS_REFUSES_LATE -> Unit
            Mistake.COLUMNS_REFUSES_REGION -> refuseTranslucent(frame) { it.meets(frame.region) }
            else -> refuseTranslucent(frame)
        }
        return Rendering(frame, sink).run()
    }

    private inner class Rendering(private val frame: Frame, private val sink: RowSink) {
        private val region = frame.region
        private val counters = Counters.Builder()
        private val entries = arrivals(frame)
        private var entered = 0
        private val alive = ArrayList<Int>()
        private val rows = ROWS
        private val row = OutRow(frame)
        private val used = ArrayList<ColumnBand>()
        private val tops = LongArray(if (mistake == Mistake.COLUMNS_ROW_TABLE) region.height else 0)
        private val numbers = if (mistake == Mistake.COLUMNS_COMPACT) compacted() else null
        private var mostAlive = 0
        private var spanBytes = 0L

        fun run(): Counters {
            counters.primitives = frame.primitives.size.toLong()
            if (mistake == Mistake.COLUMNS_EMPTY_FRAME && frame.primitives.isEmpty()) return counters.build()
            var band = ColumnBand(frame, rows, counters, mistake)
            var top = region.rowStart
            while (top < region.rowEnd) {
                val end = minOf(top + rows, region.rowEnd)
                admit(top, end)
                draw(band, top, end)
                for (y in top until end) {
                    band.copyRow(y - top, row)
                    numbers?.let { renumber(it) }
                    row.send(y, sink)
                    if (tops.isNotEmpty()) tops[y - region.rowStart] = band.top.toLong()
                }
                alive.removeIf { frame.primitives[it].rowEnd <= end }
                spanBytes = maxOf(spanBytes, band.spanBytes)
                if (mistake == Mistake.COLUMNS_KEEPS_BANDS) {
                    used += band
                    band = ColumnBand(frame, rows, counters, mistake)
                }
                top = end
            }
            counters.peakBytes =
                8L * (entries.size + tops.size) + row.bytes + band.bytes + spanBytes + 16L * mostAlive + 64
            return counters.build()
        }

        private fun admit(top: Int, end: Int) {
            while (entered < entries.size && (entries[entered] ushr 32) < end) {
                val index = entries[entered++].toInt()
                if (mistake == Mistake.COLUMNS_REFUSES_LATE) {
                    require(!frame.primitives[index].isTranslucent) { "primitive $index is translucent: asOpaque()" }
                }
                alive += index
            }
            mostAlive = maxOf(mostAlive, alive.size)
        }

        private fun draw(band: ColumnBand, top: Int, end: Int) {
            val order = alive.sortedWith(compareBy<Int> { band.nearest(it) }.thenBy { it }).toIntArray()
            band.begin(top, end, order)
            for ((place, index) in order.withIndex()) gather(band, place, frame.primitives[index])
            split(band, region.columnStart, region.columnEnd, IntArray(order.size) { it })
        }

        private fun gather(band: ColumnBand, place: Int, primitive: Primitive) {
            if (mistake == Mistake.COLUMNS_SPANS_FAIL) {
                try {
                    band.gather(place, primitive)
                } catch (_: IndexOutOfBoundsException) {
                    return
                }
            } else {
                band.gather(place, primitive)
            }
        }

        /** Divides columns until a block is small, with the [places] that may cover something there. */
        private fun split(band: ColumnBand, start: Int, end: Int, places: IntArray) {
            if (end - start <= COLUMNS) {
                val isEmpty = mistake == Mistake.COLUMNS_LONE_COLUMN && end - start <= 1
                band.block(start, end, if (isEmpty) IntArray(0) else places)
                return
            }
            val middle = start + COLUMNS * ((end - start + 2 * COLUMNS - 1) / (2 * COLUMNS))
            split(band, start, middle, places.filter { band.start(it) < middle }.toIntArray())
            split(band, middle, end, places.filter { band.end(it) > middle }.toIntArray())
        }

        /** For each primitive its number among those that cover something. */
        private fun compacted(): IntArray {
            var next = 0
            return IntArray(frame.primitives.size) {
                val primitive = frame.primitives[it]
                if (primitive.rowStart < primitive.rowEnd) next++ else next
            }
        }

        private fun renumber(numbers: IntArray) {
            for (i in 0 until frame.width) if (row.primitive[i] >= 0) row.primitive[i] = numbers[row.primitive[i]]
        }
    }

    private companion object {
        const val ROWS = 16
        const val COLUMNS = 8
    }
}
