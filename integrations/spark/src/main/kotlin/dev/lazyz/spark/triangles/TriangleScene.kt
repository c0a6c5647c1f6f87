package dev.lazyz.spark.triangles

import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Surface
import java.io.Serializable

/**
 * Makes the scene around triangles: their material, the axis that points up, lights, a background, a viewpoint. It is
 * sent to all executors, and called with some of the triangles at a time; so its result must be the same for all, apart
 * from them. In Kotlin and Java it can be a lambda:
 *
 * ```
 * TriangleScene { triangles -> Scene(listOf(triangles)).withUpAxis(UpAxis.Z) }
 * ```
 *
 * The scene must have this one surface, which may have another material and another axis up, but not other triangles.
 * It must be opaque.
 */
public fun interface TriangleScene : Serializable {
    /** Returns the scene of some [triangles]. */
    public fun scene(triangles: Surface): Scene
}
