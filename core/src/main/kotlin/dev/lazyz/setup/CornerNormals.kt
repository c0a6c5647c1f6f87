package dev.lazyz.setup

import kotlin.math.sqrt

/**
 * The normals of the corners at one position after the other, and the vertex copies that have them: corners of one
 * vertex with the same normal share a copy. Not thread safe.
 *
 * @param vertices the vertex of each corner
 * @param faces see [FaceNormals]
 * @param cosine of the angle from which on an edge is a crease
 * @param firstCopy by vertex: the copy to begin its chain with, or -1; an array for all instances, which do different
 * vertices
 * @param copyOf by corner: where its copy is written; an array for all instances
 */
internal class CornerNormals(
    private val vertices: IntArray,
    private val faces: DoubleArray,
    private val cosine: Double,
    private val firstCopy: IntArray,
    private val copyOf: IntArray,
) {
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
        var sumX = 0.0
        var sumY = 0.0
        var sumZ = 0.0
        for (i in from until until) {
            val at = corners[i] / 3 * 3
            sumX += faces[at]
            sumY += faces[at + 1]
            sumZ += faces[at + 2]
        }
        MeshGeometry.unit(sumX, sumY, sumZ, normal, 0)
    }

    /** Looks at each pair of faces; false if none is a crease. */
    private fun findCreases(corners: IntArray, from: Int, until: Int): Boolean {
        val count = until - from
        var isAny = false
        for (i in 0 until count) {
            val at = corners[from + i] / 3 * 3
            face[i] = at
            x[i] = faces[at]
            y[i] = faces[at + 1]
            z[i] = faces[at + 2]
            length[i] = sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i])
            isCreased[i] = false
            for (j in 0 until i) {
                if (isCrease(i, j)) {
                    isCreased[i] = true
                    isAny = true
                }
                if (isCrease(j, i)) {
                    isCreased[j] = true
                    isAny = true
                }
            }
        }
        return isAny
    }

    private fun isCrease(i: Int, j: Int): Boolean {
        val dot = x[i] * x[j] + y[i] * y[j] + z[i] * z[j]
        return dot <= cosine * length[i] * length[j] && face[i] != face[j]
    }

    /** Makes [normal] the sum of the faces that make no crease with face [i], at unit length. */
    private fun sumOfSmooth(i: Int, count: Int) {
        var sumX = 0.0
        var sumY = 0.0
        var sumZ = 0.0
        for (j in 0 until count) {
            if (isCrease(i, j)) continue
            sumX += x[j]
            sumY += y[j]
            sumZ += z[j]
        }
        MeshGeometry.unit(sumX, sumY, sumZ, normal, 0)
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
    }
}
