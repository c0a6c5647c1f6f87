package dev.lazyz.world

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Transforms
import dev.lazyz.geometry.Vectors
import org.joml.Matrix4d
import org.joml.Vector3d
import org.joml.Vector3dc

/** How space is flattened. */
public sealed class Projection {
    /**
     * Things far away look smaller.
     *
     * @property verticalFieldOfView angle between the top and the bottom of the picture, degrees, above 0 and below 180
     */
    public class Perspective(public val verticalFieldOfView: Double) : Projection() {
        init {
            require(verticalFieldOfView > 0.0 && verticalFieldOfView < 180.0) {
                "verticalFieldOfView must be between 0 and 180 degrees: $verticalFieldOfView"
            }
        }

        override fun toString(): String = "Perspective($verticalFieldOfView)"
    }

    /**
     * Things look the same size at any distance.
     *
     * @property height height of the visible part of space, in world units, above 0
     */
    public class Orthographic(public val height: Double) : Projection() {
        init {
            require(height > 0.0 && height.isFinite()) { "height must be positive: $height" }
        }

        override fun toString(): String = "Orthographic($height)"
    }

    /** None: world space is the raster already, see [Camera.screen]. */
    public object Screen : Projection() {
        override fun toString(): String = "Screen"
    }
}

/**
 * Chooses a camera once the shape of the raster is known: a [Camera] itself, or a rule such as [Camera.fit].
 */
public fun interface Viewpoint {
    /**
     * Returns the camera for a scene within [bounds] (null when the scene is empty) and a raster [aspect] times as wide
     * as it is high.
     */
    public fun camera(bounds: Box?, aspect: Double): Camera
}

/**
 * A place to look from, in right-handed world space.
 *
 * Camera space has x to the right, y up, and looks along -z. Only what lies between the [near] and the [far] plane is
 * seen; both are distances from the eye along the line of sight. Immutable and thread safe.
 *
 * Every number is computed with [StrictMath] and plain products, so a camera is the same bits on every machine.
 *
 * @property projection with perspective or without
 * @property near distance of the near plane from the eye, along the line of sight
 * @property far distance of the far plane from the eye, along the line of sight
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
    /** Where the camera is, world space. */
    public val eye: Vector3dc = Vector3d(eye)

    /** A point in the middle of the picture, world space; only its direction from the eye matters. */
    public val target: Vector3dc = Vector3d(target)

    /** Roughly the direction that is up in the picture, as it was given. */
    public val up: Vector3dc = Vector3d(up)

    /** From the target to the eye; unit length. */
    internal val backward: Vector3d

    /** To the right of the picture; unit length. */
    internal val right: Vector3d

    /** To the top of the picture; unit length. */
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

        // Looking along the up vector leaves the roll open: take the axis that is least along the line of sight
        val isRollOpen = Vectors.dot(side, side) < 1e-12
        return Vectors.unit(if (isRollOpen) Vectors.cross(leastAxis(backward), backward) else side, "right")
    }

    override fun camera(bounds: Box?, aspect: Double): Camera = this

    /** Returns the matrix from world space to camera space; a new matrix at each call. */
    public fun viewMatrix(): Matrix4d = Matrix4d().set(viewElements())

    private fun viewElements(): DoubleArray = doubleArrayOf(
        right.x, upward.x, backward.x, 0.0,
        right.y, upward.y, backward.y, 0.0,
        right.z, upward.z, backward.z, 0.0,
        -Vectors.dot(right, eye), -Vectors.dot(upward, eye), -Vectors.dot(backward, eye), 1.0,
    )

    /**
     * Returns the matrix from camera space to clip space, -w..w on each axis, near at -w, for a raster [aspect] times as
     * wide as it is high; a new matrix at each call.
     *
     * @throws IllegalStateException for [Projection.Screen], whose scale is the raster's size and not its shape
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
     * Returns the matrix from world space to what set-up clips and snaps: clip space, or, for [Projection.Screen],
     * pixels and the fraction of the way from near to far. There it multiplies by 1 and adds 0: nothing is rounded.
     */
    internal fun setUpMatrix(aspect: Double): SetUpMatrix {
        if (projection != Projection.Screen) {
            return SetUpMatrix(Transforms.product(projectionElements(aspect), viewElements()))
        }
        val depth = far - near
        return SetUpMatrix(
            doubleArrayOf(
                1.0, 0.0, 0.0, 0.0,
                0.0, 1.0, 0.0, 0.0,
                0.0, 0.0, 1.0 / depth, 0.0,
                0.0, 0.0, -near / depth, 1.0,
            ),
        )
    }

    /** Returns the world-space direction of a camera-space direction; not normalised. */
    public fun toWorldDirection(x: Double, y: Double, z: Double): Vector3d = Vector3d(
        right.x * x + upward.x * y + backward.x * z,
        right.y * x + upward.y * y + backward.y * z,
        right.z * x + upward.z * y + backward.z * z,
    )

    /** Returns this camera as it is seen from [origin]; it looks the same way, even where eye and target become one. */
    internal fun relativeTo(origin: Vector3dc): Camera = if (Vectors.isZero(origin)) {
        this
    } else {
        Camera(Vectors.minus(eye, origin), Vectors.minus(target, origin), up, projection, near, far, this)
    }

    /** Half the visible height: at distance 1 under perspective, anywhere without. Of no meaning on the screen. */
    internal fun halfHeight(): Double = when (projection) {
        is Projection.Perspective -> StrictMath.tan(projection.verticalFieldOfView * (StrictMath.PI / 360.0))
        is Projection.Orthographic -> projection.height / 2
        Projection.Screen -> 1.0
    }

    override fun toString(): String = "Camera(eye=$eye, backward=$backward, $projection, $near..$far)"

    public companion object {
        /** Field of view that [fit] uses, degrees. */
        public const val DEFAULT_FIELD_OF_VIEW: Double = 30.0

        /**
         * Returns a camera at [eye] that looks at [target] with perspective.
         *
         * @param up roughly the direction that is up in the picture; when it is the line of sight, an axis is chosen
         * @param verticalFieldOfView degrees
         * @throws IllegalArgumentException if [eye] is [target], or unless 0 < [near] < [far]
         */
        @JvmStatic
        public fun perspective(
            eye: Vector3dc,
            target: Vector3dc,
            up: Vector3dc,
            verticalFieldOfView: Double,
            near: Double,
            far: Double,
        ): Camera = Camera(eye, target, up, Projection.Perspective(verticalFieldOfView), near, far)

        /**
         * Returns a camera at [eye] that looks at [target] without perspective; the picture is [height] world units high.
         *
         * @throws IllegalArgumentException if [eye] is [target], or unless [near] < [far]
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
         * Returns a camera for scenes that are given on the screen: x and y of the world are pixels, x to the right and
         * y downward from the raster's upper left corner (the sample of pixel (0, 0) is at (0.5, 0.5)), and z is depth,
         * which grows away from the viewer. Positions are snapped as they are, without a product or a sum before.
         *
         * With the usual planes z is the fraction of the range of depths, as [FrameBuilder] takes it, and polygons have
         * the same bits; but what lies before the near plane, behind the far one or outside the guard band is clipped.
         * Planes in pixels, say -100 and 100, make room for spheres.
         *
         * @throws IllegalArgumentException unless [near] < [far]
         */
        @JvmStatic
        @JvmOverloads
        public fun screen(near: Double = 0.0, far: Double = 1.0): Camera =
            Camera(Vector3d(), Vector3d(0.0, 0.0, 1.0), Vector3d(0.0, -1.0, 0.0), Projection.Screen, near, far)

        /**
         * Returns a rule that frames the whole scene, whatever its size and the raster's shape.
         *
         * @param azimuth degrees around the up axis; 0 looks at the front (from +z when y is up), 90 from +x
         * @param elevation degrees above the horizon, -90..90
         * @param zoom 1 fills the picture but for a margin of 5 percent; 2 shows half as much
         * @param kind with perspective or without
         */
        @JvmStatic
        @JvmOverloads
        public fun fit(
            azimuth: Double = 30.0,
            elevation: Double = 20.0,
            zoom: Double = 1.0,
            kind: Fit = Fit.PERSPECTIVE,
        ): FittedViewpoint {
            require(azimuth.isFinite()) { "azimuth must be finite: $azimuth" }
            require(elevation in -90.0..90.0) { "elevation must be in -90..90 degrees: $elevation" }
            require(zoom > 0.0 && zoom.isFinite()) { "zoom must be positive: $zoom" }
            return FittedViewpoint(azimuth, elevation, zoom, kind)
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

/** The projection of a fitted camera, see [Camera.fit]. */
public enum class Fit {
    /** With perspective, [Camera.DEFAULT_FIELD_OF_VIEW] degrees high. */
    PERSPECTIVE,

    /** Without perspective. */
    ORTHOGRAPHIC,
}
