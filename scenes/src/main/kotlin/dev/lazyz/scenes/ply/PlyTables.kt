package dev.lazyz.scenes.ply

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.PixelDefaults
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.surface.Lines
import org.joml.Vector3dc

/**
 * Reads the parts of the body that are shown. Not thread safe.
 *
 * @param origin the point to subtract from all positions
 */
internal class PlyTables(private val source: Source, private val header: PlyHeader, private val origin: Vector3dc) {
    private val vertexCount = header.elements.first { it.name == "vertex" }.count
    private val body = PlyBody.of(source, header)
    private val unused = PlyUnused()

    lateinit var vertices: VertexArrays
        private set
    val faces: PlyFaces = PlyFaces(source, vertexCount)
    val edges: PlyEdges = PlyEdges(source, vertexCount)

    /** Reads the tables in the order of the file. */
    fun read() {
        for (element in header.elements) {
            source.step()
            val columns = when (element.name) {
                "vertex" -> PlyVertices(source, element, origin).let { reader ->
                    vertices = reader.read(body)
                    reader.columns
                }
                "face" -> faces.readFaces(element, body)
                "tristrips" -> faces.readStrips(element, body)
                "edge" -> edges.read(element, body)
                else -> skip(element)
            }
            unused.add(element, columns)
        }
    }

    /** Reports the parts that were ignored. */
    fun warn() {
        body.warn()
        faces.warn()
        unused.warn(source)
    }

    private fun skip(element: PlyElement): Set<Int> {
        if (element.properties.isNotEmpty()) body.readRows(element) { _, _ -> }
        return emptySet()
    }
}

/** Collects the elements and properties of a file that are not shown, for one warning about all of them. */
internal class PlyUnused {
    private val unused = ArrayList<String>()
    private var others = 0

    /** Adds the columns of [element] whose numbers are not in [used]. */
    fun add(element: PlyElement, used: Set<Int>) {
        if (element.count == 0 || element.properties.isEmpty()) return
        val names = element.properties.filterIndexed { column, _ -> column !in used }.map { it.name }
        if (names.isEmpty()) return
        if (unused.size == MOST_NAMES) {
            others++
            return
        }
        val more = names.size - MOST_NAMES
        val listed = names.take(MOST_NAMES).joinToString() + (if (more > 0) " and $more more" else "")
        unused.add("$listed of ${element.count} ${element.name}")
    }

    fun warn(source: Source) {
        if (unused.isEmpty()) return
        val more = if (others > 0) "; and those of $others more elements" else ""
        source.warn("properties that are not used: ${unused.joinToString("; ")}$more")
    }

    private companion object {
        const val MOST_NAMES = 12
    }
}

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
