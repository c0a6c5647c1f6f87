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

    /** Returns the triangles with these numbers, in this order, whose indices must ascend. */
    fun select(numbers: IntArray): TriangleChunk {
        val some = FloatArray(9 * numbers.size)
        for ((to, from) in numbers.withIndex()) corners.copyInto(some, 9 * to, 9 * from, 9 * from + 9)
        return TriangleChunk(IntArray(numbers.size) { indices[numbers[it]] }, some)
    }

    companion object {
        /** Triangles that are drawn at a time. */
        const val MOST: Int = 1 shl 17

        /** Bytes of a triangle. */
        const val BYTES: Int = 40

        private const val LEAST = 64

        /** Returns [rows], which have an index and nine numbers, in chunks. */
        fun chunks(rows: Iterator<Row>): Sequence<TriangleChunk> = sequence { while (rows.hasNext()) yield(next(rows)) }

        private fun next(rows: Iterator<Row>): TriangleChunk {
            var indices = IntArray(LEAST)
            var corners = FloatArray(9 * LEAST)
            var size = 0
            while (size < MOST && rows.hasNext()) {
                if (size == indices.size) {
                    indices = indices.copyOf(2 * size)
                    corners = corners.copyOf(9 * indices.size)
                }
                val row = rows.next()
                val index = row.getLong(0)
                require(index in 0..Int.MAX_VALUE - 2L) { "the index of a triangle must be in 0..2^31-3: $index" }
                indices[size] = index.toInt()
                for (i in 0 until 9) corners[9 * size + i] = row.getFloat(1 + i)
                size++
            }
            return inOrder(TriangleChunk(indices.copyOf(size), corners.copyOf(9 * size)))
        }

        /** Returns the triangles of all [chunks], in chunks. */
        fun merged(chunks: Iterator<TriangleChunk>): Sequence<TriangleChunk> = sequence {
            val waiting = ArrayList<TriangleChunk>()
            for (chunk in chunks) {
                if (waiting.sumOf { it.size } + chunk.size > MOST && waiting.isNotEmpty()) {
                    yield(joined(waiting))
                    waiting.clear()
                }
                waiting += chunk
            }
            if (waiting.isNotEmpty()) yield(joined(waiting))
        }

        private fun joined(chunks: List<TriangleChunk>): TriangleChunk {
            val indices = IntArray(chunks.sumOf { it.size })
            val corners = FloatArray(9 * indices.size)
            var size = 0
            for (chunk in chunks) {
                chunk.indices.copyInto(indices, size)
                chunk.corners.copyInto(corners, 9 * size)
                size += chunk.size
            }
            return inOrder(TriangleChunk(indices, corners))
        }

        /** Returns [chunk], whose indices are in any order, with indices that ascend. */
        private fun inOrder(chunk: TriangleChunk): TriangleChunk {
            val indices = chunk.indices
            if ((1 until indices.size).all { indices[it - 1] <= indices[it] }) return chunk
            val places = LongArray(indices.size) { indices[it].toLong() shl Int.SIZE_BITS or it.toLong() }
            places.sort()
            return chunk.select(IntArray(places.size) { places[it].toInt() })
        }
    }
}
