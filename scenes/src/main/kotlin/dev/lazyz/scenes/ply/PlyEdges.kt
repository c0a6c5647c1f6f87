package dev.lazyz.scenes.ply

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.PixelDefaults
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.surface.Lines

/**
 * The edges of a file, each between two vertices. They are stored until the vertices are known, because the vertices
 * may follow them in the file. Not thread safe.
 *
 * @param vertexCount number of vertices that the header declares
 */
internal class PlyEdges(private val source: Source, private val vertexCount: Int) {
    private val segments = Ints()

    val isEmpty: Boolean get() = segments.size == 0

    /**
     * Reads all rows of element `edge`. Returns the numbers of the columns that were used; none if the element has no
     * columns for vertices.
     */
    fun read(element: PlyElement, body: PlyBody): Set<Int> {
        val columns = listOf("vertex1", "vertex2").mapNotNull { element.column(listOf(it)) }
        if (columns.size < 2) {
            if (element.properties.isNotEmpty()) body.readRows(element) { _, _ -> }
            return emptySet()
        }
        source.loading.segments(source, body.room(element).toLong())
        body.readRows(element) { _, row ->
            for (column in columns) segments.add(body.vertexNumber(row.numbers[column], vertexCount, "edge"))
        }
        return columns.toSet()
    }

    /** Returns the edges as lines. */
    fun lines(vertices: VertexArrays): Lines {
        val material = PixelDefaults.material(isLit = false, hasColors = vertices.colors != null)
        val ends = segments.toArray()
        return Lines(vertices.positions, ends, PixelDefaults.LINE_WIDTH, material, vertices.colors, vertices.origin)
    }
}
