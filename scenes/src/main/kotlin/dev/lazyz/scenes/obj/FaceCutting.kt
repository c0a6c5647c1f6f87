package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.Triangulation
import dev.lazyz.scenes.meshes.VertexPositions

/** Triangulates [faces]. Not thread safe. */
internal class FaceCutting(
    private val source: Source,
    private val faces: FaceTable,
    private val positions: VertexPositions,
) {
    /** Adds the corners of the triangles of [face] to [corners], as numbers among the corners of all faces. */
    fun cut(face: Int, corners: Ints) {
        val start = faces.start(face)
        val count = faces.end(face) - start
        if (count == 3) {
            corners.add(start, start + 1, start + 2)
            return
        }
        val local = Triangulation.triangles(
            DoubleArray(3 * count) { positions.get(faces.positions[start + it / 3], it % 3).toDouble() },
        )
        if (local == null) {
            val most = Triangulation.MAX_CONCAVE_CORNERS
            val where = "line ${faces.line(face)}"
            source.warn("", "$where: a concave face of $count corners", ", more than $most, is left out")
            return
        }
        for (corner in local) corners.add(start + corner)
    }
}
