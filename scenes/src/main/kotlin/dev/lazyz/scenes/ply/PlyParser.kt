package dev.lazyz.scenes.ply

import dev.lazyz.Material
import dev.lazyz.Mesh
import dev.lazyz.Scene
import dev.lazyz.scenes.SceneParser
import dev.lazyz.scenes.Source
import dev.lazyz.scenes.images.TextureFiles

/**
 * Reads the Polygon File Format (Greg Turk, "The PLY Polygon File Format", Stanford University, 1994) in its ASCII and
 * both binary forms.
 *
 * The file becomes one mesh. Of vertices it takes x, y, z; nx, ny, nz; s, t or u, v (upward, so that v is turned to
 * `1 - v`) with the texture that a comment `TextureFile` names; red, green, blue, alpha, which are sRGB-encoded, whole
 * numbers in the range of their type or fractions in 0..1. Alpha goes into the vertex colours as it is, and the
 * material stays opaque. Faces may have any number of corners; `tristrips` are read too. Other elements and properties
 * are passed over. Without normals in the file they are made smooth up to creases of [CREASE_ANGLE] degrees.
 */
internal object PlyParser : SceneParser {
    /** Edges sharper than this stay sharp, degrees. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        if (source.bytes.isEmpty()) source.fail(null, "the file is empty", "export the model again")
        source.decodeText()
        val header = PlyHeaderReader(source).read()
        val body = PlyBody.of(source, header)

        // Read the tables in the order in which they stand
        var vertices: PlyVertices? = null
        val faces = PlyFaces(source, header.elements.first { it.name == "vertex" }.count)
        for (element in header.elements) {
            when (element.name) {
                "vertex" -> vertices = PlyVertices.read(source, element, body)
                "face" -> faces.readFaces(element, body)
                "tristrips" -> faces.readStrips(element, body)
                else -> skip(element, body)
            }
        }
        val found = checkNotNull(vertices) { "the header reader lets no file without vertices pass" }
        val triangles = faces.triangles(found.positions)
        source.loading.triangles(source, triangles.size / 3L)
        if (triangles.isEmpty()) {
            source.warn("there are no faces, so there is nothing to see; points alone are not drawn")
            return Scene(emptyList())
        }
        val textureFile = header.textureFile?.takeIf { found.uvs != null }
        val material = Material(texture = textureFile?.let { TextureFiles.find(source, it) })
        val mesh = Mesh(found.positions, triangles, material, found.normals, found.uvs, found.colors)
        return Scene(listOf(if (mesh.normals == null) mesh.withSmoothNormals(CREASE_ANGLE) else mesh))
    }

    private fun skip(element: PlyElement, body: PlyBody) {
        if (element.properties.isEmpty()) return
        body.announce(element)
        val row = PlyRow(element)
        repeat(element.count) { body.read(row) }
    }
}
