package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.bytes
import dev.lazyz.raster.EdgeForms
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.ShadingPoints
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * The runs of a tile's visible samples, grouped by primitive. A run consists of adjacent samples on a row that show the
 * same primitive.
 *
 * Primitives are looked up by the lower bits of their indices. A primitive that is evicted by another one starts a new
 * group, so the same primitive may have several groups. Belongs to one thread; reused for each tile.
 */
internal class PrimitiveRuns {
    /** By the lower bits of their indices: recently used primitives, and the result of [find] for each. */
    private val owners = IntArray(SLOTS)
    private val groups = IntArray(SLOTS)
    private val colors = IntArray(SLOTS)

    /** For each group, the primitive's index, the number of fragments, and the last run. */
    private var indices = IntArray(CAPACITY)
    private var sizes = IntArray(CAPACITY)
    private var lasts = IntArray(CAPACITY)

    /** Number of groups. */
    var count: Int = 0
        private set

    /**
     * For each run, the place of the first sample (see [place]), the length, and the group's previous run or [NONE].
     */
    private var starts = IntArray(CAPACITY)
    private var lengths = IntArray(CAPACITY)
    private var previous = IntArray(CAPACITY)
    private var runCount = 0

    /** Bytes held. */
    val bytes: Long get() = Int.SIZE_BYTES * (3L * SLOTS + 3L * indices.size + 3L * starts.size)

    /** Begins a tile. */
    fun begin() {
        count = 0
        runCount = 0
        owners.fill(NONE)
    }

    /**
     * Returns the number of a primitive's group, or [CONSTANT] or [ONE_BY_ONE] if it was recorded as such, or [NONE] if
     * unknown.
     */
    fun find(index: Int): Int {
        val slot = index and SLOTS - 1
        return if (owners[slot] == index) groups[slot] else NONE
    }

    /** Records an unknown primitive whose samples are to be collected, and returns the number of its new group. */
    fun note(index: Int): Int {
        if (count == indices.size) {
            indices = indices.copyOf(2 * count)
            sizes = sizes.copyOf(2 * count)
            lasts = lasts.copyOf(2 * count)
        }
        indices[count] = index
        sizes[count] = 0
        lasts[count] = NONE
        return record(index, count++)
    }

    /** Records an unknown primitive all of whose samples have the colour [argb]; returns [CONSTANT]. */
    fun noteConstant(index: Int, argb: Int): Int {
        colors[index and SLOTS - 1] = argb
        return record(index, CONSTANT)
    }

    /** Records an unknown primitive whose samples are shaded one by one; returns [ONE_BY_ONE]. */
    fun noteOneByOne(index: Int): Int = record(index, ONE_BY_ONE)

    private fun record(index: Int, group: Int): Int {
        owners[index and SLOTS - 1] = index
        groups[index and SLOTS - 1] = group
        return group
    }

    /** The colour of a primitive that was recorded as [CONSTANT]. */
    fun color(index: Int): Int = colors[index and SLOTS - 1]

    /** Adds a run with this number of [fragments] to group number [group]. */
    fun add(group: Int, start: Int, length: Int, fragments: Int) {
        if (runCount == starts.size) {
            starts = starts.copyOf(2 * runCount)
            lengths = lengths.copyOf(2 * runCount)
            previous = previous.copyOf(2 * runCount)
        }
        starts[runCount] = start
        lengths[runCount] = length
        previous[runCount] = lasts[group]
        sizes[group] += fragments
        lasts[group] = runCount++
    }

    /** The primitive's index of group number [group]. */
    fun index(group: Int): Int = indices[group]

    /** Number of fragments of group number [group]. */
    fun size(group: Int): Int = sizes[group]

    /** Calls [action] for each run of group number [group]. */
    inline fun forEach(group: Int, action: (start: Int, length: Int) -> Unit) {
        var run = lasts[group]
        while (run != NONE) {
            action(starts[run], lengths[run])
            run = previous[run]
        }
    }

    companion object {
        /** No primitive, or an unknown primitive. */
        const val NONE: Int = -1

        /** Instead of a group number: the primitive has one colour. */
        const val CONSTANT: Int = -2

        /** Instead of a group number: the primitive's samples are shaded one by one. */
        const val ONE_BY_ONE: Int = -3

        /** Bits of a column within a tile; a tile has at most 512 columns. */
        private const val COLUMN_BITS = 9

        /** Marks the start of a run of whole pixels, see [FragmentShading.addPixels]. */
        private const val PIXELS = 1 shl 2 * COLUMN_BITS

        /** The number of samples of a place, less 1, is above the mark of pixels. */
        private const val SAMPLES_SHIFT = 2 * COLUMN_BITS + 1

        /** Returns the place of a sample of a tile, which stands for so many [samples] of its pixel, at most 64. */
        fun place(row: Int, column: Int, samples: Int = 1): Int =
            samples - 1 shl SAMPLES_SHIFT or (row shl COLUMN_BITS) or column

        /** How many samples a place stands for. */
        fun samples(place: Int): Int = (place ushr SAMPLES_SHIFT) + 1

        /** Whether a place is the upper left one in its pixel of [side] x [side] samples, a power of two. */
        fun isCorner(place: Int, side: Int): Boolean =
            place and (side - 1 shl COLUMN_BITS or (side - 1)) == 0

        /** The row of a place. */
        fun row(place: Int): Int = place ushr COLUMN_BITS and (1 shl COLUMN_BITS) - 1

        /** Marks the [place] of the first sample of a run of whole pixels. */
        fun ofPixels(place: Int): Int = place or PIXELS

        /** Whether a run that starts at this [place] is one of whole pixels. */
        fun isOfPixels(place: Int): Boolean = place and PIXELS != 0

        /** The column of a place. */
        fun column(place: Int): Int = place and (1 shl COLUMN_BITS) - 1

        private const val CAPACITY = 512

        /** Number of primitives in the look-up table, a power of two. */
        private const val SLOTS = 512
    }
}

/** Fragments of a tile that wait to be shaded, and their places in the tile. Belongs to one thread. */
internal class WaitingFragments {
    /** Attributes and colours of the fragments. Their number and their samples are set by [locate]. */
    val batch: FragmentBatch = FragmentBatch(FragmentBatch.ROOM)

    /** The sample of each fragment, see [PrimitiveRuns.place]. */
    val places: IntArray = IntArray(FragmentBatch.CAPACITY)

    /** Whether any fragment is shaded elsewhere than at its sample, or stands for more samples than that. */
    var isMoved: Boolean = false
        private set

    /** If so, for how many samples of the row each fragment is. */
    val lengths: IntArray = IntArray(FragmentBatch.CAPACITY)

    /** Where they are shaded: columns and rows within the tile, multiples of a grid unit, as doubles for arithmetic. */
    val columns: DoubleArray = DoubleArray(FragmentBatch.ROOM)
    val rows: DoubleArray = DoubleArray(FragmentBatch.ROOM)

    /** Number of fragments. */
    var size: Int = 0
        private set

    /** Number of fragments that can be added. */
    val room: Int get() = FragmentBatch.CAPACITY - size

    /** Bytes held. */
    val bytes: Long get() = batch.bytes + places.bytes + lengths.bytes + columns.bytes + rows.bytes

    /** Adds [length] adjacent fragments from place [start] on. There must be [room] for them. */
    fun add(start: Int, length: Int) {
        val column = PrimitiveRuns.column(start)
        val row = PrimitiveRuns.row(start).toDouble()
        if (length < LONG) {
            for (i in 0 until length) {
                places[size + i] = start + i
                columns[size + i] = COLUMNS[column + i]
                rows[size + i] = row
            }
        } else {
            for (i in 0 until length) places[size + i] = start + i
            System.arraycopy(COLUMNS, column, columns, size, length)
            rows.fill(row, size, size + length)
        }
        if (isMoved) lengths.fill(1, size, size + length)
        size += length
    }

    private fun move() {
        if (isMoved) return
        isMoved = true
        lengths.fill(1, 0, size)
    }

    /**
     * Adds a fragment for [length] samples from place [start] on. It is shaded at a [point], see [ShadingPoints], of a
     * pixel whose first sample is at column [left] and row [top] of the tile.
     */
    fun add(start: Int, length: Int, left: Int, top: Int, point: Int) {
        move()
        places[size] = start
        lengths[size] = length
        columns[size] = left + ShadingPoints.right(point) * GRID
        rows[size++] = top + ShadingPoints.down(point) * GRID
    }

    /** Adds a fragment of a triangle with these [edges] at its point in the pixel, see [FragmentShading.addPart]. */
    fun addPart(start: Int, length: Int, tile: VisibilityBuffer, points: ShadingPoints, edges: EdgeForms) {
        val left = points.first(tile.columnStart + PrimitiveRuns.column(start))
        val top = points.first(tile.rowStart + PrimitiveRuns.row(start))
        add(start, length, left - tile.columnStart, top - tile.rowStart, points.find(edges, left, top))
    }

    /** Adds the centres of [count] pixels of [side] samples, from the one whose first sample is at [start]. */
    fun addPixels(start: Int, count: Int, side: Int) {
        move()
        val column = PrimitiveRuns.column(start) + 0.5 * (side - 1)
        for (i in 0 until count) places[size + i] = start + side * i
        for (i in 0 until count) columns[size + i] = column + side * i
        lengths.fill(1, size, size + count)
        rows.fill(PrimitiveRuns.row(start) + 0.5 * (side - 1), size, size + count)
        size += count
    }

    /** How far fragment [i] is right of column 0 of the raster, in grid units, if the tile starts at column [x]. */
    fun gridX(i: Int, x: Int): Int =
        ScreenGrid.STEPS * x +
            if (isMoved) (ScreenGrid.STEPS * columns[i]).toInt() else ScreenGrid.STEPS * PrimitiveRuns.column(places[i])

    /** How far fragment [i] is below row 0 of the raster, in grid units, if the tile starts at row [y]. */
    fun gridY(i: Int, y: Int): Int =
        ScreenGrid.STEPS * y +
            if (isMoved) (ScreenGrid.STEPS * rows[i]).toInt() else ScreenGrid.STEPS * PrimitiveRuns.row(places[i])

    /** Completes the [batch], for a tile whose first sample is ([x], [y]). */
    fun locate(x: Int, y: Int) {
        batch.size = size
        for (i in 0 until size) {
            batch.x[i] = gridX(i, x) shr ScreenGrid.SHIFT
            batch.y[i] = gridY(i, y) shr ScreenGrid.SHIFT
        }
    }

    /** Passes the fragments' packed colours [argb] to [sink], and removes all fragments. */
    fun takeOut(argb: IntArray, sink: FragmentSink) {
        sink.store(this, argb)
        size = 0
        isMoved = false
    }

    private companion object {
        /** A grid unit. */
        const val GRID = 1.0 / ScreenGrid.STEPS

        /** Fewest samples for which filling by whole arrays is worthwhile. */
        const val LONG = 12

        /** The columns of the widest tile. */
        val COLUMNS = DoubleArray(512) { it.toDouble() }
    }
}
