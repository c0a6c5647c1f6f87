package dev.lazyz.scenes.ply

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.PolygonCutting
import dev.lazyz.scenes.meshes.Polygons
import dev.lazyz.scenes.streaming.FacetFile
import dev.lazyz.scenes.streaming.FacetSpool
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.scenes.streaming.VertexSpool
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import org.joml.Vector3dc

/**
 * Reads PLY files of any size part by part. The triangles and their colours are those of [PlyParser] without normals
 * and textures. What else a file has is ignored with a warning, edges and points too.
 *
 * Vertices go to temporary files, because faces refer to them in any order, and the triangles to another one. Faces
 * that come before the vertices are read in a second pass.
 */
internal class PlyStreaming private constructor(private val source: Source, private val input: StreamedInput) :
    AutoCloseable {
    private val header = input.bytes().use { PlyHeaderReader(source, TextLines(ByteWindow(source, it))).read() }
    private val vertexElement = header.elements.indexOfFirst { it.name == VERTEX }

    /** By element: the numbers of the columns that were used. */
    private val used = HashMap<PlyElement, Set<Int>>()
    private var pass: Pass? = null

    private fun mesh(): FacetFile {
        val vertices = FarOrigin.reading(source.loading, read = ::readVertices, bounds = { it.bounds })
        vertices.finish()
        val isColored = header.elements.any { it.name == FACE && it.count > 0 && PlyColor.of(it) != null }
        val facets = input.spool(source, vertices.origin, hasColors = vertices.hasColors || isColored)
        val writer = PlyFacets(source, vertices, facets, hasFaceColors = isColored && !vertices.hasColors)
        val faces = PlyFaces(source, header.elements[vertexElement].count, writer::add)
        readFaces(faces)
        faces.end()
        input.dropVertices()
        warn(faces, writer)
        val mesh = facets.finish()
        if (vertices.size == 0) {
            source.warn("there are no vertices, so there is nothing to see")
        } else if (mesh.triangleCount == 0) {
            source.warn("there are no faces, so there is nothing to see")
        }
        return mesh
    }

    private fun readVertices(origin: Vector3dc): VertexSpool {
        val vertices = input.vertices(source, origin)
        val pass = begin()
        for (element in header.elements.subList(0, vertexElement)) pass.skip(element)
        val element = header.elements[vertexElement]
        val reader = PlyVertices(source, element, origin, isBare = true)
        reader.read(pass.body, vertices::add)
        used[element] = reader.columns
        return vertices
    }

    private fun readFaces(faces: PlyFaces) {
        val isBefore = header.elements.subList(0, vertexElement).any { it.name == FACE || it.name == STRIPS }
        val pass = if (isBefore) begin() else checkNotNull(pass)
        for (element in header.elements.drop(if (isBefore) 0 else vertexElement + 1)) {
            source.step()
            when (element.name) {
                FACE -> used[element] = faces.readFaces(element, pass.body)
                STRIPS -> used[element] = faces.readStrips(element, pass.body)
                else -> pass.skip(element)
            }
        }
    }

    private fun warn(faces: PlyFaces, writer: PlyFacets) {
        checkNotNull(pass).body.warn()
        faces.warn()
        writer.warn()
        val unused = PlyUnused()
        for (element in header.elements) {
            source.step()
            unused.add(element, used[element].orEmpty())
        }
        unused.warn(source)
    }

    /** Begins to read the body from its beginning. */
    private fun begin(): Pass {
        close()
        return Pass().also { pass = it }
    }

    override fun close() {
        pass?.close()
        pass = null
    }

    /** Reads the body once. */
    private inner class Pass : AutoCloseable {
        private val bytes = input.bytes(header.bodyPosition)
        val body = PlyBody.of(source, header, ByteWindow(source, bytes, header.bodyPosition), input.file.size)

        fun skip(element: PlyElement) {
            source.step()
            if (element.properties.isNotEmpty()) body.readRows(element) { _, _ -> }
        }

        override fun close() = bytes.close()
    }

    companion object {
        private const val VERTEX = "vertex"
        private const val FACE = "face"
        private const val STRIPS = "tristrips"

        /** Opens [input], whose first bytes [source] has. */
        fun open(source: Source, input: StreamedInput): MeshSource {
            source.requireNoMark()
            return PlyStreaming(source, input).use { it.mesh() }
        }
    }
}

/**
 * Triangulates polygons and adds the triangles to [facets]. Not thread safe.
 *
 * @param hasFaceColors whether triangles get the colours of their polygons
 */
internal class PlyFacets(
    source: Source,
    private val vertices: VertexSpool,
    private val facets: FacetSpool,
    private val hasFaceColors: Boolean,
) {
    private val cutting = PolygonCutting(source, vertices.size, vertices)
    private val corners = Ints()
    private val color = FloatArray(4)

    fun add(polygons: Polygons) {
        for (polygon in 0 until polygons.count) {
            corners.clear()
            cutting.cut(polygons, polygon, corners)
            for (i in 0 until corners.size step 3) {
                vertices.addTo(
                    facets,
                    polygons.vertex(corners[i]),
                    polygons.vertex(corners[i + 1]),
                    polygons.vertex(corners[i + 2]),
                )
                if (hasFaceColors) addColor(polygons, polygons.colorOf(polygon))
            }
        }
    }

    private fun addColor(polygons: Polygons, number: Int) {
        if (number < 0) color.fill(1f) else polygons.colors.copy(number, color, 0)
        repeat(3) { facets.color(color[0], color[1], color[2], color[3]) }
    }

    /** Reports the polygons that were left out. */
    fun warn() = cutting.warn()
}
