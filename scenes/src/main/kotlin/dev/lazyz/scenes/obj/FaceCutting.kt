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
        source.step(count)
        if (count == 3) {
            corners.add(start, start + 1, start + 2)
            return
        }
        val isSmall = count <= Triangulation.MAX_CORNERS
        val local = if (isSmall) Triangulation.triangles(xyz(start, count), source::step) else null
        if (local == null) {
            val what = "line ${faces.line(face)}: a face of $count corners"
            source.warn("", what, ", ${Triangulation.TOO_MANY}, is left out")
            return
        }
        for (corner in local) corners.add(start + corner)
    }

    private fun xyz(start: Int, count: Int): DoubleArray =
        DoubleArray(3 * count) { positions.get(faces.positions[start + it / 3], it % 3).toDouble() }
}
