package dev.lazyz.scenes.stl

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Mesh

/**
 * Reads stereolithography files, ASCII and binary (3D Systems, "Stereolithography Interface Specification", 1989).
 *
 * Each solid becomes a mesh. Corners at the same position become one vertex, and normals are smoothed up to creases of
 * [CREASE_ANGLE] degrees. The facets' own normals are ignored: many programs leave them zero or wrong, and the order of
 * the corners, counter-clockwise seen from outside, gives the same information. Colours of facets in the binary form
 * become vertex colours, see [StlColors].
 */
internal object StlParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. Printed parts have chamfers of 45 degrees. */
    const val CREASE_ANGLE = 30.0

    override fun parse(source: Source): Scene {
        val meshes = meshes(source)
        if (meshes.isEmpty()) source.warn("there are no facets, so there is nothing to see")
        return Scene(meshes.map { source.loading.smoothed(source, it, CREASE_ANGLE) })
    }

    private fun ascii(source: Source): List<Solid> = FarOrigin.reading(
        source.loading,
        read = { origin ->
            val solids = ArrayList<Solid>()
            StlAscii(source, origin).read { name ->
                source.loading.items(source, 1)
                Solid(name, origin = origin).also(solids::add)
            }
            solids
        },
        bounds = { solids -> solids.mapNotNull { Box.around(it.positions()) }.reduceOrNull(Box::union) },
    )

    private fun meshes(source: Source): List<Mesh> {
        val solids = if (StlBinary.isBinary(source.bytes, source.bytes.size.toLong())) {
            listOf(StlBinary.read(source))
        } else {
            source.decodeText()
            ascii(source)
        }
        source.release()
        for (solid in solids) {
            source.loading.triangles(source, solid.triangleCount.toLong())
            source.loading.vertices(source, solid.vertexCount.toLong())
        }
        return solids.filter { it.triangleCount > 0 }.map { it.mesh(source) }
    }
}
