package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
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
