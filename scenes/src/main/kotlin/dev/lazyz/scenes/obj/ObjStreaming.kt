package dev.lazyz.scenes.obj

import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.scenes.streaming.IndexedSpool
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.world.surface.MeshSource
import org.joml.Vector3dc

/**
 * Reads Wavefront OBJ files of any size part by part. The triangles and the colours of vertices are those of [ObjParser]
 * without smooth normals, in the order of the file; normals, texture coordinates, materials, points and lines are not
 * used. Vertices and triangles are converted once to an [IndexedSpool]. If a face refers to a later vertex, the file is
 * read twice.
 */
internal object ObjStreaming {
    /** Opens [input], whose first bytes [source] has. */
    fun open(source: Source, input: StreamedInput): MeshSource {
        source.requireNoMark()
        val conversion = FarOrigin.reading(
            source.loading,
            read = { origin -> Conversion(source, input, origin) },
            bounds = { it.spool.bounds },
        )
        if (conversion.spool.vertexCount == 0) {
            source.fail(null, "there is no vertex in the file", "check what kind of file it is")
        }
        conversion.warn()
        return conversion.spool.finish()
    }

    /** Reads the file once, or twice. */
    private class Conversion(private val source: Source, private val input: StreamedInput, origin: Vector3dc) {
        val spool: IndexedSpool = input.indexed(source, origin)
        private val model = ObjModel(source, origin)
        private val reader: ObjReader

        /** Number of faces whose triangles are in the spool. */
        private var done = 0L

        /** Number of faces that were read. */
        private var faces = 0L

        /** Whether a face refers to a later vertex. */
        private var isLate = false
        private var hasPixels = false
        private val tooConcave = ArrayList<String>()

        init {
            reader = read(source, model) {
                takeVertices()
                takeFaces(model, mayBeLate = true)
                hasPixels = hasPixels || !model.points.isEmpty
                model.clear()
            }
            if (isLate) readAgain(origin)
        }

        private fun read(source: Source, model: ObjModel, take: () -> Unit): ObjReader = input.bytes().use { bytes ->
            val statements = Statements(ByteWindow(ByteArray(0), rest = bytes))
            ObjReader(source, model, statements).also { it.read(take) }
        }

        /** Reads the faces from the first one on that refers to a later vertex. */
        private fun readAgain(origin: Vector3dc) {
            faces = 0
            val warned = Source(source.bytes, source.name, null, source.loading)
            val again = ObjModel(warned, origin)
            read(warned, again) {
                takeFaces(again, mayBeLate = false)
                again.clear()
            }
        }

        private fun takeVertices() {
            val colors = if (model.colors.size == 0 && !spool.hasVertexColors) null else model.colors()
            val vertices = VertexArrays(model.positions.copy(), colors = colors, origin = model.origin)
            spool.vertices(vertices, vertices.count)
        }

        private fun takeFaces(from: ObjModel, mayBeLate: Boolean) {
            val table = from.faces
            for (face in 0 until table.size) {
                if (faces++ < done || isLate && mayBeLate) continue
                val start = table.start(face)
                val end = table.end(face)
                val missing = (start until end).firstOrNull { table.positions[it] >= spool.vertexCount }
                if (missing != null && !mayBeLate) from.failAt(face, table.positions[missing], spool.vertexCount)
                if (missing != null) {
                    isLate = true
                } else {
                    val numbers = ObjTriangles.of(table, face, spool::coordinate)
                    if (numbers == null) tooConcave += ObjTriangles.tooConcave(table, face)
                    if (numbers != null) add(table, numbers)
                    done++
                }
            }
        }

        private fun add(table: FaceTable, corners: IntArray) {
            for (i in corners.indices step 3) {
                spool.triangle(
                    table.positions[corners[i]], table.positions[corners[i + 1]], table.positions[corners[i + 2]],
                )
            }
        }

        /** Reports what is not used. */
        fun warn() {
            reader.warn()
            val unused = listOfNotNull(
                "normals".takeIf { model.normalCount > 0 },
                "texture coordinates".takeIf { model.textureCount > 0 },
                "materials".takeIf { model.faces.parts.any { it.material != null } },
                "points and lines".takeIf { hasPixels },
            )
            if (faces == 0L && hasPixels) {
                source.fail(null, "has no faces, and points and lines cannot be read part by part", "read it whole")
            }
            if (faces == 0L) source.warn("there are no faces, so there is nothing to see")
            if (unused.isNotEmpty()) source.warn("is read part by part, without its ${unused.joinToString()}")
            tooConcave.forEach(source::warn)
        }
    }
}
