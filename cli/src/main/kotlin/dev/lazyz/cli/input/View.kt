package dev.lazyz.cli.input

import dev.lazyz.world.Camera

/** The named sides to look from. Angles are in degrees, as for [Camera.fit]. */
internal enum class View(val azimuth: Double, val elevation: Double) {
    FRONT(0.0, 0.0),
    BACK(180.0, 0.0),
    LEFT(-90.0, 0.0),
    RIGHT(90.0, 0.0),
    TOP(0.0, 90.0),
    BOTTOM(0.0, -90.0),

    /**
     * All three axes have the same length in the picture: the tangent of the elevation is the square root of one half.
     */
    ISO(45.0, 35.264389682754654),
}
