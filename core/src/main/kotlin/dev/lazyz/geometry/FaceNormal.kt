package dev.lazyz.geometry

/** Computes the normals of triangles, one at a time. Not thread safe. */
internal class FaceNormal(private val positions: FloatArray, private val triangles: IntArray) {
    /** The normal of the last triangle: its length is twice the area, and it is 0 if a number is not finite. */
    var x = 0.0
        private set

    /** See [x]. */
    var y = 0.0
        private set

    /** See [x]. */
    var z = 0.0
        private set

    /** Computes the normal of the triangle whose first corner is number [corner]. */
    fun compute(corner: Int) {
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
