package dev.lazyz.world

/** Returns a camera for a given scene and raster shape: a [Camera] itself, or a rule such as [Camera.fit]. */
public fun interface Viewpoint {
    /**
     * Returns the camera for [scene] and a raster with the given [aspect]: width divided by height. [Scene.bounds] and
     * [Scene.farthest] tell where the surfaces are.
     */
    public fun camera(scene: Scene, aspect: Double): Camera
}
