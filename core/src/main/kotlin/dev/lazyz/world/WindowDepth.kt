package dev.lazyz.world

/**
 * Returns the window depth of a point at [distance] from the eye along the line of sight: 0 at the near plane, 1 at the
 * far plane. Under perspective it is not proportional to the distance (contract rule 4.2).
 */
internal fun Camera.unitAt(distance: Double): Double =
    if (projection is Projection.Perspective) {
        far * (distance - near) / ((far - near) * distance)
    } else {
        (distance - near) / (far - near)
    }

/** Returns the distance from the eye along the line of sight at which [unitAt] is [unit], 0..1. */
internal fun Camera.distanceAt(unit: Double): Double =
    if (projection is Projection.Perspective) {
        far * near / (far - unit * (far - near))
    } else {
        near + unit * (far - near)
    }
