package dev.lazyz.scenes.off

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.scenes.meshes.PolygonMesh
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material

/**
 * Reads the Object File Format in its ASCII form (M. Phillips, S. Levy and T. Munzner, "Geomview Manual", version 1.9,
 * section 4.2.5).
 *
 * The file becomes one mesh, or points if it has no faces. Each vertex is one line with x, y, z and the attributes that
 * the first word of the file declares, in this order: the normal (`N`), the colour (`C`), and texture coordinates
 * (`ST`, v upward, converted to `1 - v`). If it declares none, and each vertex has three or four more numbers, they are
 * read as a colour, with a warning, unless they are out of range or could be normals. A face, on one or more lines, can
 * have any number of corners and a colour, which is used if vertices have none. Colours of three or four numbers are
 * sRGB-encoded, see [OffColors]; indices into a colour map are ignored with a warning. Alpha is stored unchanged in the
 * vertex colours, and the material stays opaque. If the file has no normals, they are computed, smooth up to creases of
 * [CREASE_ANGLE] degrees. Vertices that are not three-dimensional, and the binary form, are rejected.
 */
internal object OffParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        source.decodeText()
        val reader = FarOrigin.reading(
            source.loading,
            read = { origin -> OffReader(source, origin).also { it.readVertices() } },
            bounds = { Box.around(it.vertices.positions) },
        )
        reader.readFaces()
        source.release()
        val triangles = PolygonMesh(source, reader.vertices, reader.polygons)
        if (triangles.triangleCount == 0) {
            if (reader.vertices.count == 0) source.warn("there are no vertices, so there is nothing to see")
            return Scene(reader.vertices.points())
        }
        return Scene(listOf(MissingNormals.computed(source, triangles.mesh(Material()), CREASE_ANGLE)))
    }
}
