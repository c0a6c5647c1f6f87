package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.PolygonCutting
import dev.lazyz.scenes.meshes.Polygons
import dev.lazyz.scenes.streaming.IndexedSpool
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.world.surface.MeshSource
import org.joml.Vector3dc

/**
 * Reads Polygon File Format files of any size part by part. The triangles and their colours are those of [PlyParser]
 * without smooth normals; normals, texture coordinates and edges are not used. Vertices and triangles are converted once
 * to an [IndexedSpool]. If faces stand before the vertices, the file is read twice.
 */
internal object PlyStreaming {
    /** Opens [input], whose first bytes [source] has. */
    fun open(source: Source, input: StreamedInput): MeshSource {
        source.requireNoMark()
        if (source.bytes.size < input.file.size && !hasEnd(source.bytes)) {
            source.fail("header", "is longer than ${source.bytes.size} bytes", "remove comments from it")
        }
        val header = PlyHeaderReader(source).read()
        val spool = FarOrigin.reading(
            source.loading,
            read = { origin -> Conversion(source, header, input, origin).spool },
            bounds = { it.bounds },
        )
        val mesh = spool.finish()
        if (spool.vertexCount == 0) {
            source.warn("there are no vertices, so there is nothing to see")
        } else if (mesh.triangleCount == 0) {
            source.fail(null, "has no faces, and points and lines cannot be read part by part", "read it whole")
        }
        return mesh
    }

    private fun hasEnd(head: ByteArray): Boolean = "end_header" in String(head, Charsets.ISO_8859_1)

    /** Reads the file once, or twice. */
    private class Conversion(
        private val source: Source,
        private val header: PlyHeader,
        private val input: StreamedInput,
        origin: Vector3dc,
    ) {
        val spool: IndexedSpool = input.indexed(source, origin)
        private val declared = header.elements.first { it.name == "vertex" }.count
        private lateinit var cutting: PolygonCutting
        private val rgba = FloatArray(4)

        init {
            val names = header.elements.filter { it.count > 0 }.map { it.name }
            val vertices = names.indexOf("vertex")
            if (names.withIndex().any { (number, name) -> isFaces(name) && number < vertices }) {
                read { it == "vertex" }
                read { isFaces(it) }
            } else {
                read { true }
            }
        }

        private fun isFaces(name: String) = name == "face" || name == "tristrips"

        /** Reads the file, and of it the elements whose names are [wanted]. */
        private fun read(wanted: (name: String) -> Boolean) {
            val unused = PlyUnused()
            val faces = PlyFaces(source, declared, ::take)
            input.bytes().use { bytes ->
                val body = PlyBody.of(source, header, bytes, input.file.size)
                for (element in header.elements) {
                    unused.add(element, if (wanted(element.name)) read(element, body, faces) else skip(element, body))
                }
                if (wanted("face")) {
                    body.warn()
                    faces.warn()
                    unused.warn(source)
                    if (this::cutting.isInitialized) cutting.warn()
                }
            }
        }

        private fun vertices(element: PlyElement) = PlyVertices(source, element, spool.origin)

        private fun read(element: PlyElement, body: PlyBody, faces: PlyFaces): Set<Int> = when (element.name) {
            "vertex" -> vertices(element).let { reader ->
                reader.stream(body, spool)
                reader.streamedColumns
            }
            "face" -> faces.readFaces(element, body)
            "tristrips" -> faces.readStrips(element, body)
            else -> skip(element, body)
        }

        private fun skip(element: PlyElement, body: PlyBody): Set<Int> {
            if (element.properties.isNotEmpty()) body.readRows(element) { _, _ -> }
            return if (element.name == "vertex") vertices(element).streamedColumns else emptySet()
        }

        /** Adds the triangles of [polygons] to the spool. */
        private fun take(polygons: Polygons) {
            if (!this::cutting.isInitialized) cutting = PolygonCutting(source, spool.vertexCount, spool::coordinate)
            val corners = IntArray(3)
            for (polygon in 0 until polygons.count) {
                val color = if (spool.hasVertexColors) -1 else polygons.colorOf(polygon)
                var count = 0
                cutting.cut(polygons, polygon) { corner ->
                    corners[count++] = polygons.vertex(corner)
                    if (count == 3) {
                        spool.triangle(corners[0], corners[1], corners[2])
                        if (color >= 0) {
                            polygons.colors.copy(color, rgba, 0)
                            spool.color(rgba)
                        }
                        count = 0
                    }
                }
            }
        }
    }
}
