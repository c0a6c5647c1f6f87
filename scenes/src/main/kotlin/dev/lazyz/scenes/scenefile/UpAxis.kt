package dev.lazyz.scenes.scenefile

import dev.lazyz.geometry.Transforms
import org.joml.Matrix4d
import org.joml.Vector3d

/** Which axis of a scene file points up. The library's is y; files that say z are turned as they are read. */
internal enum class UpAxis(val id: String) {
    Y("y"),
    Z("z"),
    ;

    /** Returns a point or direction of the file in the library's axes: z up becomes (x, z, -y). */
    fun toWorld(v: DoubleArray): Vector3d = if (this == Y) Vector3d(v[0], v[1], v[2]) else Vector3d(v[0], v[2], -v[1])

    /** Returns [transform] followed by the turn to the library's axes; null stands for no transform at all. */
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
