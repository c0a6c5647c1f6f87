package dev.lazyz.scenes.pictures

import dev.lazyz.RenderOptions
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Extent
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.Viewpoint
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Pictures of a model from all around it, as `zcli render --turntable` makes them. Created by
 * [PictureSettings.turntable].
 *
 * ```
 * val turntable = PictureSettings(320, 240).turntable(Scenes.load(path), steps = 36)
 * val pictures = List(turntable.steps) { turntable.frame(it).render(TiledRenderer()) }
 * ```
 *
 * Frames can be made and rendered in any order and by several threads. The distance of the camera is computed for the
 * first of them, and kept. Thread safe.
 *
 * @property steps number of pictures
 */
public class Turntable internal constructor(
    private val settings: PictureSettings,
    private val loaded: LoadedScene,
    public val steps: Int,
) {
    @Volatile
    private var camera: TurntableCamera? = null

    init {
        require(steps >= 1) { "steps must be at least 1: $steps" }
    }

    /**
     * Sets up the picture with this number: 0 is the side of the settings, the next ones are from farther right.
     *
     * @param options the threads of set-up
     * @param observer is told what happens
     * @throws IllegalArgumentException if [step] is not in 0 until [steps]
     * @throws NoPictureException as [PictureSettings.frame], or if the scene is given on the screen
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(
        step: Int,
        options: RenderOptions = RenderOptions(),
        observer: PictureObserver = PictureObserver(),
    ): PictureFrame = PictureSteps(settings, loaded, options, observer).frame { start ->
        Viewpoint { extent, aspect ->
            (camera ?: TurntableCamera(extent, aspect, steps, start).also { camera = it }).at(step)
        }
    }

    override fun toString(): String = "Turntable($steps steps, $settings)"
}

/**
 * The cameras of a turn around a scene, in equal steps: always at the same distance from one point of the up axis,
 * which goes through the middle of the scene's box. From the nearest step the scene touches a margin, and no step shows
 * more than the picture. [Turntable] uses it for models with their settings.
 *
 * Cost: two times as many fitted cameras as there are [steps], once. Immutable and thread safe.
 *
 * @param scene the scene, or another extent, in which y points up; it is not kept
 * @param aspect width of the pictures divided by their height
 * @property steps number of steps, at least 1
 * @param start the side at which the turn begins, the projection, the margin and the zoom
 * @throws IllegalArgumentException if [steps] is below 1, or [aspect] is not above 0
 */
public class TurntableCamera @JvmOverloads constructor(
    scene: Extent,
    aspect: Double,
    public val steps: Int,
    private val start: FittedViewpoint = Camera.fit(),
) {
    init {
        require(steps >= 1) { "steps must be at least 1: $steps" }
        require(aspect > 0.0) { "aspect must be above 0: $aspect" }
    }

    /** Returns the camera after a turn by an angle in degrees; for an empty scene, always the same. */
    private val camera: (Double) -> Camera =
        scene.bounds?.let { Framing(scene, aspect, it)::camera } ?: start.camera(scene, aspect).let { { _ -> it } }

    /**
     * Returns the camera of the step with this number: at 0 that of the first side, and then from farther right.
     *
     * @throws IllegalArgumentException if [step] is not in 0 until [steps]
     */
    public fun at(step: Int): Camera {
        require(step in 0 until steps) { "step must be in 0..${steps - 1}: $step" }
        return camera(360.0 * step / steps)
    }

    override fun toString(): String = "TurntableCamera($steps steps, $start)"

    /** Where the camera is. */
    private inner class Framing(scene: Extent, private val aspect: Double, box: Box) {
        private val axes = List(steps) { Axes(start.azimuth + 360.0 * it / steps, start.elevation) }
        private val center = Vector3d(box.center)
        private val front: Double
        private val back: Double
        private val room = maxOf(box.corner(0).distance(box.corner(7)) / 100, 1e-9)
        private val projection = Projection.Perspective(start.fieldOfView)
        private val isPerspective = start.kind == Fit.PERSPECTIVE

        /** How far the planes through the margins move outward for each unit of distance from the eye. */
        private val slope = if (isPerspective) projection.halfHeight * (1.0 - start.margin / 50.0) else 0.0

        /** How far the scene reaches sideways from [center], beyond planes through it that lean by the slope. */
        private val across: Double

        /** The same, upward and downward. */
        private val upward: Double

        init {
            // Move the middle up or down until the scene is as far from the upper as from the lower margin
            val above = axes.maxOf { scene.reach(it.up, it.direction, slope) }
            val below = axes.maxOf { scene.reach(it.down, it.direction, slope) }
            val level = axes[0].up.y()
            if (level > LEVEL) center.y += (above - below) / (2 * level)
            upward = axes.maxOf {
                maxOf(scene.reach(it.up, it.direction, slope), scene.reach(it.down, it.direction, slope))
            }
            across = axes.maxOf {
                val lean = slope * aspect
                maxOf(scene.reach(it.right, it.direction, lean), scene.reach(it.left, it.direction, lean))
            }
            front = axes.maxOf { scene.reach(it.direction, it.direction, 0.0) }
            back = axes.maxOf { scene.reach(it.backward, it.direction, 0.0) }
        }

        fun camera(angle: Double): Camera {
            val at = Axes(start.azimuth + angle, start.elevation)
            if (!isPerspective) {
                val height = maxOf(2 * upward, 2 * across / aspect, room / 10)
                val eye = Vector3d(at.direction).mul(front + 2 * room).add(center)
                val visible = height / (1.0 - start.margin / 50.0) / start.zoom
                return Camera.orthographic(eye, center, at.up, visible, room, front + back + 3 * room)
            }
            val distance = maxOf(upward / slope, across / (slope * aspect), front + 2 * room)
            val eye = Vector3d(at.direction).mul(distance).add(center)
            val field = projection.magnified(start.zoom).verticalFieldOfView
            return Camera.perspective(eye, center, at.up, field, distance - front - room, distance + back + room)
        }

        /**
         * Returns how far the scene reaches from [center] along [side], which leans by [slope] towards [direction], the
         * direction to the eye.
         */
        private fun Extent.reach(side: Vector3dc, direction: Vector3dc, slope: Double): Double {
            val normal = Vector3d(direction).mul(slope).add(side)
            val point = farthest(normal) ?: return 0.0
            return normal.dot(point.sub(center))
        }
    }

    /** The directions of a camera: to the eye, and in the picture. */
    private class Axes(azimuth: Double, elevation: Double) {
        private val a = azimuth * (StrictMath.PI / 180.0)
        private val e = elevation * (StrictMath.PI / 180.0)

        /** Vertical views have a cosine of exactly 0. */
        private val level = if (StrictMath.abs(elevation) == 90.0) 0.0 else StrictMath.cos(e)
        private val steep = StrictMath.sin(e)
        val direction: Vector3dc = Vector3d(StrictMath.sin(a) * level, steep, StrictMath.cos(a) * level)
        val up: Vector3dc = Vector3d(-StrictMath.sin(a) * steep, level, -StrictMath.cos(a) * steep)
        val right: Vector3dc = Vector3d(StrictMath.cos(a), 0.0, -StrictMath.sin(a))
        val backward: Vector3dc get() = Vector3d(direction).negate()
        val down: Vector3dc get() = Vector3d(up).negate()
        val left: Vector3dc get() = Vector3d(right).negate()
    }

    private companion object {
        /** Below this cosine of the elevation, the view is from straight above or below. */
        const val LEVEL = 1e-6
    }
}
