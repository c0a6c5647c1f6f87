package dev.lazyz.setup

import dev.lazyz.Mesh

/** The normal of one triangle of a mesh after the other. Not thread safe. */
internal class FaceNormal(mesh: Mesh) {
    private val positions = mesh.positions
    private val triangles = mesh.triangles

    var x = 0.0
        private set
    var y = 0.0
        private set
    var z = 0.0
        private set

    /** Makes it that of the triangle whose corners begin at [corner], as long as twice its area; 0 if it is not finite. */
    fun make(corner: Int) {
        val p = positions
        val a = 3 * triangles[corner]
        val b = 3 * triangles[corner + 1]
        val c = 3 * triangles[corner + 2]
        val ux = p[b].toDouble() - p[a]
        val uy = p[b + 1].toDouble() - p[a + 1]
        val uz = p[b + 2].toDouble() - p[a + 2]
        val vx = p[c].toDouble() - p[a]
        val vy = p[c + 1].toDouble() - p[a + 1]
        val vz = p[c + 2].toDouble() - p[a + 2]
        x = uy * vz - uz * vy
        y = uz * vx - ux * vz
        z = ux * vy - uy * vx
        if (x.isFinite() && y.isFinite() && z.isFinite()) return
        x = 0.0
        y = 0.0
        z = 0.0
    }
}
