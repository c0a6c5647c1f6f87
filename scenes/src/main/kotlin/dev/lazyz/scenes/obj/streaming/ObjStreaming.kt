package dev.lazyz.scenes.obj.streaming

import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.streaming.FacetFile
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.Statements
import dev.lazyz.world.surface.MeshSource

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
