package dev.lazyz.world.camera

import dev.lazyz.geometry.Extent

/** Returns a camera for a given scene and raster shape: a [Camera] itself, or a rule such as [Camera.fit]. */
public fun interface Viewpoint {
    /**
     * Returns the camera for a scene and a raster with the given [aspect]: width divided by height. [extent] tells
     * where the surfaces are.
     */
    public fun camera(extent: Extent, aspect: Double): Camera
}

/**
 * The named sides from which to look at a scene, for example `Camera.fit(view.azimuth, view.elevation)`.
 *
 * @property azimuth degrees around the up axis, as for [Camera.fit]
 * @property elevation degrees above the horizon, as for [Camera.fit]
 */
public enum class View(public val azimuth: Double, public val elevation: Double) {
    /** From +z. */
    FRONT(0.0, 0.0),

    /** From -z. */
    BACK(180.0, 0.0),

    /** From -x. */
    LEFT(-90.0, 0.0),

    /** From +x. */
    RIGHT(90.0, 0.0),

    /** From above; the front is below in the picture. */
    TOP(0.0, 90.0),

    /** From below; the front is above in the picture. */
    BOTTOM(0.0, -90.0),

    /**
     * All three axes have the same length in an orthographic picture: the tangent of the elevation is the square root
     * of one half.
     */
    ISO(45.0, 35.264389682754654),
}
