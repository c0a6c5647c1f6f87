package dev.lazyz.world.camera

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Extent
import dev.lazyz.geometry.Vectors
import org.joml.Vector3d

/** Returns a camera for a given scene and raster shape: a [Camera] itself, or a rule such as [Camera.fit]. */
public fun interface Viewpoint {
    /**
     * Returns the camera for a scene and a raster with the given [aspect]: width divided by height. [extent] tells
     * where the surfaces are.
     */
    public fun camera(extent: Extent, aspect: Double): Camera
}

/**
 * A rule that fits the whole scene into the image, seen from a given direction. Created by [Camera.fit]. The world's y
 * axis is up. Immutable.
 *
 * The projected vertices of all surfaces are in the middle of the image, and the wider of their two extents (width or
 * height, compared with the image) touches the margin, but for the rounding of 64-bit floats. Spheres count with their
 * outline, and surfaces that do not override [Extent.farthest] with their box. Sizes of points and lines in pixels do
 * not count.
 *
 * With perspective, the eye does not come nearer to the scene than about a hundredth of its size. So a needle that
 * points to the eye can be smaller than the margin permits, and with more than about 115 degrees also a box with a
 * corner that does. The same is true for an orthographic camera if the image of the scene is smaller than a
 * hundred-thousandth of its size, as that of a line seen end-on.
 *
 * Cost: all vertices are visited once, a part of them again, see [Extent.farthest]. All of it happens on one thread, so
 * the result does not depend on the number of threads.
 *
 * @property azimuth degrees around the up axis; 0 is the front (+z), 90 is +x
 * @property elevation degrees above the horizon, -90..90
 * @property zoom 1 fills the image except for the margin; larger values show a part, 1e-9..1e9
 * @property kind perspective or orthographic
 * @property margin the part of the image that stays free on each side at zoom 1, percent, 0 or more and below 50
 * @property fieldOfView vertical field of view of a perspective camera at zoom 1, degrees, above 0 and at most
 *   [Camera.MAX_FITTED_FIELD_OF_VIEW]
 */
public class FittedViewpoint internal constructor(
    public val azimuth: Double,
    public val elevation: Double,
    public val zoom: Double,
    public val kind: Fit,
    public val margin: Double,
    public val fieldOfView: Double,
) : Viewpoint {
    override fun camera(extent: Extent, aspect: Double): Camera {
        val up = if (horizontal() < POLE) upAtPole() else Vector3d(0.0, 1.0, 0.0)
        val axes = Camera.orthographic(direction(), Vector3d(), up, 1.0, 0.0, 1.0)
        val seen = ExtentAlong(axes, extent)
        return when (kind) {
            Fit.ORTHOGRAPHIC -> orthographic(seen, up, aspect)
            Fit.PERSPECTIVE -> perspective(seen, up, aspect)
        }
    }

    /** The part of the image between the margins, 0..1. */
    private val filled: Double get() = 1.0 - margin / 50.0

    private fun orthographic(extent: ExtentAlong, up: Vector3d, aspect: Double): Camera {
        val height = maxOf(extent.width / aspect, extent.height, extent.pad / 1000)
        val back = extent.depth / 2 + extent.pad
        val middle = extent.back + extent.depth / 2
        val x = extent.left + extent.width / 2
        val y = extent.bottom + extent.height / 2
        return Camera.orthographic(
            extent.point(x, y, middle + 2 * back), extent.point(x, y, middle), up, height / (filled * zoom),
            back, 3 * back,
        )
    }

    private fun perspective(extent: ExtentAlong, up: Vector3d, aspect: Double): Camera {
        // Where the planes through the margins touch the scene on both sides, the eye is where they meet
        val projection = Projection.Perspective(fieldOfView)
        val slope = projection.halfHeight * filled
        val eyeZ = maxOf(
            extent.apex(extent.right, slope * aspect),
            extent.apex(extent.upward, slope),
            extent.front + 2 * extent.pad,
        )
        val x = extent.middle(extent.right, eyeZ)
        val y = extent.middle(extent.upward, eyeZ)
        val near = eyeZ - extent.front - extent.pad
        val far = eyeZ - extent.back + extent.pad
        val zoomed = projection.magnified(zoom).verticalFieldOfView
        val target = extent.point(x, y, extent.back + extent.depth / 2)
        return Camera.perspective(extent.point(x, y, eyeZ), target, up, zoomed, near, far)
    }

    /** Direction from the scene to the camera; unit length. */
    private fun direction(): Vector3d {
        val a = azimuth * (StrictMath.PI / 180.0)
        val e = elevation * (StrictMath.PI / 180.0)
        val horizontal = horizontal()
        return Vector3d(StrictMath.sin(a) * horizontal, StrictMath.sin(e), StrictMath.cos(a) * horizontal)
    }

    /** The horizontal part of the [direction]: the cosine of the elevation. */
    private fun horizontal(): Double = StrictMath.cos(elevation * (StrictMath.PI / 180.0))

    /** Up direction for a view from (almost) straight above or below: the horizontal direction given by the azimuth. */
    private fun upAtPole(): Vector3d {
        val a = azimuth * (StrictMath.PI / 180.0)
        val sign = if (elevation > 0) -1.0 else 1.0
        return Vector3d(StrictMath.sin(a) * sign, 0.0, StrictMath.cos(a) * sign)
    }

    /** Returns this rule with another direction around the up axis, degrees. */
    public fun withAzimuth(azimuth: Double): FittedViewpoint = copy(azimuth = azimuth)

    /** Returns this rule with another direction above the horizon, degrees, -90..90. */
    public fun withElevation(elevation: Double): FittedViewpoint = copy(elevation = elevation)

    /** Returns this rule with another zoom, 1e-9..1e9. */
    public fun withZoom(zoom: Double): FittedViewpoint = copy(zoom = zoom)

    /** Returns this rule with another projection. */
    public fun withKind(kind: Fit): FittedViewpoint = copy(kind = kind)

    /** Returns this rule with another margin, percent, 0 or more and below 50. */
    public fun withMargin(margin: Double): FittedViewpoint = copy(margin = margin)

    /**
     * Returns this rule with another vertical field of view, degrees, above 0 and at most
     * [Camera.MAX_FITTED_FIELD_OF_VIEW].
     */
    public fun withFieldOfView(fieldOfView: Double): FittedViewpoint = copy(fieldOfView = fieldOfView)

    private fun copy(
        azimuth: Double = this.azimuth,
        elevation: Double = this.elevation,
        zoom: Double = this.zoom,
        kind: Fit = this.kind,
        margin: Double = this.margin,
        fieldOfView: Double = this.fieldOfView,
    ): FittedViewpoint = Camera.fit(azimuth, elevation, zoom, kind, margin, fieldOfView)

    override fun toString(): String = "FittedViewpoint(azimuth=$azimuth, elevation=$elevation, zoom=$zoom, $kind, " +
        "margin=$margin, fieldOfView=$fieldOfView)"

    /** The projection of a fitted camera, see [Camera.fit]. */
    public enum class Fit {
        /** Perspective. */
        PERSPECTIVE,

        /** Orthographic. */
        ORTHOGRAPHIC,
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
         * All three axes have the same length in an orthographic picture: the tangent of the elevation is the square
         * root of one half.
         */
        ISO(45.0, 35.264389682754654),
    }

    public companion object {
        /**
         * Returns a rule that shows the whole scene from the side from which [viewpoint] shows it, with the same kind
         * of projection: [viewpoint] itself if it is fitted; from the direction of a [Camera]; or the usual one.
         */
        @JvmStatic
        public fun like(viewpoint: Viewpoint): FittedViewpoint {
            if (viewpoint is FittedViewpoint) return viewpoint
            if (viewpoint !is Camera) return Camera.fit()

            // The third row of the view matrix points from the scene to the eye
            val view = viewpoint.viewMatrix()
            return Camera.fit(
                StrictMath.toDegrees(StrictMath.atan2(view.m02(), view.m22())),
                StrictMath.toDegrees(StrictMath.asin(view.m12().coerceIn(-1.0, 1.0))).coerceIn(-90.0, 90.0),
                kind = if (viewpoint.projection is Projection.Perspective) Fit.PERSPECTIVE else Fit.ORTHOGRAPHIC,
            )
        }

        /** Horizontal part of the direction below which the y axis does not say reliably what is up in the image. */
        private const val POLE = 1e-5
    }
}

/**
 * Where a scene is, along the axes of a camera: x to the right, y up, z toward the viewer. Coordinates are relative to
 * the centre of the scene's box. An empty scene counts as a box of size 1.
 *
 * @param axes a camera, of which only the directions are used
 */
internal class ExtentAlong(axes: Camera, private val extent: Extent) {
    private val box = extent.bounds ?: UNIT_BOX
    private val center = box.center

    val right = axes.right
    val upward = axes.upward
    private val backward = axes.backward

    val left = -most(right, -1.0)
    val bottom = -most(upward, -1.0)
    val back = -most(backward, -1.0)
    val front = most(backward, 1.0)
    val width = most(right, 1.0) - left
    val height = most(upward, 1.0) - bottom
    val depth = front - back

    /** Distance between the near or far plane and the scene. */
    val pad: Double = pad(maxOf(width, height, depth) / 2)

    /** Returns the point of world space with these coordinates. */
    fun point(x: Double, y: Double, z: Double): Vector3d = Vector3d(
        center.x + right.x * x + upward.x * y + backward.x * z,
        center.y + right.y * x + upward.y * y + backward.y * z,
        center.z + right.z * x + upward.z * y + backward.z * z,
    )

    /**
     * Returns the z at which two planes meet that touch the scene on both sides. Both lean inward toward the viewer, by
     * [slope] along the axis [across] for a distance of 1.
     */
    fun apex(across: Vector3d, slope: Double): Double {
        val plus = farthest(across, 1.0, slope)
        val minus = farthest(across, -1.0, slope)
        return ((plus.across - minus.across) / slope + plus.z + minus.z) / 2
    }

    /**
     * Returns the coordinate along the axis [across] of an eye at [eyeZ], in front of the scene, for which the scene
     * extends equally far to both sides in the image.
     *
     * Planes of some slope that touch the scene on both sides meet at a z that falls when the slope rises, see [apex].
     * Newton's method finds the slope at which it is [eyeZ]: for the two points that are touched, the equation is
     * linear. It starts with too small a slope; the function is convex, so the slope rises from step to step and never
     * exceeds the solution. A scene with finitely many vertices has finitely many pairs of points, so it ends.
     */
    fun middle(across: Vector3d, eyeZ: Double): Double {
        var slope = 0.0
        while (true) {
            val plus = farthest(across, 1.0, slope)
            val minus = farthest(across, -1.0, slope)
            val next = (plus.across - minus.across) / (2 * eyeZ - plus.z - minus.z)
            if (!(next - slope > ROUNDING * next)) return (plus.across + minus.across + slope * (plus.z - minus.z)) / 2
            slope = next
        }
    }

    /** A point of the scene: its coordinate along an axis of the image, and its z. */
    private class Touched(val across: Double, val z: Double)

    /** Returns the point that is farthest along [sign] times [across] plus [slope] times backward. */
    private fun farthest(across: Vector3d, sign: Double, slope: Double): Touched {
        val point = farthest(
            Vector3d(
                sign * across.x + slope * backward.x,
                sign * across.y + slope * backward.y,
                sign * across.z + slope * backward.z,
            ),
        )
        return Touched(Vectors.dot(across, point), Vectors.dot(backward, point))
    }

    /** Returns the greatest coordinate along [sign] times [axis]. */
    private fun most(axis: Vector3d, sign: Double): Double =
        sign * Vectors.dot(axis, farthest(Vector3d(sign * axis.x, sign * axis.y, sign * axis.z)))

    private fun farthest(direction: Vector3d): Vector3d {
        val point = extent.farthest(direction) ?: box.farthest(direction)
        return Vectors.minus(point, center)
    }

    private fun pad(halfSize: Double): Double {
        val away = maxOf(StrictMath.abs(center.x), StrictMath.abs(center.y), StrictMath.abs(center.z))

        // A single point has no size: use a small positive one, because a camera needs near < far
        return if (halfSize > 0.0) halfSize * 0.01 + 1e-12 * away else 1e-6 * maxOf(away, 1e-6)
    }

    private companion object {
        /** A step of Newton's method that is smaller, relative to the slope, is due to rounding. */
        const val ROUNDING = 1e-15

        val UNIT_BOX = Box(-0.5, -0.5, -0.5, 0.5, 0.5, 0.5)
    }
}
