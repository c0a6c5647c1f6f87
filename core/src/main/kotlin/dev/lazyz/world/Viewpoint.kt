package dev.lazyz.world

import dev.lazyz.geometry.Box

/** Returns a camera for a given scene and raster shape: a [Camera] itself, or a rule such as [Camera.fit]. */
public fun interface Viewpoint {
    /**
     * Returns the camera for a scene with the given [bounds] (null if the scene is empty) and a raster with the given
     * [aspect]: width divided by height.
     */
    public fun camera(bounds: Box?, aspect: Double): Camera
}
