package dev.lazyz.cli.input

import dev.lazyz.scenes.TurntableCamera
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Viewpoint

/**
 * A turn of one input around the up axis, in [steps] equal steps. Remembers how the camera sees the scene from all of
 * them, so that it is computed once. Not thread safe.
 */
internal class Turns(val steps: Int) {
    private var camera: TurntableCamera? = null

    /** Returns the step with this number, from 0. */
    fun step(number: Int) = Turn { start ->
        Viewpoint { scene, aspect ->
            (camera ?: TurntableCamera(scene, aspect, steps, start).also { camera = it }).at(number)
        }
    }
}

/** A step of a turn. */
internal fun interface Turn {
    /** Returns the camera of [start], turned, from the same distance in all steps. */
    fun viewpoint(start: FittedViewpoint): Viewpoint
}
