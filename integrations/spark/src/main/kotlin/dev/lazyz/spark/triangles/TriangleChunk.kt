package dev.lazyz.spark.triangles

import dev.lazyz.world.surface.Mesh
import java.io.Serializable
import org.apache.spark.sql.Row

/**
 * Some triangles in ascending order of their submission indices, so that ties within them have the usual winner.
 * Immutable.
 */
internal class TriangleChunk private constructor(private val indices: IntArray, private val corners: FloatArray) :
    Serializable {
    val size: Int get() = indices.size

    /** Returns the submission index of triangle [number]. */
    fun index(number: Int): Int = indices[number]

    /** Returns the triangles as a mesh. */
    fun mesh(): Mesh = Mesh(corners, IntArray(3 * size) { it })

    /** Returns the triangles with these numbers, which ascend. */
    fun select(numbers: IntArray): TriangleChunk {
        val some = FloatArray(9 * numbers.size)
        for ((to, from) in numbers.withIndex()) corners.copyInto(some, 9 * to, 9 * from, 9 * from + 9)
        return TriangleChunk(IntArray(numbers.size) { indices[numbers[it]] }, some)
    }

    companion object {
        private const val serialVersionUID = 1L

        /** Triangles that are drawn at a time. */
        const val MOST: Int = 1 shl 17

        /** Bytes of a triangle. */
        const val BYTES: Int = 40

        /** Returns [rows], which have an index and nine numbers, in chunks. */
        fun chunks(rows: Iterator<Row>): Sequence<TriangleChunk> = rows.asSequence().chunked(MOST, ::of)

        private fun of(rows: List<Row>): TriangleChunk {
            val indices = IntArray(rows.size)
            val corners = FloatArray(9 * rows.size)
            for ((number, row) in rows.sortedBy { it.getLong(0) }.withIndex()) {
                val index = row.getLong(0)
                require(index in 0..Int.MAX_VALUE - 2L) { "the index of a triangle must be in 0..2^31-3: $index" }
                indices[number] = index.toInt()
                for (i in 0 until 9) corners[9 * number + i] = row.getFloat(1 + i)
            }
            return TriangleChunk(indices, corners)
        }

        /** Returns the triangles of all [chunks], in chunks. */
        fun merged(chunks: Iterable<TriangleChunk>): Sequence<TriangleChunk> = sequence {
            var waiting = ArrayList<TriangleChunk>()
            for (chunk in chunks) {
                if (waiting.sumOf { it.size } + chunk.size > MOST && waiting.isNotEmpty()) {
                    yield(joined(waiting))
                    waiting = ArrayList()
                }
                waiting += chunk
            }
            if (waiting.isNotEmpty()) yield(joined(waiting))
        }

        private fun joined(chunks: List<TriangleChunk>): TriangleChunk {
            val order = chunks.flatMapIndexed { c, chunk -> chunk.indices.indices.map { c to it } }
                .sortedBy { (c, number) -> chunks[c].indices[number] }
            val corners = FloatArray(9 * order.size)
            for ((to, place) in order.withIndex()) {
                val (c, from) = place
                chunks[c].corners.copyInto(corners, 9 * to, 9 * from, 9 * from + 9)
            }
            return TriangleChunk(IntArray(order.size) { chunks[order[it].first].indices[order[it].second] }, corners)
        }
    }
}
