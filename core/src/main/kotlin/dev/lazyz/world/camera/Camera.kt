package dev.lazyz.world.camera

import dev.lazyz.geometry.Extent
import dev.lazyz.geometry.Transforms
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.camera.FittedViewpoint.Fit
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A camera in right-handed world space.
 *
 * In camera space, x is to the right, y is up, and the camera looks along -z. Only what is between the [near] and the
 * [far] plane is visible. Both are distances from the eye along the line of sight, in world units. Immutable and thread
 * safe.
 *
 * All numbers are computed with [StrictMath] and plain products, so a camera is equal bit for bit on every machine.
 *
 * @property projection perspective, orthographic or none
 * @property near distance of the near plane from the eye along the line of sight, world units
 * @property far distance of the far plane from the eye along the line of sight, world units
 */
public class Camera private constructor(
    eye: Vector3dc,
    target: Vector3dc,
    up: Vector3dc,
    public val projection: Projection,
    public val near: Double,
    public val far: Double,
    moved: Camera? = null,
) : Viewpoint {
    /** Position of the camera, world space. */
    public val eye: Vector3dc = Vector3d(eye)

    /**
     * The point that the camera looks at: the centre of the image, world space. Only its direction from the eye
     * matters.
     */
    public val target: Vector3dc = Vector3d(target)

    /** Approximate up direction of the image, as given to the constructor. */
    public val up: Vector3dc = Vector3d(up)

    /** Direction from the target to the eye; unit length. */
    internal val backward: Vector3d

    /** Direction to the right of the image; unit length. */
    internal val right: Vector3d

    /** Direction to the top of the image; unit length. */
    internal val upward: Vector3d

    init {
        require(moved != null || (Vectors.isFinite(eye) && Vectors.isFinite(target))) {
            "eye and target must be finite: $eye, $target"
        }
        require(far > near && far.isFinite() && near.isFinite()) { "near must be less than far: $near, $far" }
        require(projection !is Projection.Perspective || near > 0.0) {
            "near must be positive under perspective: $near"
        }
        backward = moved?.backward
            ?: Vectors.unit(Vector3d(eye.x() - target.x(), eye.y() - target.y(), eye.z() - target.z()), "line of sight")
        right = moved?.right ?: rightOf(Vectors.unit(up, "up"))
        upward = Vectors.cross(backward, right)
    }

    private fun rightOf(up: Vector3d): Vector3d {
        val side = Vectors.cross(up, backward)

        // If the line of sight is parallel to up, the roll is undefined: use the axis with the smallest component along
        // it
        val isRollOpen = Vectors.dot(side, side) < 1e-12
        return Vectors.unit(if (isRollOpen) Vectors.cross(leastAxis(backward), backward) else side, "right")
    }

    override fun camera(extent: Extent, aspect: Double): Camera = this

    /** Returns the matrix from world space to camera space; a new matrix for each call. */
    public fun viewMatrix(): Matrix4d = Matrix4d().set(viewElements())

    private fun viewElements(): DoubleArray = doubleArrayOf(
        right.x, upward.x, backward.x, 0.0,
        right.y, upward.y, backward.y, 0.0,
        right.z, upward.z, backward.z, 0.0,
        -Vectors.dot(right, eye), -Vectors.dot(upward, eye), -Vectors.dot(backward, eye), 1.0,
    )

    /**
     * Returns the matrix from camera space to clip space, for a raster with the given [aspect] (width divided by
     * height). In clip space, visible x, y and z are in -w..w, and the near plane is at z = -w. A new matrix for each
     * call.
     *
     * @throws IllegalArgumentException if [aspect] is not positive and finite
     * @throws IllegalStateException for [Projection.Screen], which has no projection matrix: its scale depends on the
     *   size of the raster, not only on its shape
     */
    public fun projectionMatrix(aspect: Double): Matrix4d = Matrix4d().set(projectionElements(aspect))

    private fun projectionElements(aspect: Double): DoubleArray {
        require(aspect > 0.0 && aspect.isFinite()) { "aspect must be positive: $aspect" }
        val depth = far - near
        return when (projection) {
            is Projection.Perspective -> {
                val scale = 1.0 / halfHeight()
                doubleArrayOf(
                    scale / aspect, 0.0, 0.0, 0.0,
                    0.0, scale, 0.0, 0.0,
                    0.0, 0.0, -(far + near) / depth, -1.0,
                    0.0, 0.0, -2.0 * far * near / depth, 0.0,
                )
            }
            is Projection.Orthographic -> {
                val scale = 1.0 / halfHeight()
                doubleArrayOf(
                    scale / aspect, 0.0, 0.0, 0.0,
                    0.0, scale, 0.0, 0.0,
                    0.0, 0.0, -2.0 / depth, 0.0,
                    0.0, 0.0, -(far + near) / depth, 1.0,
                )
            }
            Projection.Screen -> error("a screen camera has no projection matrix")
        }
    }

    /**
     * Returns the matrix from world space to the space in which set-up clips and snaps: clip space. For
     * [Projection.Screen] it is pixels, and the fraction of the distance from near to far; x and y are then multiplied
     * by 1 and summed with 0, so they are not rounded.
     */
    internal fun clipMatrix(aspect: Double): ClipMatrix {
        if (projection != Projection.Screen) {
            return ClipMatrix(Transforms.product(projectionElements(aspect), viewElements()))
        }
        val depth = far - near
        return ClipMatrix(
            doubleArrayOf(
                1.0, 0.0, 0.0, 0.0,
                0.0, 1.0, 0.0, 0.0,
                0.0, 0.0, 1.0 / depth, 0.0,
                0.0, 0.0, -near / depth, 1.0,
            ),
        )
    }

    /** Converts a direction from camera space to world space. The result is a new vector and is not normalised. */
    public fun toWorldDirection(x: Double, y: Double, z: Double): Vector3d = Vector3d(
        right.x * x + upward.x * y + backward.x * z,
        right.y * x + upward.y * y + backward.y * z,
        right.z * x + upward.z * y + backward.z * z,
    )

    /**
     * Returns this camera relative to [origin]. Its direction is unchanged, even if eye and target round to the same
     * point.
     */
    internal fun relativeTo(origin: Vector3dc): Camera = if (Vectors.isZero(origin)) {
        this
    } else {
        Camera(Vectors.minus(eye, origin), Vectors.minus(target, origin), up, projection, near, far, this)
    }

    /**
     * Returns this camera with other planes. The picture of what is between them stays the same, its depths change.
     *
     * @param near distance of the near plane from the eye along the line of sight, world units
     * @param far distance of the far plane, world units
     * @throws IllegalArgumentException if not [near] < [far], or [near] is not positive under perspective
     */
    public fun withPlanes(near: Double, far: Double): Camera = Camera(eye, target, up, projection, near, far, this)

    /**
     * Returns this camera rotated so that the axis [up] becomes y.
     *
     * @throws UnsupportedOperationException if the projection is [Projection.Screen]
     */
    internal fun withUpAxis(up: UpAxis): Camera {
        if (projection == Projection.Screen) {
            throw UnsupportedOperationException("a scene given on the screen cannot be rotated")
        }
        return Camera(up.toWorld(eye), up.toWorld(target), up.toWorld(upward), projection, near, far)
    }

    /**
     * Half the visible height, world units: at distance 1 for perspective, at any distance for orthographic.
     * Meaningless for [Projection.Screen].
     */
    public fun halfHeight(): Double = when (projection) {
        is Projection.Perspective -> projection.halfHeight
        is Projection.Orthographic -> projection.height / 2
        Projection.Screen -> 1.0
    }

    /** The visible height at a [distance] from the eye along the line of sight, world units; see [halfHeight]. */
    public fun heightAt(distance: Double): Double =
        2 * halfHeight() * (if (projection is Projection.Perspective) distance else 1.0)

    override fun toString(): String = "Camera(eye=$eye, backward=$backward, $projection, $near..$far)"

    public companion object {
        /** Vertical field of view of [fit], degrees. */
        public const val DEFAULT_FIELD_OF_VIEW: Double = 30.0

        /** Widest vertical field of view of [fit], degrees. To fill a wider one, the eye would have to be too near. */
        public const val MAX_FITTED_FIELD_OF_VIEW: Double = 140.0

        /** Margin of [fit] on each side, percent of the width or height of the image. */
        public const val DEFAULT_MARGIN: Double = 5.0

        /**
         * Returns a perspective camera at [eye] that looks at [target].
         *
         * @param up approximate up direction of the image; if it is parallel to the line of sight, a coordinate axis is
         *   used instead
         * @param fieldOfViewDegrees vertical field of view, degrees, above 0 and below 180; `Math.toDegrees` converts
         *   radians
         * @throws IllegalArgumentException if [eye] equals [target], a vector is not finite, [up] is zero,
         *   [fieldOfViewDegrees] is out of range, or not 0 < [near] < [far]
         */
        @JvmStatic
        public fun perspective(
            eye: Vector3dc,
            target: Vector3dc,
            up: Vector3dc,
            fieldOfViewDegrees: Double,
            near: Double,
            far: Double,
        ): Camera = Camera(eye, target, up, Projection.Perspective(fieldOfViewDegrees), near, far)

        /**
         * Returns an orthographic camera at [eye] that looks at [target]. The image is [height] world units high.
         *
         * @throws IllegalArgumentException if [eye] equals [target], a vector is not finite, [up] is zero, [height] is
         *   not positive, or not [near] < [far]
         */
        @JvmStatic
        public fun orthographic(
            eye: Vector3dc,
            target: Vector3dc,
            up: Vector3dc,
            height: Double,
            near: Double,
            far: Double,
        ): Camera = Camera(eye, target, up, Projection.Orthographic(height), near, far)

        /**
         * Returns a camera for scenes that are defined in screen space: x and y are pixels, x to the right and y
         * downward from the upper left corner of the raster (the sample of pixel (0, 0) is at (0.5, 0.5)). z is depth,
         * which increases away from the viewer. Positions are snapped directly, without a preceding product or sum.
         *
         * With the default planes, z is the fraction of the range of depths, as in `FrameBuilder`, and polygons give
         * the same bits. But what is in front of the near plane, behind the far plane or outside the guard band is
         * clipped. Spheres need planes in pixels, for example -100 and 100.
         *
         * @throws IllegalArgumentException unless [near] < [far]
         */
        @JvmStatic
        @JvmOverloads
        public fun screen(near: Double = 0.0, far: Double = 1.0): Camera =
            Camera(Vector3d(), Vector3d(0.0, 0.0, 1.0), Vector3d(0.0, -1.0, 0.0), Projection.Screen, near, far)

        /**
         * Returns a rule that fits the whole scene into the image, for any size of the scene and any shape of the
         * raster. See [FittedViewpoint].
         *
         * @param azimuth degrees around the up axis; 0 looks at the front (from +z, y is up), 90 from +x
         * @param elevation degrees above the horizon, -90..90
         * @param zoom 1e-9..1e9; 1 fills the image except for the margin, 2 shows half as much
         * @param kind perspective or orthographic
         * @param margin the part of the image that stays free on each side at zoom 1, percent of its width or height,
         *   0 or more and below 50
         * @param fieldOfView vertical field of view of a perspective camera at zoom 1, degrees, above 0 and at most
         *   [MAX_FITTED_FIELD_OF_VIEW]; a camera at a given place, [perspective], can have a wider one
         * @throws IllegalArgumentException if a number is out of range or not finite
         */
        @JvmStatic
        @JvmOverloads
        public fun fit(
            azimuth: Double = 30.0,
            elevation: Double = 20.0,
            zoom: Double = 1.0,
            kind: Fit = Fit.PERSPECTIVE,
            margin: Double = DEFAULT_MARGIN,
            fieldOfView: Double = DEFAULT_FIELD_OF_VIEW,
        ): FittedViewpoint {
            require(azimuth.isFinite()) { "azimuth must be finite: $azimuth" }
            require(elevation in -90.0..90.0) { "elevation must be in -90..90 degrees: $elevation" }
            require(zoom in 1e-9..1e9) { "zoom must be in 1e-9..1e9: $zoom" }
            require(margin >= 0.0 && margin < 50.0) { "margin must be 0 or more and below 50 percent: $margin" }
            require(fieldOfView > 0.0 && fieldOfView <= MAX_FITTED_FIELD_OF_VIEW) {
                "fieldOfView of a fitted camera must be above 0 and at most $MAX_FITTED_FIELD_OF_VIEW degrees: " +
                    "$fieldOfView"
            }
            return FittedViewpoint(azimuth, elevation, zoom, kind, margin, fieldOfView)
        }

        private fun leastAxis(v: Vector3dc): Vector3d {
            val x = StrictMath.abs(v.x())
            val y = StrictMath.abs(v.y())
            val z = StrictMath.abs(v.z())
            return when {
                z <= x && z <= y -> Vector3d(0.0, 0.0, 1.0)
                y <= x -> Vector3d(0.0, 1.0, 0.0)
                else -> Vector3d(1.0, 0.0, 0.0)
            }
        }
    }
}
