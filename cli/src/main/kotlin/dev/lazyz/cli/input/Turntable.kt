package dev.lazyz.cli.input

import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A turn around the up axis in [steps] equal steps, of one input. Remembers how the camera sees the scene from all of
 * them, so that it is computed once.
 */
internal class Turntable(val steps: Int) {
    private var framing: TurntableFraming? = null

    /** Returns the step with this number, from 0. */
    fun step(number: Int) = Turn(this, number)

    fun framing(scene: Scene, aspect: Double, start: FittedViewpoint): TurntableFraming =
        framing ?: TurntableFraming(scene, aspect, start, steps).also { framing = it }
}

/** A step of a [turntable]; [number] 0 is the side at which it begins. */
internal class Turn(val turntable: Turntable, private val number: Int) {
    /** Degrees around the up axis. */
    val angle: Double get() = 360.0 * number / turntable.steps
}

/** The camera of [start], turned, from the same distance in all steps. */
internal class TurntableViewpoint(private val start: FittedViewpoint, private val turn: Turn) : Viewpoint {
    override fun camera(scene: Scene, aspect: Double): Camera {
        if (scene.bounds == null) return start.camera(scene, aspect)
        return turn.turntable.framing(scene, aspect, start).camera(turn.angle)
    }
}

/**
 * Where the camera of a turntable is: always at the same distance from one point of the axis. The axis goes through the
 * middle of the scene's box. From the nearest step the scene touches a margin, and no step shows more than the picture.
 */
internal class TurntableFraming(
    private val scene: Scene,
    private val aspect: Double,
    private val start: FittedViewpoint,
    steps: Int,
) {
    private val axes = List(steps) { Axes(start.azimuth + 360.0 * it / steps, start.elevation) }
    private val box = checkNotNull(scene.bounds) { "the scene is empty" }
    private val center: Vector3d
    private val front: Double
    private val back: Double
    private val room = maxOf(box.corner(0).distance(box.corner(7)) / 100, 1e-9)
    private val halfHeight = StrictMath.tan(start.fieldOfView * (StrictMath.PI / 360.0))
    private val isPerspective = start.kind == Fit.PERSPECTIVE

    /** How far the planes through the margins move outward for each unit of distance from the eye. */
    private val slope = if (isPerspective) halfHeight * (1.0 - start.margin / 50.0) else 0.0

    /** How far the scene reaches sideways from [center], beyond planes through it that lean by the slope. */
    private val across: Double

    /** The same, upward and downward. */
    private val upward: Double

    init {
        // Move the middle up or down until the scene is as far from the upper as from the lower margin
        center = Vector3d(box.center)
        val above = axes.maxOf { reach(it.up, it.direction, slope) }
        val below = axes.maxOf { reach(it.down, it.direction, slope) }
        val level = axes[0].up.y()
        if (level > LEVEL) center.y += (above - below) / (2 * level)
        upward = axes.maxOf { maxOf(reach(it.up, it.direction, slope), reach(it.down, it.direction, slope)) }
        across = axes.maxOf {
            maxOf(reach(it.right, it.direction, slope * aspect), reach(it.left, it.direction, slope * aspect))
        }
        front = axes.maxOf { reach(it.direction, it.direction, 0.0) }
        back = axes.maxOf { reach(it.backward, it.direction, 0.0) }
    }

    /** Returns the camera after a turn by [angle] degrees. */
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
        val field = PointOfView.narrowed(start.fieldOfView, start.zoom)
        return Camera.perspective(eye, center, at.up, field, distance - front - room, distance + back + room)
    }

    /**
     * Returns how far the scene reaches from [center] along [side], which leans by [slope] towards [direction], the
     * direction to the eye.
     */
    private fun reach(side: Vector3dc, direction: Vector3dc, slope: Double): Double {
        val normal = Vector3d(direction).mul(slope).add(side)
        val point = scene.farthest(normal) ?: return 0.0
        return normal.dot(point.sub(center))
    }

    private companion object {
        /** Below this cosine of the elevation, the view is from straight above or below. */
        const val LEVEL = 1e-6
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
