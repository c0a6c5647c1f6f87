package dev.lazyz.tiled

import dev.lazyz.FragmentBatch

/** Fragments of a tile that wait for their colour, and the runs on its rows that they are. Belongs to one thread. */
internal class FragmentRuns {
    /** The fragments, one run after the other. */
    val fragments: FragmentBatch = FragmentBatch(FragmentBatch.CAPACITY + FragmentBatch.SPARE)

    /** Runs: row of the tile, column of the band, length. */
    private val rows = IntArray(FragmentBatch.CAPACITY)
    private val columns = IntArray(FragmentBatch.CAPACITY)
    private val lengths = IntArray(FragmentBatch.CAPACITY)
    private var count = 0

    /** Number of fragments for which there is room. */
    val room: Int get() = FragmentBatch.CAPACITY - fragments.size

    /** Bytes held. */
    val bytes: Long get() = fragments.bytes + 3L * Int.SIZE_BYTES * rows.size

    /** Adds a run of [length] fragments, for which there has to be [room], at [row] of the tile and [column] of the band. */
    fun add(row: Int, column: Int, length: Int) {
        rows[count] = row
        columns[count] = column
        lengths[count++] = length
        fragments.size += length
    }

    /** Puts the fragments' colours, packed in [argb], where they belong among the rows [to], and starts anew. */
    fun takeOut(argb: IntArray, to: Array<IntArray>) {
        var at = 0
        for (run in 0 until count) {
            val colors = to[rows[run]]
            val column = columns[run]
            val length = lengths[run]
            for (i in 0 until length) colors[column + i] = argb[at + i]
            at += length
        }
        fragments.size = 0
        count = 0
    }
}
