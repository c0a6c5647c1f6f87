package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.FragmentBatch
import dev.lazyz.bytes

/** Fragments of a tile that wait to be shaded, and their places in the tile. Belongs to one thread. */
internal class WaitingFragments {
    /** Attributes and colours of the fragments. Their number and their samples are set by [locate]. */
    val batch: FragmentBatch = FragmentBatch(FragmentBatch.ROOM)

    /** The place of each fragment in the tile, see [PrimitiveRuns.place]. */
    private val places = IntArray(FragmentBatch.CAPACITY)

    /** Columns and rows within the tile, as doubles for arithmetic. */
    val columns: DoubleArray = DoubleArray(FragmentBatch.ROOM)
    val rows: DoubleArray = DoubleArray(FragmentBatch.ROOM)

    /** Number of fragments. */
    var size: Int = 0
        private set

    /** Number of fragments that can be added. */
    val room: Int get() = FragmentBatch.CAPACITY - size

    /** Bytes held. */
    val bytes: Long get() = batch.bytes + places.bytes + columns.bytes + rows.bytes

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
        size += length
    }

    /** Completes the [batch], for a tile whose first sample is ([x], [y]). */
    fun locate(x: Int, y: Int) {
        batch.size = size
        for (i in 0 until size) {
            batch.x[i] = x + PrimitiveRuns.column(places[i])
            batch.y[i] = y + PrimitiveRuns.row(places[i])
        }
    }

    /**
     * Stores the fragments' packed colours [argb] into the rows [to], where the tile starts at [column], and removes
     * all fragments.
     */
    fun takeOut(argb: IntArray, to: Array<IntArray>, column: Int) {
        for (i in 0 until size) {
            val place = places[i]
            to[PrimitiveRuns.row(place)][column + PrimitiveRuns.column(place)] = argb[i]
        }
        size = 0
    }

    private companion object {
        /** Fewest samples for which filling by whole arrays is worthwhile. */
        const val LONG = 12

        /** The columns of the widest tile. */
        val COLUMNS = DoubleArray(512) { it.toDouble() }
    }
}
