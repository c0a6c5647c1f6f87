package dev.lazyz.scenes.ply

import dev.lazyz.Scene
import dev.lazyz.scenes.SceneParser
import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.VertexArrays

/**
 * Reads the Polygon File Format (Greg Turk, "The PLY Polygon File Format", Stanford University, 1994) in its ASCII and
 * both binary forms.
 *
 * The file becomes one mesh, or one for each texture. Of vertices it takes x, y, z; nx, ny, nz; s, t or u, v (upward, so
 * that v is turned to `1 - v`); red, green, blue, alpha, which are sRGB-encoded, whole numbers in the range of their type or
 * fractions in 0..1. Of faces, which may have any number of corners, it takes colours, where vertices have none, and
 * `texcoord`, two numbers a corner, with `texnumber`; `tristrips` are read too. Textures are those that comments
 * `TextureFile` name, with `<this>` for the file's own name. Alpha goes into the vertex colours as it is, and the material
 * stays opaque. Other elements and properties are passed over, with a warning. Without normals in the file they are made
 * smooth up to creases of [CREASE_ANGLE] degrees. Of a file that is cut short, what is there is shown.
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
        var vertices: VertexArrays? = null
        val faces = PlyFaces(source, header.elements.first { it.name == "vertex" }.count)
        val unused = PlyUnused()
        for (element in header.elements) {
            val columns = when (element.name) {
                "vertex" -> PlyVertices(source, element).let { reader ->
                    vertices = reader.read(body)
                    reader.columns
                }
                "face" -> faces.readFaces(element, body)
                "tristrips" -> faces.readStrips(element, body)
                else -> skip(element, body)
            }
            unused.add(element, columns)
        }
        body.warn()
        unused.warn(source)

        val found = checkNotNull(vertices) { "the header reader lets no file without vertices pass" }
        val meshes = PlyMeshes(source, found, faces.polygons, header.textureFiles).build()
        if (meshes.isEmpty()) source.warn("there are no faces, so there is nothing to see; points alone are not drawn")
        return Scene(meshes)
    }

    private fun skip(element: PlyElement, body: PlyBody): Set<Int> {
        if (element.properties.isNotEmpty()) body.readRows(element) { _, _ -> }
        return emptySet()
    }
}
