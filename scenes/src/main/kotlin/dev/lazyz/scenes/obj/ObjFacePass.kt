package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.streaming.FacetSpool
import dev.lazyz.scenes.streaming.VertexSpool

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
