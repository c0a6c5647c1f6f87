package dev.lazyz.geometry

import kotlin.math.sqrt
import org.joml.Matrix4dc
import org.joml.Vector3dc

/** Transforms positions and normals, given as x, y, z triples. */
internal object VertexTransforms {
    /** Returns [positions], which are relative to [before], as positions relative to [origin]. */
    fun relativeTo(origin: Vector3dc, positions: FloatArray, before: Vector3dc): FloatArray {
        val way = Vectors.minus(before, origin)
        val moved = FloatArray(positions.size)
        for (i in moved.indices step 3) {
            moved[i] = (positions[i] + way.x).toFloat()
            moved[i + 1] = (positions[i + 1] + way.y).toFloat()
            moved[i + 2] = (positions[i + 2] + way.z).toFloat()
        }
        return moved
    }

    /** Whether [m] is a reflection: its determinant is negative. */
    fun isMirror(m: Matrix4dc): Boolean = Cofactors(m).isMirror

    /** Returns the positions [from], which are relative to [before], transformed by [m] and relative to [origin]. */
    fun positions(from: FloatArray, before: Vector3dc, m: Matrix4dc, origin: Vector3dc): FloatArray {
        val to = FloatArray(from.size)
        for (i in to.indices step 3) {
            val x = from[i] + before.x()
            val y = from[i + 1] + before.y()
            val z = from[i + 2] + before.z()
            to[i] = (m.m00() * x + m.m10() * y + m.m20() * z + m.m30() - origin.x()).toFloat()
            to[i + 1] = (m.m01() * x + m.m11() * y + m.m21() * z + m.m31() - origin.y()).toFloat()
            to[i + 2] = (m.m02() * x + m.m12() * y + m.m22() * z + m.m32() - origin.z()).toFloat()
        }
        return to
    }

    /**
     * Returns a suitable origin for the contents of [box] after the transform [m], see [Box.origin]; (0, 0, 0) if [box]
     * is null.
     */
    fun origin(box: Box?, m: Matrix4dc): Vector3dc {
        if (box == null) return Vectors.ZERO
        val corners = List(8) { box.corner(it) }
        val moved = Box.around(8) { corner, axis ->
            val at = corners[corner]
            m.get(0, axis) * at.x + m.get(1, axis) * at.y + m.get(2, axis) * at.z + m.get(3, axis)
        }
        return moved?.origin() ?: Vectors.ZERO
    }

    /** Whether [m] only moves, so that directions stay as they are. */
    private fun isTranslation(m: Matrix4dc): Boolean =
        (0 until 3).all { column -> (0 until 3).all { m.get(column, it) == if (column == it) 1.0 else 0.0 } }

    /** Returns the [width] numbers of each of the [vertices], in the order of [vertices]. */
    fun gathered(from: FloatArray, vertices: IntArray, width: Int): FloatArray {
        val to = FloatArray(width * vertices.size)
        for (i in vertices.indices) {
            for (k in 0 until width) to[width * i + k] = from[width * vertices[i] + k]
        }
        return to
    }

    /** Returns normals transformed by the inverse transpose of [m], at unit length; by a translation, unchanged. */
    fun normals(from: FloatArray, m: Matrix4dc): FloatArray {
        if (isTranslation(m)) return from
        val c = Cofactors(m)
        val sign = if (c.isMirror) -1.0 else 1.0
        val to = FloatArray(from.size)
        for (i in to.indices step 3) {
            val x = from[i].toDouble()
            val y = from[i + 1].toDouble()
            val z = from[i + 2].toDouble()
            unit(
                sign * (c.c00 * x + c.c10 * y + c.c20 * z),
                sign * (c.c01 * x + c.c11 * y + c.c21 * z),
                sign * (c.c02 * x + c.c12 * y + c.c22 * z),
                to,
                i,
            )
        }
        return to
    }

    /**
     * Returns tangents, x, y, z and handedness for each, transformed by [m], at unit length; by a translation,
     * unchanged. A reflection reverses the handedness.
     */
    fun tangents(from: FloatArray, m: Matrix4dc): FloatArray {
        if (isTranslation(m)) return from
        val sign = if (isMirror(m)) -1f else 1f
        val to = FloatArray(from.size)
        for (i in to.indices step 4) {
            val x = from[i].toDouble()
            val y = from[i + 1].toDouble()
            val z = from[i + 2].toDouble()
            unit(
                m.m00() * x + m.m10() * y + m.m20() * z,
                m.m01() * x + m.m11() * y + m.m21() * z,
                m.m02() * x + m.m12() * y + m.m22() * z,
                to,
                i,
            )
            to[i + 3] = sign * from[i + 3]
        }
        return to
    }

    /**
     * The cofactor matrix: the inverse transpose times the determinant. The transform is a reflection if the
     * determinant is negative.
     */
    private class Cofactors(m: Matrix4dc) {
        val c00 = m.m11() * m.m22() - m.m12() * m.m21()
        val c01 = m.m12() * m.m20() - m.m10() * m.m22()
        val c02 = m.m10() * m.m21() - m.m11() * m.m20()
        val c10 = m.m21() * m.m02() - m.m22() * m.m01()
        val c11 = m.m22() * m.m00() - m.m20() * m.m02()
        val c12 = m.m20() * m.m01() - m.m21() * m.m00()
        val c20 = m.m01() * m.m12() - m.m02() * m.m11()
        val c21 = m.m02() * m.m10() - m.m00() * m.m12()
        val c22 = m.m00() * m.m11() - m.m01() * m.m10()
        val isMirror = m.m00() * c00 + m.m01() * c01 + m.m02() * c02 < 0.0
    }

    /**
     * Writes (x, y, z) scaled to unit length to [out] at index [at] and the next two. Writes 0 if the length is 0 or
     * not finite.
     */
    fun unit(x: Double, y: Double, z: Double, out: FloatArray, at: Int) {
        val length = sqrt(x * x + y * y + z * z)
        val scale = if (length > 0.0 && length.isFinite()) 1.0 / length else 0.0
        out[at] = (x * scale).toFloat()
        out[at + 1] = (y * scale).toFloat()
        out[at + 2] = (z * scale).toFloat()
    }
}
