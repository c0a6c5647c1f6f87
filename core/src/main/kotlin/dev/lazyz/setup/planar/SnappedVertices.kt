package dev.lazyz.setup.planar

import dev.lazyz.setup.VertexStage
import dev.lazyz.world.surface.Mesh

/** The vertices of [mesh], snapped to the grid. */
internal class SnappedVertices(private val stage: VertexStage, private val mesh: Mesh) {
    val grid = IntArray(TriangleBatch.STRIDE * mesh.vertexCount)
    val inverseW = if (stage.isPerspective) DoubleArray(mesh.vertexCount) else null

    /** By vertex: whether it is outside any plane or not finite; null if there is no such vertex. */
    @Volatile
    var isOutside: BooleanArray? = null
        private set

    fun isOutside(triangle: Int): Boolean {
        val outside = isOutside ?: return false
        return outside[mesh.triangles[3 * triangle]] || outside[mesh.triangles[3 * triangle + 1]] ||
            outside[mesh.triangles[3 * triangle + 2]]
    }

    /** Transforms, projects and snaps the vertices [from] until [until], see [VertexStage]. */
    fun snap(from: Int, until: Int) {
        val p = mesh.positions
        val viewport = stage.viewport
        for (i in from until until) {
            stage.toClip(p[3 * i].toDouble(), p[3 * i + 1].toDouble(), p[3 * i + 2].toDouble()) { x, y, z, w ->
                if (stage.clipper.isInside(x, y, z, w)) {
                    grid[TriangleBatch.STRIDE * i] = viewport.gridX(x, w)
                    grid[TriangleBatch.STRIDE * i + 1] = viewport.gridY(y, w)
                    grid[TriangleBatch.STRIDE * i + 2] = viewport.depth(z, w)
                    if (inverseW != null) inverseW[i] = 1.0 / w
                } else {
                    outside()[i] = true
                }
            }
        }
    }

    @Synchronized
    private fun outside(): BooleanArray =
        isOutside ?: BooleanArray(mesh.vertexCount).also { isOutside = it }
}
