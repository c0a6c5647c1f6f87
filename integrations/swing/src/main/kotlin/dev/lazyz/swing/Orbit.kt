package dev.lazyz.swing

import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
import dev.lazyz.world.camera.Projection
import java.awt.geom.Point2D
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.tan
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A camera that goes around a point, in a world in which y points up. Immutable.
 *
 * @property azimuth degrees around the up axis: 0 front, 90 right
 * @property elevation degrees above the horizon, -90..90
 * @property pivot the point in the middle of the picture
 * @property span height of what is visible around the pivot, world units
 * @property fieldOfView vertical field of view, degrees; null if the camera is orthographic
 */
internal class Orbit(
    val azimuth: Double,
    val elevation: Double,
    private val pivot: Vector3dc,
    private val span: Double,
    val fieldOfView: Double?,
) {
    private val a = Math.toRadians(azimuth)
    private val e = Math.toRadians(elevation)
    private val right = Vector3d(cos(a), 0.0, -sin(a))
    private val upward = Vector3d(-sin(a) * sin(e), cos(e), -cos(a) * sin(e))
    private val backward = Vector3d(sin(a) * cos(e), sin(e), cos(a) * cos(e))

    /** Returns this camera after a turn around the pivot, degrees to the right and up. */
    fun turned(right: Double, up: Double): Orbit =
        Orbit(azimuth + right, (elevation + up).coerceIn(-90.0, 90.0), pivot, span, fieldOfView)

    /** Returns this camera, moved to the right and up by parts of the height of the picture. */
    fun moved(right: Double, up: Double): Orbit =
        Orbit(azimuth, elevation, at(right, up), span, fieldOfView)

    /**
     * Returns this camera, magnifying by another [factor]. What is at ([x], [y]) stays there: parts of the height of
     * the picture, to the right of its middle and above it.
     */
    fun zoomed(factor: Double, x: Double, y: Double): Orbit {
        val wanted = (span / factor).coerceIn(LEAST_SPAN, MOST_SPAN)
        val kept = 1.0 - wanted / span
        return Orbit(azimuth, elevation, at(kept * x, kept * y), wanted, fieldOfView)
    }

    /** Returns this camera with the other kind of projection, which shows the same around the pivot. */
    fun withOtherProjection(): Orbit =
        Orbit(azimuth, elevation, pivot, span, if (fieldOfView == null) Camera.DEFAULT_FIELD_OF_VIEW else null)

    private fun at(x: Double, y: Double) = Vector3d(right).mul(x * span).fma(y * span, upward).add(pivot)

    /** Returns [settings] with this camera, for a model whose axis [up] was turned to y. */
    fun on(settings: PictureSettings, up: UpAxis): PictureSettings {
        val distance = if (fieldOfView == null) span else span / 2 / tan(Math.toRadians(fieldOfView) / 2)
        val eye = Vector3d(pivot).fma(distance, backward)
        val camera = if (fieldOfView == null) {
            Camera.orthographic(eye, pivot, upward, span, 0.0, 1.0)
        } else {
            Camera.perspective(eye, pivot, upward, fieldOfView, 1.0, 2.0)
        }

        // The planes are then around the model
        return settings.seenBy(camera, up).without(PictureParameters.NEAR).without(PictureParameters.FAR)
    }

    companion object {
        private const val LEAST_SPAN = 1e-30
        private const val MOST_SPAN = 1e30

        /** Returns the camera that shows the same as [camera], and turns around what is in the middle at [center]. */
        fun of(camera: Camera, center: Vector3dc): Orbit {
            val like = FittedViewpoint.like(camera)
            val backward = camera.toWorldDirection(0.0, 0.0, 1.0)
            val depth = Vector3d(camera.eye).sub(center).dot(backward).takeIf { it > 0.0 }
                ?: camera.eye.distance(camera.target)

            // From straight above or below, what is up in the picture says where the front is
            val isVertical = abs(backward.x) + abs(backward.z) < 1e-4
            val upward = camera.toWorldDirection(0.0, 1.0, 0.0)
            val sign = if (backward.y > 0) -1.0 else 1.0
            val azimuth =
                if (isVertical) Math.toDegrees(atan2(sign * upward.x, sign * upward.z)) else like.azimuth
            return Orbit(
                azimuth, like.elevation, Vector3d(camera.eye).fma(-depth, backward), camera.heightAt(depth),
                (camera.projection as? Projection.Perspective)?.verticalFieldOfView,
            )
        }
    }
}

/** Returns where [point] is in a picture of [width] x [height] pixels, or null if it is behind the eye. */
internal fun Camera.pixel(point: Vector3dc, width: Int, height: Int): Point2D? {
    val seen = viewMatrix().transformPosition(point, Vector3d())
    val depth = -seen.z
    if (projection is Projection.Perspective && !(depth > 0.0)) return null
    val scale = height / heightAt(depth)
    return Point2D.Double(width / 2.0 + scale * seen.x, height / 2.0 - scale * seen.y)
}
