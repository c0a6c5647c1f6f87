package dev.lazyz.world

import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.material.OcclusionMap
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * How much of the light from all sides reaches a point. [Scene.withAmbientVisibility] multiplies ambient light and the
 * [Environment] by it, like an [OcclusionMap] (contract rule 6.13). `AmbientOcclusion` computes it from the shapes of a
 * scene.
 *
 * Must be a pure function with the arithmetic of contract rule 6.3, and thread safe: it is called for each shaded
 * sample, by any thread, in any order.
 */
public fun interface AmbientVisibility {
    /**
     * Returns the part of the light that reaches a point, 0..1.
     *
     * @param x the point in world space, relative to [Scene.origin]; the same for [y] and [z]
     * @param normalX the normal at the point, unit length, on the viewer's side; the same for [normalY] and [normalZ]
     */
    public fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float
}

/**
 * A [visibility] in a scene that was rotated so that the axis [up] became y.
 *
 * @property shift origin of the rotated scene, relative to that of the scene before, in the space before
 */
internal class TurnedVisibility(
    private val visibility: AmbientVisibility,
    private val up: UpAxis,
    private val shift: Vector3dc,
) : AmbientVisibility {
    override fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float {
        val point = up.toModel(Vector3d(x.toDouble(), y.toDouble(), z.toDouble())).add(shift)
        val normal = up.toModel(Vector3d(normalX.toDouble(), normalY.toDouble(), normalZ.toDouble()))
        return visibility.at(
            point.x.toFloat(), point.y.toFloat(), point.z.toFloat(),
            normal.x.toFloat(), normal.y.toFloat(), normal.z.toFloat(),
        )
    }
}
