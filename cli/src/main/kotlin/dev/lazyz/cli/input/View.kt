package dev.lazyz.cli.input

import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint

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

/** The camera options of the user; null means the value of the scene. */
internal class PointOfView(
    private val view: View?,
    private val azimuth: Double?,
    private val elevation: Double?,
    private val zoom: Double?,
    private val projection: Fit?,
) {
    /** Whether the user chose a side, not only zoom or projection. */
    val isDirected: Boolean get() = listOfNotNull(view, azimuth, elevation).isNotEmpty()

    private val isGiven: Boolean get() = listOfNotNull(view, azimuth, elevation, zoom, projection).isNotEmpty()

    /**
     * Returns [scene] with the camera that the user chose. If any option was given, the camera is fitted to the whole
     * scene. Values that were not given are those of the scene's own camera, as far as a fitted camera has them.
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

    /** Returns these options with [default] as projection, unless the user chose one. */
    fun withDefault(default: Fit?): PointOfView = PointOfView(view, azimuth, elevation, zoom, projection ?: default)

    /** Returns these options with the side [other]. */
    fun from(other: View): PointOfView = PointOfView(other, null, null, zoom, projection)

    /** Returns a fitted camera with the direction and projection of [viewpoint]. */
    private fun framing(viewpoint: Viewpoint): FittedViewpoint {
        if (viewpoint is FittedViewpoint) return viewpoint
        if (viewpoint !is Camera) return Camera.fit()

        // The third row of the view matrix points from the scene to the eye
        val view = viewpoint.viewMatrix()
        return Camera.fit(
            StrictMath.toDegrees(StrictMath.atan2(view.m02(), view.m22())),
            StrictMath.toDegrees(StrictMath.asin(view.m12().coerceIn(-1.0, 1.0))).coerceIn(-90.0, 90.0),
            1.0,
            if (viewpoint.projection is Projection.Perspective) Fit.PERSPECTIVE else Fit.ORTHOGRAPHIC,
        )
    }
}
