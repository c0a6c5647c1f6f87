package dev.lazyz.setup

import dev.lazyz.Mesh
import kotlin.math.sqrt

/**
 * The normals of the corners at one position after the other, and the vertex copies that have them: corners of one
 * vertex with the same normal share a copy. Not thread safe.
 *
 * @param mesh its triangles' normals are made wherever one is needed, for keeping them takes more memory than the mesh
 * @param creaseAngle from which on an edge is a crease, degrees
 * @param firstCopy by vertex: the copy to begin its chain with, or -1; an array for all instances, which do different
 * vertices
 * @param copyOf by corner: where its copy is written; an array for all instances
 */
internal class CornerNormals(
    mesh: Mesh,
    creaseAngle: Double,
    private val firstCopy: IntArray,
    private val copyOf: IntArray,
) {
    private val vertices = mesh.triangles
    private val faceNormal = FaceNormal(mesh)
    private val cosine = StrictMath.cos(radians(creaseAngle))

    /** Of an angle safely below half the crease's: no two faces that lean from one direction by less make a crease. */
    private val narrowCosine = if (creaseAngle > 1.0) StrictMath.cos(radians(creaseAngle) / 2 - MARGIN) else NEVER

    /** How many copies there are so far. */
    var size = 0
        private set

    /** x, y, z of each copy. */
    var normals = FloatArray(3 * LEAST)
        private set
    private var nextCopy = IntArray(LEAST)

    // Of each corner at the position at hand, unless it is crowded: its face, and that one's normal
    private val most = minOf(CROWD, vertices.size)
    private val face = IntArray(most)
    private val x = DoubleArray(most)
    private val y = DoubleArray(most)
    private val z = DoubleArray(most)
    private val length = DoubleArray(most)
    private val normal = FloatArray(3)

    // The sum of all faces at the position at hand
    private var sumX = 0.0
    private var sumY = 0.0
    private var sumZ = 0.0

    /** Does the [corners] from place [from] until [until], which are at one position. */
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

    /** Gives all the corners the sum of their faces, at unit length. */
    private fun shareMean(corners: IntArray, from: Int, until: Int) {
        MeshGeometry.unit(sumX, sumY, sumZ, normal, 0)
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

    /** Takes the faces of the corners, and adds them up. */
    private fun addUp(corners: IntArray, from: Int, until: Int) {
        val isCrowded = until - from > CROWD
        sumX = 0.0
        sumY = 0.0
        sumZ = 0.0
        for (i in from until until) {
            val at = corners[i] / 3 * 3
            faceNormal.make(at)
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

    /** Whether all faces lean from their sum by so little that no two make a crease; false if that is not certain. */
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

    /** Makes [normal] the sum of the faces that make no crease with face [i], at unit length. */
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
        MeshGeometry.unit(smoothX, smoothY, smoothZ, normal, 0)
    }

    /** Returns the copy of [vertex] that has [normal], a new one if there is none. */
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

    /** By their bits: -0 is another number than 0 here, and NaN the same as NaN. */
    private fun hasNormal(copy: Int): Boolean = normals[3 * copy].toBits() == normal[0].toBits() &&
        normals[3 * copy + 1].toBits() == normal[1].toBits() && normals[3 * copy + 2].toBits() == normal[2].toBits()

    private companion object {
        const val LEAST = 16

        /** Where more corners than this meet, creases are not looked for: it would cost the square of their number. */
        const val CROWD = 1024

        /** Radians, far more than roundings turn a vector by whose squared length is in [SMALLEST]..[LARGEST]. */
        const val MARGIN = 1e-6
        const val SMALLEST = 1e-140
        const val LARGEST = 1e140

        /** More than any cosine. */
        const val NEVER = 2.0

        fun radians(degrees: Double) = degrees * (StrictMath.PI / 180.0)
    }
}
