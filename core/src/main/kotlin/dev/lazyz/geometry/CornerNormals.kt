package dev.lazyz.geometry

import dev.lazyz.Checkpoint
import kotlin.math.sqrt

/**
 * Computes the normals of the corners at one position after the other, and assigns vertex copies to them. Corners of
 * one vertex that have the same normal share a copy. Not thread safe.
 *
 * @param positions x, y, z of each vertex
 * @param vertices the vertex of each corner. The normals of triangles are computed wherever one is needed, because
 *   keeping them takes more memory than the mesh
 * @param creaseAngle the smallest angle of an edge that is a crease, degrees
 * @param firstCopy by vertex: the first copy in its chain, or -1; one array for all instances, which process different
 *   vertices
 * @param copyOf by corner: receives the corner's copy; one array for all instances
 */
internal class CornerNormals(
    positions: FloatArray,
    private val vertices: IntArray,
    creaseAngle: Double,
    private val firstCopy: IntArray,
    private val copyOf: IntArray,
) {
    private val faceNormal = FaceNormal(positions, vertices)
    private val cosine = StrictMath.cos(radians(creaseAngle))

    /**
     * Cosine of an angle slightly below half the crease angle. If all faces are within this angle of one direction, no
     * two of them make a crease.
     */
    private val narrowCosine = if (creaseAngle > 1.0) StrictMath.cos(radians(creaseAngle) / 2 - MARGIN) else NEVER

    /** Number of copies so far. */
    var size = 0
        private set

    /** Normals of the copies: x, y, z for each. */
    var normals = FloatArray(3 * LEAST)
        private set
    private var nextCopy = IntArray(LEAST)

    // Data of each corner at the current position, unless there are more than CROWD: offset of its face, and the face's
    // normal
    private val most = minOf(CROWD, vertices.size)
    private val face = IntArray(most)
    private val x = DoubleArray(most)
    private val y = DoubleArray(most)
    private val z = DoubleArray(most)
    private val length = DoubleArray(most)
    private val normal = FloatArray(3)

    // The sum of the normals of all faces at the current position
    private var sumX = 0.0
    private var sumY = 0.0
    private var sumZ = 0.0

    /** Processes the elements [from] until [until] of [corners], which are the corners at one position. */
    fun add(corners: IntArray, from: Int, until: Int) {
        val count = until - from
        addUp(corners, from, until)
        if (count > CROWD || areNarrow(count) || !haveCreases(count)) {
            shareMean(corners, from, until)
            return
        }
        for (i in 0 until count) {
            sumOfSmooth(i, count)
            copyOf[corners[from + i]] = copy(vertices[corners[from + i]])
        }
    }

    /** Assigns the sum of all face normals, at unit length, to all these corners. */
    private fun shareMean(corners: IntArray, from: Int, until: Int) {
        VertexTransforms.unit(sumX, sumY, sumZ, normal, 0)
        var vertex = -1
        var copy = -1
        for (i in from until until) {
            val corner = corners[i]
            if (vertices[corner] != vertex) {
                vertex = vertices[corner]
                copy = copy(vertex)
            }
            copyOf[corner] = copy
        }
    }

    /** Loads the face normals of the corners, and adds them up. */
    private fun addUp(corners: IntArray, from: Int, until: Int) {
        val isCrowded = until - from > CROWD
        sumX = 0.0
        sumY = 0.0
        sumZ = 0.0
        for (i in from until until) {
            val at = corners[i] / 3 * 3
            faceNormal.compute(at)
            sumX += faceNormal.x
            sumY += faceNormal.y
            sumZ += faceNormal.z
            if (isCrowded) continue
            face[i - from] = at
            x[i - from] = faceNormal.x
            y[i - from] = faceNormal.y
            z[i - from] = faceNormal.z
        }
    }

    /**
     * Whether all face normals are so close to their sum that no two faces make a crease; false if this is not certain.
     */
    private fun areNarrow(count: Int): Boolean {
        val sumSquare = sumX * sumX + sumY * sumY + sumZ * sumZ
        if (sumSquare !in SMALLEST..LARGEST) return false
        val bound = narrowCosine * narrowCosine * sumSquare
        for (i in 0 until count) {
            val square = x[i] * x[i] + y[i] * y[i] + z[i] * z[i]
            if (square !in SMALLEST..LARGEST) return false
            val dot = x[i] * sumX + y[i] * sumY + z[i] * sumZ
            if (dot <= 0.0 || dot * dot <= bound * square) return false
        }
        return true
    }

    /** Whether any two faces make a crease. */
    private fun haveCreases(count: Int): Boolean {
        for (i in 0 until count) length[i] = sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i])
        for (i in 0 until count) {
            for (j in 0 until count) if (isCrease(i, j)) return true
        }
        return false
    }

    private fun isCrease(i: Int, j: Int): Boolean {
        val dot = x[i] * x[j] + y[i] * y[j] + z[i] * z[j]
        return dot <= cosine * length[i] * length[j] && face[i] != face[j]
    }

    /** Sets [normal] to the sum of the normals of the faces that make no crease with face [i], at unit length. */
    private fun sumOfSmooth(i: Int, count: Int) {
        var smoothX = 0.0
        var smoothY = 0.0
        var smoothZ = 0.0
        for (j in 0 until count) {
            if (isCrease(i, j)) continue
            smoothX += x[j]
            smoothY += y[j]
            smoothZ += z[j]
        }
        VertexTransforms.unit(smoothX, smoothY, smoothZ, normal, 0)
    }

    /** Returns the copy of [vertex] that has [normal]; creates it if there is none. */
    private fun copy(vertex: Int): Int {
        var copy = firstCopy[vertex]
        while (copy >= 0 && !hasNormal(copy)) copy = nextCopy[copy]
        if (copy >= 0) return copy
        if (size == nextCopy.size) {
            nextCopy = nextCopy.copyOf(size + size / 2)
            normals = normals.copyOf(3 * nextCopy.size)
        }
        nextCopy[size] = firstCopy[vertex]
        firstCopy[vertex] = size
        normal.copyInto(normals, 3 * size)
        return size++
    }

    /** Compares bits: -0 differs from 0, and all NaNs are equal. */
    private fun hasNormal(copy: Int): Boolean = normals[3 * copy].toBits() == normal[0].toBits() &&
        normals[3 * copy + 1].toBits() == normal[1].toBits() && normals[3 * copy + 2].toBits() == normal[2].toBits()

    private companion object {
        const val LEAST = 16

        /**
         * If more corners than this are at one position, creases are not detected, because the cost is quadratic in
         * their number.
         */
        const val CROWD = 1024

        /**
         * Radians; much more than the rounding error in the direction of a vector whose squared length is in
         * [SMALLEST]..[LARGEST].
         */
        const val MARGIN = 1e-6
        const val SMALLEST = 1e-140
        const val LARGEST = 1e140

        /** Greater than any cosine. */
        const val NEVER = 2.0

        fun radians(degrees: Double) = degrees * (StrictMath.PI / 180.0)
    }
}

/**
 * The corners of a mesh's triangles (three for each) grouped by position. Positions are numbered, and the corners of
 * each position are in the order of the triangles. Immutable.
 *
 * @param checkpoint may end the grouping
 */
internal class CornersByPosition(positions: FloatArray, triangles: IntArray, private val checkpoint: Checkpoint) {
    /** By vertex: the number of its position. */
    val positionOf: IntArray = positionNumbers(positions)

    /** By position: the index in [corners] of its first corner. The corners of position i end at `starts[i + 1]`. */
    val starts: IntArray

    /** The corners, grouped by position. */
    val corners: IntArray

    init {
        // Counts are stored two places up, so their running sums are the starts of the positions, one place up. The
        // loop below then advances each of them to the end of its position, which is the start of the next
        starts = IntArray((positionOf.maxOrNull() ?: -1) + 3)
        for ((corner, vertex) in triangles.withIndex()) {
            passAt(corner)
            starts[positionOf[vertex] + 2]++
        }
        for (i in 2 until starts.size) starts[i] += starts[i - 1]
        corners = IntArray(triangles.size)
        for ((corner, vertex) in triangles.withIndex()) {
            passAt(corner)
            corners[starts[positionOf[vertex] + 1]++] = corner
        }
    }

    /** Number of positions. */
    val count: Int get() = starts.size - 2

    private fun positionNumbers(p: FloatArray): IntArray {
        val count = p.size / 3
        val distinct = DistinctTriples(count)
        return IntArray(count) {
            passAt(it)
            distinct.addPoint(p[3 * it], p[3 * it + 1], p[3 * it + 2])
        }
    }

    private fun passAt(number: Int) {
        if (Checkpoint.isDue(number)) checkpoint.pass()
    }
}

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
