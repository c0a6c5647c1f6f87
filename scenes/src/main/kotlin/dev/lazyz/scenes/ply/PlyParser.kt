package dev.lazyz.scenes.ply

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.PixelDefaults
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.Points
import dev.lazyz.world.Scene

/**
 * Reads the Polygon File Format (Greg Turk, "The PLY Polygon File Format", Stanford University, 1994) in its ASCII and
 * both binary forms.
 *
 * The file becomes one mesh, or one for each texture, or points, and lines. Of vertices it takes x, y, z; nx, ny, nz; s, t or
 * u, v (upward, so that v is turned to `1 - v`); red, green, blue, alpha, which are sRGB-encoded, whole numbers in the range
 * of their type or fractions in 0..1. Of faces, which may have any number of corners, it takes colours, where vertices have
 * none, and `texcoord`, two numbers a corner, with `texnumber`; `tristrips` are read too. An element `edge` gives lines
 * between `vertex1` and `vertex2`; a file without faces and edges is a cloud of points. Textures are those that comments
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
        val tables = FarOrigin.reading(
            read = { origin -> PlyTables(source, header, origin).also { it.read() } },
            bounds = { Box.around(it.vertices.positions) },
        )
        tables.warn()
        source.release()
        return scene(source, header, tables)
    }

    private fun scene(source: Source, header: PlyHeader, tables: PlyTables): Scene {
        val vertices = tables.vertices
        val meshes = PlyMeshes(source, vertices, tables.faces.polygons, header.textureFiles).build()
        val lines = if (tables.edges.isEmpty) emptyList() else listOf(tables.edges.lines(vertices))
        if (vertices.count == 0) source.warn("there are no vertices, so there is nothing to see")
        return Scene((meshes + lines).ifEmpty { points(vertices) })
    }

    private fun points(vertices: VertexArrays): List<Points> {
        if (vertices.count == 0) return emptyList()
        val material = PixelDefaults.material(vertices.normals != null, vertices.colors != null)
        val size = PixelDefaults.POINT_SIZE
        val origin = vertices.origin
        return listOf(Points(vertices.positions, size, material, vertices.normals, vertices.colors, origin))
    }
}
