package dev.lazyz.scenes.off

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.PolygonMesh
import dev.lazyz.world.Material
import dev.lazyz.world.Scene

/**
 * Reads the Object File Format in its ASCII form (M. Phillips, S. Levy and T. Munzner, "Geomview Manual", version 1.9,
 * section 4.2.5).
 *
 * The file becomes one mesh. Of vertices, one a line, it takes x, y, z, and what the first word announces, in this order:
 * the normal (`N`), the colour (`C`), and texture coordinates (`ST`, v upward, turned to `1 - v`). Faces, one a line or
 * over several, may have any number of corners and a colour, which counts where vertices have none. Colours of three or
 * four numbers are sRGB-encoded, see [OffColors]; numbers of a colour map are passed over with a warning. Alpha goes into
 * the vertex colours as it is, and the material stays opaque. Without normals in the file they are made smooth up to
 * creases of [CREASE_ANGLE] degrees. Vertices of other than three dimensions, and the binary form, are refused.
 */
internal object OffParser : SceneParser {
    /** Edges sharper than this stay sharp, degrees. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        if (source.bytes.isEmpty()) source.fail(null, "the file is empty", "export the model again")
        source.decodeText()
        val reader = FarOrigin.reading(
            read = { origin -> OffReader(source, origin).also { it.readVertices() } },
            bounds = { Box.around(it.vertices.positions) },
        )
        reader.readFaces()
        source.release()
        val triangles = PolygonMesh(source, reader.vertices, reader.polygons)
        if (triangles.triangleCount == 0) {
            source.warn("there are no faces, so there is nothing to see")
            return Scene(emptyList())
        }
        return Scene(listOf(source.loading.smoothed(source, triangles.mesh(Material()), CREASE_ANGLE)))
    }
}
