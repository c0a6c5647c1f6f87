package dev.lazyz.scenes.ply

import dev.lazyz.Lines
import dev.lazyz.scenes.PixelDefaults
import dev.lazyz.scenes.Source

/**
 * The edges of a file, each between two vertices. They are kept until the vertices are known, which may stand behind
 * them. Not thread safe.
 *
 * @param vertexCount how many vertices there are or will be
 */
internal class PlyEdges(private val source: Source, private val vertexCount: Int) {
    private var segments = IntArray(0)

    val isEmpty: Boolean get() = segments.isEmpty()

    /** Reads all rows of element `edge`. */
    fun read(element: PlyElement, body: PlyBody) {
        val columns = columns(element)
        body.announce(element)
        source.loading.segments(source, element.count.toLong())
        segments = IntArray(2 * element.count)
        val row = PlyRow(element)
        for (i in 0 until element.count) {
            body.read(row)
            for (end in 0..1) segments[2 * i + end] = vertex(row.numbers[columns[end]], body)
        }
    }

    /** Returns the edges as lines. */
    fun lines(vertices: PlyVertices): Lines {
        val material = PixelDefaults.material(isLit = false, hasColors = vertices.colors != null)
        return Lines(vertices.positions, segments, PixelDefaults.LINE_WIDTH, material, vertices.colors)
    }

    private fun vertex(number: Double, body: PlyBody): Int {
        if (number >= 0.0 && number < vertexCount && number == number.toInt().toDouble()) return number.toInt()
        val shown = if (number == StrictMath.rint(number)) number.toLong().toString() else number.toString()
        source.fail(
            body.location,
            "vertex number $shown is not one of the $vertexCount vertices, which count from 0",
            "correct the edge or export the model again",
        )
    }

    companion object {
        /** Whether [element] says which vertices its edges have. */
        fun canRead(element: PlyElement): Boolean = columns(element).size == 2

        private fun columns(element: PlyElement): List<Int> =
            listOf("vertex1", "vertex2").mapNotNull { element.column(listOf(it)) }
    }
}
