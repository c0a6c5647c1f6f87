package dev.lazyz.scenes.obj

import dev.lazyz.scenes.meshes.Triangulation

/** Cuts the faces of a [FaceTable] into triangles. */
internal object ObjTriangles {
    /**
     * Returns the corners of the triangles of [face], as indices in the lists of [faces], or null if the face is concave
     * and has too many corners. [coordinate] returns a coordinate of a position.
     */
    inline fun of(faces: FaceTable, face: Int, coordinate: (position: Int, axis: Int) -> Float): IntArray? {
        val start = faces.start(face)
        val count = faces.end(face) - start
        val local = if (count == 3) {
            intArrayOf(0, 1, 2)
        } else {
            Triangulation.triangles(
                DoubleArray(3 * count) { coordinate(faces.positions[start + it / 3], it % 3).toDouble() },
            ) ?: return null
        }
        for (i in local.indices) local[i] += start
        return local
    }

    /** Returns the warning for a face for which [of] returns null. */
    fun tooConcave(faces: FaceTable, face: Int): String {
        val count = faces.end(face) - faces.start(face)
        val most = Triangulation.MAX_CONCAVE_CORNERS
        return "line ${faces.line(face)}: a concave face of $count corners, more than $most, is left out"
    }
}
