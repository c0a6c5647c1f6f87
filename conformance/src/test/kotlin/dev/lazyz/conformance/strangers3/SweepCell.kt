package dev.lazyz.conformance.strangers3

import dev.lazyz.Cell
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Rgba
import dev.lazyz.Selector

/** The fragments of the sample that the sweep is at. */
internal class SweepCell(
    private val frame: Frame,
    private val shading: RowShading,
    private val counters: Counters.Builder,
    private val mistake: Mistake?,
) : Cell {
    private val test = frame.raster.depthTest
    private val limit = frame.backgroundKey
    private var keys = LongArray(16)
    private val memo = HashMap<Int, Rgba>()
    private val echo = Fragment()

    override var x = 0
        private set
    override var y = 0
        private set
    override var size = 0
        private set

    /** Number of what is shown, or -1. */
    var shown = -1
        private set
    var argb = 0
        private set

    val bytes: Long get() = 8L * keys.size + 64

    override val background: Rgba get() = frame.raster.background

    /** Goes to a sample; returns whether there is a fragment. */
    fun moveTo(x: Int, y: Int, active: IntArray, count: Int): Boolean {
        this.x = x
        this.y = y
        size = 0
        shown = -1
        memo.clear()
        if (count > keys.size) keys = LongArray(maxOf(count, 2 * keys.size))
        for (i in 0 until count) {
            val key = test.key(frame.primitives[active[i]].depthAt(x, y), active[i])
            if (key < limit || mistake == Mistake.EVENTS_CELL_BEHIND) keys[size++] = key
        }
        if (mistake == Mistake.EVENTS_CELL_TIES) {
            val order = keys.take(size).sortedWith(compareBy({ it shr 32 }, { test.indexOf(it) }))
            for (i in 0 until size) keys[i] = order[i]
        } else {
            keys.sort(0, size)
        }
        counters.peakSuspensions = maxOf(counters.peakSuspensions, size.toLong())
        if (mistake == Mistake.EVENTS_CELL_LOCAL) this.x = x - frame.region.columnStart
        return size > 0
    }

    override fun depth(i: Int): Int = test.depthOf(key(i))

    override fun primitive(i: Int): Int = test.indexOf(key(i))

    override fun isTranslucent(i: Int): Boolean = frame.primitives[primitive(i)].isTranslucent

    override fun shade(i: Int): Fragment {
        val column = if (mistake == Mistake.EVENTS_CELL_LOCAL) x + frame.region.columnStart else x
        if (mistake != Mistake.EVENTS_SHADES_ONCE) return shading.shade(column, y, primitive(i))

        // What was shaded for this sample is known
        val known = memo.getOrPut(depth(i)) {
            val one = shading.shade(column, y, primitive(i))
            Rgba(one.red, one.green, one.blue, one.alpha)
        }
        echo.moveTo(column, y)
        echo.setColor(known.red, known.green, known.blue, known.alpha)
        return echo
    }

    override fun show(i: Int) {
        if (mistake == Mistake.EVENTS_FIRST_SHOW && shown >= 0) return
        argb = shade(i).toArgb()
        shown = i
    }

    override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
        if (mistake == Mistake.EVENTS_FIRST_SHOW && shown >= 0) return
        key(i)
        argb = Rgba(red, green, blue, alpha).toArgb()
        shown = if (mistake == Mistake.EVENTS_SHOWS_FRONT) 0 else i
    }

    private fun key(i: Int): Long {
        require(i in 0 until size) { "fragment must be in 0..${size - 1}: $i" }
        return keys[i]
    }
}

/** Blends translucent fragments over the first opaque one, or over the background. */
internal class BlendAll(private val mistake: Mistake?) : Selector {
    override fun select(cell: Cell) {
        if (!cell.isTranslucent(0)) return cell.show(0)
        val over = Over(mistake)
        over.begin()
        var i = 0
        while (i < cell.size && cell.isTranslucent(i) && over.isOpen) over.add(cell.shade(i++))
        if (over.isOpen && i < cell.size) over.end(cell.shade(i)) else over.end(cell.background)
        val color = over.color
        cell.show(0, color.red, color.green, color.blue, color.alpha)
    }
}

/** The starts and ends of a row's spans, by column. */
internal class RowEvents(private val mistake: Mistake?) {
    private var events = LongArray(32)
    private var owners = IntArray(16)
    private var places = IntArray(16)
    private var active = IntArray(16)
    private var spans = 0

    val bytes: Long get() = 8L * events.size + 12L * owners.size

    fun clear() {
        spans = 0
    }

    fun add(start: Int, end: Int, index: Int) {
        if (spans == owners.size) {
            owners = owners.copyOf(2 * spans)
            places = places.copyOf(2 * spans)
            active = active.copyOf(2 * spans)
            events = events.copyOf(4 * spans)
        }
        owners[spans] = index
        events[2 * spans] = event(end, 0)
        events[2 * spans + 1] = event(start, 1)
        spans++
    }

    private fun event(column: Int, kind: Int): Long = column.toLong() shl 32 or (kind.toLong() shl SLOT_BITS) or
        if (mistake == Mistake.EVENTS_NARROW_SLOT) (spans and 0xFFF).toLong() else spans.toLong()

    fun sort() = events.sort(0, 2 * spans)

    /** Walks from event to event; calls [each] for columns where something is. */
    fun sweep(each: (start: Int, end: Int, active: IntArray, count: Int) -> Unit) {
        var count = 0
        var column = 0
        val slots = IntArray(active.size)
        for (i in 0 until 2 * spans) {
            val at = (events[i] ushr 32).toInt()
            if (at > column && count > 0) each(column, at, active, count)
            column = at
            val slot = events[i].toInt() and SLOT_MASK
            if (events[i] ushr SLOT_BITS and 1L == 1L) {
                places[slot] = count
                slots[count] = slot
                active[count++] = owners[slot]
            } else if (count > 0) {
                val last = slots[--count]
                active[places[slot]] = active[count]
                slots[places[slot]] = last
                places[last] = places[slot]
            }
        }
    }

    private companion object {
        const val SLOT_BITS = 30
        const val SLOT_MASK = (1 shl SLOT_BITS) - 1
    }
}
