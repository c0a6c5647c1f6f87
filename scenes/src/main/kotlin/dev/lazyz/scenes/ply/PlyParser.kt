package dev.lazyz.scenes.ply

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene

/**
 * Reads the Polygon File Format (Greg Turk, "The PLY Polygon File Format", Stanford University, 1994) in its ASCII form
 * and both binary forms.
 *
 * The file becomes meshes (one, or one for each texture) and lines, or points if it has no faces and no edges.
 *
 * - Properties of vertices: x, y, z; nx, ny, nz; s, t or u, v (upward; v is converted to `1 - v`); red, green, blue and
 *   alpha. Colours are sRGB-encoded: integers in the range of their type, or fractions in 0..1.
 * - Properties of faces, which can have any number of corners: colours, used if vertices have none, and `texcoord`, two
 *   numbers for each corner, with `texnumber`. The element `tristrips` is also read.
 * - The element `edge` gives lines between `vertex1` and `vertex2`.
 * - Comments `TextureFile` name the textures; `<this>` stands for the file's own name.
 *
 * Alpha is stored unchanged in the vertex colours, and the material stays opaque. Other elements and properties are
 * ignored with a warning. If the file has no normals, they are computed, smooth up to creases of [CREASE_ANGLE]
 * degrees. If the file is truncated, the part that is present is shown.
 */
internal object PlyParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        source.decodeText()
        val header = PlyHeaderReader(source).read()
        val tables = FarOrigin.reading(
            source.loading,
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
        return Scene((meshes + lines).ifEmpty { vertices.points() })
    }
}
