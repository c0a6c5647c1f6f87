package dev.lazyz.cli.input

import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint

/** The sides to look from that have a name; angles in degrees, as [Camera.fit] takes them. */
internal enum class View(val azimuth: Double, val elevation: Double) {
    FRONT(0.0, 0.0),
    BACK(180.0, 0.0),
    LEFT(-90.0, 0.0),
    RIGHT(90.0, 0.0),
    TOP(0.0, 90.0),
    BOTTOM(0.0, -90.0),

    /** All three axes are equally long in the picture: the elevation's tangent is the square root of one half. */
    ISO(45.0, 35.264389682754654),
}

/** Where the user wants to look from; null means as the scene has it. */
internal class PointOfView(
    private val view: View?,
    private val azimuth: Double?,
    private val elevation: Double?,
    private val zoom: Double?,
    private val projection: Fit?,
) {
    /** Whether the user said from which side, and not only from how far, or how. */
    val isDirected: Boolean get() = listOfNotNull(view, azimuth, elevation).isNotEmpty()

    private val isGiven: Boolean get() = listOfNotNull(view, azimuth, elevation, zoom, projection).isNotEmpty()

    /**
     * Returns [scene] seen as the user wants it. Whatever is chosen, the camera then frames the whole scene; what is
     * not chosen stays as the scene's own camera has it, as far as a framing camera can.
     */
    fun applyTo(scene: Scene): Scene {
        if (!isGiven) return scene
        val own = framing(scene.viewpoint)
        return scene.withViewpoint(
            Camera.fit(
                azimuth ?: view?.azimuth ?: own.azimuth,
                elevation ?: view?.elevation ?: own.elevation,
                zoom ?: own.zoom,
                projection ?: own.kind,
            ),
        )
    }

    /** Returns the same, seen from the side [other]. */
    fun from(other: View): PointOfView = PointOfView(other, null, null, zoom, projection)

    /** The framing camera that looks the way [viewpoint] does. */
    private fun framing(viewpoint: Viewpoint): FittedViewpoint {
        if (viewpoint is FittedViewpoint) return viewpoint
        if (viewpoint !is Camera) return Camera.fit()

        // The third row of the view matrix points from what is seen to the eye
        val view = viewpoint.viewMatrix()
        return Camera.fit(
            StrictMath.toDegrees(StrictMath.atan2(view.m02(), view.m22())),
            StrictMath.toDegrees(StrictMath.asin(view.m12().coerceIn(-1.0, 1.0))).coerceIn(-90.0, 90.0),
            1.0,
            if (viewpoint.projection is Projection.Perspective) Fit.PERSPECTIVE else Fit.ORTHOGRAPHIC,
        )
    }
}
