package dev.lazyz.setup

import kotlin.math.sqrt

/**
 * The normals of the corners at one position after the other, and the vertex copies that have them: corners of one
 * vertex with the same normal share a copy. Not thread safe.
 *
 * @param vertices the vertex of each corner
 * @param faces see [FaceNormals]
 * @param creaseAngle from which on an edge is a crease, degrees
 * @param firstCopy by vertex: the copy to begin its chain with, or -1; an array for all instances, which do different
 * vertices
 * @param copyOf by corner: where its copy is written; an array for all instances
 */
internal class CornerNormals(
    private val vertices: IntArray,
    private val faces: DoubleArray,
    creaseAngle: Double,
    private val firstCopy: IntArray,
    private val copyOf: IntArray,
) {
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

    private val face = IntArray(CROWD)
    private val x = DoubleArray(CROWD)
    private val y = DoubleArray(CROWD)
    private val z = DoubleArray(CROWD)
    private val length = DoubleArray(CROWD)

    /** Whether a corner of the position at hand has a crease around it. */
    private val isCreased = BooleanArray(CROWD)
    private val normal = FloatArray(3)

    // The sum of all faces at the position at hand
    private var sumX = 0.0
    private var sumY = 0.0
    private var sumZ = 0.0

    /** Does the [corners] from place [from] until [until], which are at one position. */
    fun add(corners: IntArray, from: Int, until: Int) {
        mean(corners, from, until)
        val isCrowded = until - from > CROWD
        if (isCrowded || !findCreases(corners, from, until)) {
            for (i in from until until) share(corners[i])
            return
        }
        val meanX = normal[0]
        val meanY = normal[1]
        val meanZ = normal[2]
        for (i in 0 until until - from) {
            if (isCreased[i]) {
                sumOfSmooth(i, until - from)
            } else {
                normal[0] = meanX
                normal[1] = meanY
                normal[2] = meanZ
            }
            share(corners[from + i])
        }
    }

    /** Makes [normal] the sum of all the corners' faces, at unit length. */
    private fun mean(corners: IntArray, from: Int, until: Int) {
        sumX = 0.0
        sumY = 0.0
        sumZ = 0.0
        for (i in from until until) {
            val at = corners[i] / 3 * 3
            sumX += faces[at]
            sumY += faces[at + 1]
            sumZ += faces[at + 2]
        }
        MeshGeometry.unit(sumX, sumY, sumZ, normal, 0)
    }

    /** Looks for creases; false if there is none. */
    private fun findCreases(corners: IntArray, from: Int, until: Int): Boolean {
        val count = until - from
        for (i in 0 until count) {
            val at = corners[from + i] / 3 * 3
            face[i] = at
            x[i] = faces[at]
            y[i] = faces[at + 1]
            z[i] = faces[at + 2]
            length[i] = sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i])
        }
        return !areNarrow(count) && findCreasedPairs(count)
    }

    /** Whether all faces lean from their sum by so little that no two make a crease; false if that is not certain. */
    private fun areNarrow(count: Int): Boolean {
        val sumLength = sqrt(sumX * sumX + sumY * sumY + sumZ * sumZ)
        if (sumLength !in SHORTEST..LONGEST) return false
        for (i in 0 until count) {
            if (length[i] !in SHORTEST..LONGEST) return false
            if (x[i] * sumX + y[i] * sumY + z[i] * sumZ <= narrowCosine * sumLength * length[i]) return false
        }
        return true
    }

    /** Looks at each pair of faces; false if none makes a crease. */
    private fun findCreasedPairs(count: Int): Boolean {
        for (i in 0 until count) {
            isCreased[i] = false
            for (j in 0 until i) {
                if (isCrease(i, j)) isCreased[i] = true
                if (isCrease(j, i)) isCreased[j] = true
            }
        }
        for (i in 0 until count) if (isCreased[i]) return true
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

    /** Gives [corner] the copy of its vertex that has [normal], a new one if there is none. */
    private fun share(corner: Int) {
        val vertex = vertices[corner]
        var copy = firstCopy[vertex]
        while (copy >= 0 && !hasNormal(copy)) copy = nextCopy[copy]
        if (copy < 0) {
            if (size == nextCopy.size) {
                nextCopy = nextCopy.copyOf(size + size / 2)
                normals = normals.copyOf(3 * nextCopy.size)
            }
            copy = size++
            nextCopy[copy] = firstCopy[vertex]
            firstCopy[vertex] = copy
            normal.copyInto(normals, 3 * copy)
        }
        copyOf[corner] = copy
    }

    /** By their bits: -0 is another number than 0 here, and NaN the same as NaN. */
    private fun hasNormal(copy: Int): Boolean = normals[3 * copy].toBits() == normal[0].toBits() &&
        normals[3 * copy + 1].toBits() == normal[1].toBits() && normals[3 * copy + 2].toBits() == normal[2].toBits()

    private companion object {
        const val LEAST = 16

        /** Where more corners than this meet, creases are not looked for: it would cost the square of their number. */
        const val CROWD = 1024

        /** Radians, far more than roundings turn a vector by where its length is in [SHORTEST]..[LONGEST]. */
        const val MARGIN = 1e-6
        const val SHORTEST = 1e-140
        const val LONGEST = 1e140

        /** More than any cosine. */
        const val NEVER = 2.0

        fun radians(degrees: Double) = degrees * (StrictMath.PI / 180.0)
    }
}
