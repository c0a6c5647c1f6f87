package dev.lazyz.shading.light

import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import kotlin.math.sqrt

/** The directions that light depends on, at each point of a scene. Immutable and thread safe. */
internal class Viewer(camera: Camera) {
    @JvmField val isPerspective: Boolean = camera.projection is Projection.Perspective

    @JvmField val eyeX: Float = camera.eye.x().toFloat()

    @JvmField val eyeY: Float = camera.eye.y().toFloat()

    @JvmField val eyeZ: Float = camera.eye.z().toFloat()

    @JvmField val backX: Float

    @JvmField val backY: Float

    @JvmField val backZ: Float

    init {
        val back = camera.toWorldDirection(0.0, 0.0, 1.0)
        backX = back.x.toFloat()
        backY = back.y.toFloat()
        backZ = back.z.toFloat()
    }

    /**
     * Passes two unit vectors at the point ([px], [py], [pz]) to [use]: that to the viewer, and the normal. The given
     * normal can have any length; one of length 0 is replaced by the direction to the viewer (contract rule 6.5).
     */
    inline fun from(
        px: Float,
        py: Float,
        pz: Float,
        normalX: Float,
        normalY: Float,
        normalZ: Float,
        use: (vx: Float, vy: Float, vz: Float, nx: Float, ny: Float, nz: Float) -> Unit,
    ) {
        var vx = backX
        var vy = backY
        var vz = backZ
        if (isPerspective) {
            vx = eyeX - px
            vy = eyeY - py
            vz = eyeZ - pz
            val distance = sqrt(vx * vx + vy * vy + vz * vz)
            vx /= distance
            vy /= distance
            vz /= distance
        }
        val length = sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ)
        val nx = if (length > 0f) normalX / length else vx
        val ny = if (length > 0f) normalY / length else vy
        val nz = if (length > 0f) normalZ / length else vz
        use(vx, vy, vz, nx, ny, nz)
    }
}
