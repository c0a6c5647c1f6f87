package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.input.Placement
import dev.lazyz.cli.input.PointOfView
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.Projection
import dev.lazyz.world.View

/** Options of the camera. */
internal class CameraOptions : OptionGroup("Camera") {
    private val choice by option(
        "--camera",
        help = "fit: show all of the scene; scene: its own camera; or the number of a camera of a model, from 0; " +
            "default: fit for models, scene for scene files and built-in scenes",
    ).camera()

    val view by option("--view", help = "Look from ${names(words(View.entries).keys)}")
        .oneOf("SIDE", words(View.entries))

    private val azimuth by option(
        "--azimuth",
        help = "Degrees around the up axis: 0 front, 90 right; default: that of --view, or of the camera of the " +
            "scene, or 30",
    ).number("DEGREES", -1e6..1e6, " degrees")

    private val elevation by option(
        "--elevation",
        help = "Degrees above the horizon, -90..90; default: that of --view, or of the camera of the scene, or 20",
    ).number("DEGREES", -90.0..90.0, " degrees")

    private val projection by option("--projection", help = "perspective or orthographic; default: perspective")
        .oneOf("KIND", words(Fit.entries))

    private val margin by option(
        "--margin",
        help = "Free part of the picture on each side, 0..45 percent; default: ${Camera.DEFAULT_MARGIN.toInt()}",
    ).number("PERCENT", 0.0..45.0, " percent")

    private val zoom by option(
        "--zoom",
        help = "1 shows what the camera shows, 2 shows half as much; 0.001..1000; default: 1",
    ).number("FACTOR", 0.001..1000.0, "")

    private val fieldOfView by option(
        "--fov",
        help = "Vertical field of view of a perspective camera at zoom 1, above 0 and below 180, or at most " +
            "${Camera.MAX_FITTED_FIELD_OF_VIEW.toInt()} without --eye if the camera is fitted; default: " +
            "${Camera.DEFAULT_FIELD_OF_VIEW.toInt()}, or the camera's",
    ).number("DEGREES") { Projection.Perspective(it) }

    private val eye by option("--eye", help = "Position of the camera; default: where it shows all of the scene")
        .vector()

    private val target by option("--target", help = "The point in the middle of the picture; default: the scene's")
        .vector()

    private val up by option("--camera-up", help = "The direction that is up in the picture; default: the up axis")
        .vector()

    private val height by option("--height", help = "Visible height of an orthographic picture; default: it fits")
        .number("UNITS") { Projection.Orthographic(it) }

    private val near by option("--near", help = "Distance of the near plane, world units; default: it fits")
        .number("DISTANCE") { require(it.isFinite()) { "near must be finite: $it" } }

    private val far by option("--far", help = "Distance of the far plane, world units; default: it fits")
        .number("DISTANCE") { require(it.isFinite()) { "far must be finite: $it" } }

    private val isPrinted by option(
        "--print-camera",
        help = "Print to standard error the options that give exactly this camera",
    ).flag()

    fun pointOfView() = PointOfView(
        choice, view, azimuth, elevation, projection, margin, zoom, fieldOfView,
        Placement(eye, target, up, height, near, far), isPrinted,
    )
}
