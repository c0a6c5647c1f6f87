package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.streaming.FacetFile
import dev.lazyz.scenes.streaming.FacetSpool
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.scenes.streaming.VertexSpool
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.Statements
import dev.lazyz.world.surface.StreamedMesh.MeshSource

/**
 * Reads Wavefront OBJ files of any size part by part. The triangles and the colours of vertices are those of
 * [ObjParser], in the order of the file. Normals, texture coordinates, materials, points and lines are ignored with a
 * warning.
 *
 * The file is read twice: first the vertices, which go to temporary files, because faces refer to them in any order;
 * then the faces, whose triangles go to another temporary file.
 */
internal class ObjStreaming private constructor(private val source: Source, private val input: StreamedInput) {
    private fun mesh(): FacetFile {
        val first = FarOrigin.reading(
            source.loading,
            read = { origin -> ObjVertexPass(source, input.vertices(source, origin)).also { reading(it::read) } },
            bounds = { it.vertices.bounds },
        )
        first.warn()
        val vertices = first.vertices
        if (vertices.size == 0) source.fail(null, "there is no vertex in the file", "check what kind of file it is")
        vertices.finish()
        val facets = input.spool(source, vertices.origin, vertices.hasColors)
        val second = ObjFacePass(source, vertices, facets)
        reading(second::read)
        input.dropVertices()
        if (!second.hasFaces) source.warn("there are no faces, so there is nothing to see")
        return facets.finish()
    }

    private fun reading(read: (Statements) -> Unit) =
        input.bytes().use { bytes -> read(Statements(ByteWindow(source, bytes))) }

    companion object {
        /** Opens [input], whose first bytes [source] has. */
        fun open(source: Source, input: StreamedInput): MeshSource {
            source.requireNoMark()
            return ObjStreaming(source, input).mesh()
        }
    }
}

/** Reads the faces of an OBJ file, whose [vertices] are known, and adds their triangles to [facets]. */
internal class ObjFacePass(
    private val source: Source,
    private val vertices: VertexSpool,
    private val facets: FacetSpool,
) : ObjCounts {
    override var vertexCount = 0
        private set
    override var textureCount = 0
        private set
    override var normalCount = 0
        private set

    /** Whether there are faces. */
    var hasFaces = false
        private set

    private val faces = FaceTable()
    private val cutting = FaceCutting(source, faces, vertices)
    private val corners = Ints()

    /** Reads all [statements]. */
    fun read(statements: Statements) {
        val reader = ObjFaceReader(source, statements, this, faces)
        while (statements.next()) {
            when {
                statements.hasKeyword("v") -> vertexCount++
                statements.hasKeyword("f") || statements.hasKeyword("fo") -> {
                    reader.read()
                    if (faces.positions.size >= BLOCK) passOn()
                }
                statements.hasKeyword("vt") -> textureCount++
                statements.hasKeyword("vn") -> normalCount++
            }
        }
        passOn()
    }

    /** Triangulates the faces that were read since the last call. */
    private fun passOn() {
        faces.requirePositions(source, vertices.size)
        if (faces.size > 0) hasFaces = true
        for (face in 0 until faces.size) {
            corners.clear()
            cutting.cut(face, corners)
            for (i in 0 until corners.size step 3) {
                vertices.addTo(
                    facets,
                    faces.positions[corners[i]],
                    faces.positions[corners[i + 1]],
                    faces.positions[corners[i + 2]],
                )
            }
        }
        faces.clear()
    }

    private companion object {
        /** Corners of faces that are kept in memory before they are triangulated. */
        const val BLOCK = 1 shl 14
    }
}

/** Reads the vertices of an OBJ file into [vertices], and counts the statements that are ignored. */
internal class ObjVertexPass(private val source: Source, val vertices: VertexSpool) : ObjVertexSink {
    private val ignored = ObjIgnored()
    private val unused = KindCounts()

    /** Reads all [statements]. */
    fun read(statements: Statements) {
        val reader = ObjVertexReader(source, statements, vertices.origin, this)
        while (statements.next()) {
            if (statements.hasKeyword("v")) {
                reader.readVertex()
            } else if (!statements.hasKeyword("f") && !statements.hasKeyword("fo")) {
                readOther(statements)
            }
        }
    }

    private fun readOther(statements: Statements) {
        val keyword = UNUSED.firstOrNull(statements::hasKeyword)
        if (keyword != null) {
            unused.add(keyword)
        } else if (NEUTRAL.none(statements::hasKeyword)) {
            ignored.add(statements.keyword())
        }
    }

    /** Reports the statements that were ignored. */
    fun warn() {
        ignored.warn(source)
        if (unused.total > 0) source.warn("statements that are not used are passed over: $unused")
    }

    override fun vertex(x: Float, y: Float, z: Float) = vertices.add(x, y, z)

    override fun color(red: Float, green: Float, blue: Float) = vertices.color(red, green, blue, 1f)

    override fun texture(u: Float, v: Float) = Unit

    override fun normal(x: Float, y: Float, z: Float) = Unit

    private companion object {
        /** Statements that the picture of the whole model may use. */
        val UNUSED = listOf("vn", "vt", "usemtl", "mtllib", "p", "l")

        /** Statements that make no difference, because each triangle has its own normal. */
        val NEUTRAL = listOf("g", "o", "s")
    }
}
