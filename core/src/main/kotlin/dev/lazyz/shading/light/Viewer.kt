package dev.lazyz.shading.light

import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import kotlin.math.sqrt

/** The direction to the viewer, for each point of a scene. Immutable and thread safe. */
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

    /** Passes the unit vector from the point ([px], [py], [pz]) to the viewer to [use]. */
    inline fun from(px: Float, py: Float, pz: Float, use: (Float, Float, Float) -> Unit) {
        var vx = backX
        var vy = backY
        var vz = backZ
        if (isPerspective) {
            vx = eyeX - px
            vy = eyeY - py
            vz = eyeZ - pz
            val length = sqrt(vx * vx + vy * vy + vz * vz)
            vx /= length
            vy /= length
            vz /= length
        }
        use(vx, vy, vz)
    }
}
