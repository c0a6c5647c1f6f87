package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.gltf.animation.NodePose
import dev.lazyz.scenes.gltf.document.NodeJson
import org.joml.Matrix4d
import org.joml.Matrix4dc

/**
 * The arithmetic of node transforms (section 3.5.3). It is written out here so that results are bit for bit the same on
 * every machine: JOML's own products may use fused multiply-add, depending on a JVM flag.
 */
internal object NodeTransforms {
    /**
     * Returns the transform from a node's space to its parent's: its matrix, or the product of translation, rotation
     * and scale. Values in [pose] replace those of the node.
     */
    fun of(node: NodeJson, pose: NodePose?): Matrix4d {
        val m = node.matrix
        if (m != null && pose?.isMoved != true) {
            // The fourth row is 0, 0, 0, 1 in every transform that the specification allows
            return Matrix4d(
                m[0].toDouble(), m[1].toDouble(), m[2].toDouble(), 0.0,
                m[4].toDouble(), m[5].toDouble(), m[6].toDouble(), 0.0,
                m[8].toDouble(), m[9].toDouble(), m[10].toDouble(), 0.0,
                m[12].toDouble(), m[13].toDouble(), m[14].toDouble(), 1.0,
            )
        }
        return of(
            pose?.translation ?: doubles(node.translation),
            pose?.rotation ?: doubles(node.rotation),
            pose?.scale ?: doubles(node.scale),
        )
    }

    /** Returns the product of a translation, a rotation as a unit quaternion, and a scale; null means none. */
    fun of(translation: DoubleArray?, rotation: DoubleArray?, scale: DoubleArray?): Matrix4d {
        val t = translation ?: doubleArrayOf(0.0, 0.0, 0.0)
        val (sx, sy, sz) = scale ?: doubleArrayOf(1.0, 1.0, 1.0)
        val (x, y, z, w) = rotation ?: doubleArrayOf(0.0, 0.0, 0.0, 1.0)

        // The columns of the quaternion's matrix, each multiplied by its scale
        return Matrix4d(
            (1.0 - 2.0 * (y * y + z * z)) * sx, 2.0 * (x * y + z * w) * sx, 2.0 * (x * z - y * w) * sx, 0.0,
            2.0 * (x * y - z * w) * sy, (1.0 - 2.0 * (x * x + z * z)) * sy, 2.0 * (y * z + x * w) * sy, 0.0,
            2.0 * (x * z + y * w) * sz, 2.0 * (y * z - x * w) * sz, (1.0 - 2.0 * (x * x + y * y)) * sz, 0.0,
            t[0], t[1], t[2], 1.0,
        )
    }

    private fun doubles(numbers: FloatArray?): DoubleArray? = numbers?.let {
        DoubleArray(it.size) { i -> it[i].toDouble() }
    }

    /** Whether [m] reverses orientation, that is, has a negative determinant. */
    fun isMirror(m: Matrix4dc): Boolean = m.m00() * (m.m11() * m.m22() - m.m12() * m.m21()) +
        m.m01() * (m.m12() * m.m20() - m.m10() * m.m22()) + m.m02() * (m.m10() * m.m21() - m.m11() * m.m20()) < 0.0

    /** Whether [m] is the identity. */
    fun isIdentity(m: Matrix4dc): Boolean = (0 until 4).all { column ->
        (0 until 4).all { row -> m.get(column, row) == if (column == row) 1.0 else 0.0 }
    }
}
