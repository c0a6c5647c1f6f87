package dev.lazyz.scenes.scenefile

import dev.lazyz.geometry.Transforms
import org.joml.Matrix4d
import org.joml.Vector3d

/** The up axis of a scene file. The library's up axis is y; files with z up are rotated when they are read. */
internal enum class UpAxis(val id: String) {
    Y("y"),
    Z("z"),
    ;

    /** Converts a point or direction from the file's axes to the library's: with z up, (x, y, z) becomes (x, z, -y). */
    fun toWorld(v: DoubleArray): Vector3d = if (this == Y) Vector3d(v[0], v[1], v[2]) else Vector3d(v[0], v[2], -v[1])

    /** Returns [transform] followed by the rotation to the library's axes. Null stands for the identity. */
    fun toWorld(transform: Matrix4d?): Matrix4d? = when {
        this == Y -> transform
        transform == null -> Matrix4d(TURN)
        else -> Transforms.product(TURN, transform)
    }

    companion object {
        val byId: Map<String, UpAxis> = entries.associateBy { it.id }

        private val TURN = Matrix4d(
            1.0, 0.0, 0.0, 0.0,
            0.0, 0.0, -1.0, 0.0,
            0.0, 1.0, 0.0, 0.0,
            0.0, 0.0, 0.0, 1.0,
        )
    }
}
