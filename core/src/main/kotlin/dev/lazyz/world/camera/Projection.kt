package dev.lazyz.world.camera

/** How camera space is projected to the image plane. */
public sealed class Projection {
    /**
     * Perspective: distant objects look smaller.
     *
     * @property verticalFieldOfView angle between the top and the bottom of the image, degrees, above 0 and below 180
     * @throws IllegalArgumentException if [verticalFieldOfView] is out of range
     */
    public class Perspective(public val verticalFieldOfView: Double) : Projection() {
        init {
            require(verticalFieldOfView > 0.0 && verticalFieldOfView < 180.0) {
                "verticalFieldOfView must be between 0 and 180 degrees: $verticalFieldOfView"
            }
        }

        /** Half the visible height at distance 1. */
        public val halfHeight: Double get() = StrictMath.tan(verticalFieldOfView * (StrictMath.PI / 360.0))

        /** Returns the projection that shows everything [zoom] times as large: at 1, exactly this one. */
        public fun magnified(zoom: Double): Perspective =
            if (zoom == 1.0) this else Perspective(StrictMath.atan(halfHeight / zoom) * (360.0 / StrictMath.PI))

        override fun toString(): String = "Perspective($verticalFieldOfView)"
    }

    /**
     * Orthographic: objects have the same size at any distance.
     *
     * @property height height of the visible part of space, world units, above 0
     * @throws IllegalArgumentException if [height] is not positive and finite
     */
    public class Orthographic(public val height: Double) : Projection() {
        init {
            require(height > 0.0 && height.isFinite()) { "height must be positive: $height" }
        }

        override fun toString(): String = "Orthographic($height)"
    }

    /** No projection: world space is already raster space, see [Camera.screen]. */
    public object Screen : Projection() {
        override fun toString(): String = "Screen"
    }
}

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

/**
 * The matrix of [Camera.clipMatrix]. Elements are named as in JOML: column, then row. It does not use JOML, because
 * loading JOML's matrix class takes longer than setting up a small image.
 *
 * @param elements 16 elements, column by column
 */
internal class ClipMatrix(elements: DoubleArray) {
    val m00: Double = elements[0]
    val m01: Double = elements[1]
    val m02: Double = elements[2]
    val m03: Double = elements[3]
    val m10: Double = elements[4]
    val m11: Double = elements[5]
    val m12: Double = elements[6]
    val m13: Double = elements[7]
    val m20: Double = elements[8]
    val m21: Double = elements[9]
    val m22: Double = elements[10]
    val m23: Double = elements[11]
    val m30: Double = elements[12]
    val m31: Double = elements[13]
    val m32: Double = elements[14]
    val m33: Double = elements[15]
}
