package dev.lazyz.scenes.pictures

import dev.lazyz.Raster
import dev.lazyz.geometry.Extent
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.NamedCamera
import dev.lazyz.scenes.pictures.PictureParameters.AZIMUTH
import dev.lazyz.scenes.pictures.PictureParameters.CAMERA
import dev.lazyz.scenes.pictures.PictureParameters.CAMERA_UP
import dev.lazyz.scenes.pictures.PictureParameters.ELEVATION
import dev.lazyz.scenes.pictures.PictureParameters.EYE
import dev.lazyz.scenes.pictures.PictureParameters.FAR
import dev.lazyz.scenes.pictures.PictureParameters.FOV
import dev.lazyz.scenes.pictures.PictureParameters.HEIGHT
import dev.lazyz.scenes.pictures.PictureParameters.MARGIN
import dev.lazyz.scenes.pictures.PictureParameters.NEAR
import dev.lazyz.scenes.pictures.PictureParameters.PROJECTION
import dev.lazyz.scenes.pictures.PictureParameters.STYLE
import dev.lazyz.scenes.pictures.PictureParameters.TARGET
import dev.lazyz.scenes.pictures.PictureParameters.VIEW
import dev.lazyz.scenes.pictures.PictureParameters.ZOOM
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.Viewpoint
import org.joml.Vector3d
import org.joml.Vector3dc

/** The parameters of the camera in [settings]. */
internal class PictureCamera(private val settings: PictureSettings) {
    private val names = settings.names
    private val choice = settings[CAMERA]
    private val zoom = settings[ZOOM]
    private val fieldOfView = settings[FOV]
    private val eye = settings[EYE]
    private val isFitted = choice == null || choice === CameraChoice.FIT
    private val isPlaced = settings.firstGiven(EYE, TARGET, CAMERA_UP, HEIGHT, NEAR, FAR) != null

    /** Whether neither the near nor the far plane was chosen. */
    val hasFreePlanes: Boolean get() = settings[NEAR] == null && settings[FAR] == null

    /** Checks that no two parameters exclude each other. */
    fun check() {
        val fitting = settings.firstGiven(*PictureSettings.DIRECTION, PROJECTION, MARGIN)
        if (!isFitted && fitting != null) {
            refuse("${names.of(CAMERA)} with the scene's own camera cannot be combined with $fitting")
        }
        val contrary = settings.firstGiven(*PictureSettings.DIRECTION, MARGIN)
        if (eye != null && contrary != null) refuse("${names.of(EYE)} cannot be combined with $contrary")
    }

    /** Returns whether the own camera of [loaded] is chosen, a model that has none. */
    fun isMissing(loaded: LoadedScene): Boolean =
        choice === CameraChoice.SCENE && loaded.isModel && loaded.cameras.isEmpty()

    /**
     * Returns [scene], that of [loaded] turned so that its axis [up] points up, with the chosen camera.
     *
     * @param turn makes a camera that goes around the scene out of one that shows all of it, or null
     */
    fun applyTo(scene: Scene, loaded: LoadedScene, up: UpAxis, turn: ((FittedViewpoint) -> Viewpoint)?): Scene {
        val chosen = Scene(emptyList(), viewpoint = settings.viewpoint ?: chosen(loaded)).withUpAxis(up).viewpoint
        val style = settings[STYLE].takeIf { isFitted && settings.viewpoint == null && !loaded.scene.isOnScreen }
        val seen = magnified(framed(chosen, style, turn != null))
        val viewpoint = if (turn == null) seen else turned(seen, turn)
        return scene.withViewpoint(if (isPlaced) PlacedViewpoint(viewpoint, settings, up) else viewpoint)
    }

    /** Returns the chosen camera. A model's own cameras are not used unless the user asks for them. */
    private fun chosen(loaded: LoadedScene): Viewpoint {
        val own = loaded.scene.viewpoint
        val cameras = loaded.cameras
        return when {
            choice == null -> if (cameras.isEmpty()) own else Camera.fit()
            choice === CameraChoice.SCENE -> own
            choice !== CameraChoice.FIT ->
                (found(choice, cameras) ?: refuse(noCamera(choice, loaded))).camera
            loaded.scene.isOnScreen -> own
            cameras.isEmpty() -> FittedViewpoint.like(own).withZoom(1.0)
            else -> Camera.fit()
        }
    }

    private fun found(choice: CameraChoice, cameras: List<NamedCamera>): NamedCamera? = when (choice.number) {
        CameraChoice.NAMED -> cameras.firstOrNull { it.name == choice.toString() }
        else -> cameras.getOrNull(choice.number)
    }

    private fun noCamera(choice: CameraChoice, loaded: LoadedScene): String {
        val camera = names.of(CAMERA, choice)
        val all = loaded.cameras.take(MOST_SHOWN).mapIndexed { i, it ->
            if (it.name.isEmpty()) "$i" else "$i (${it.name})"
        }
        if (all.isEmpty()) return "$camera: the input has no cameras with a number or a name"
        val others = if (loaded.cameras.size > MOST_SHOWN) " and others" else ""
        return "$camera: the input has ${loaded.cameras.size}: ${all.joinToString()}$others"
    }

    /** Returns [viewpoint], or one that shows all of the scene if a parameter or the [style] needs it. */
    private fun framed(viewpoint: Viewpoint, style: PictureStyle?, isTurned: Boolean): Viewpoint {
        val projection = settings[PROJECTION] ?: style?.projection.takeIf { fieldOfView == null }
        val margin = settings[MARGIN] ?: style?.margin.takeIf { eye == null }
        val isOnScreen = (viewpoint as? Camera)?.projection == Projection.Screen
        val needs = settings.firstGiven(*PictureSettings.DIRECTION) ?: projection ?: margin
        if (needs == null && (!isTurned || isOnScreen)) return viewpoint
        val own = FittedViewpoint.like(viewpoint)
        val view = settings[VIEW]
        return Camera.fit(
            settings[AZIMUTH] ?: view?.azimuth ?: own.azimuth,
            settings[ELEVATION] ?: view?.elevation ?: own.elevation,
            own.zoom, projection ?: own.kind, margin ?: own.margin, own.fieldOfView,
        )
    }

    /** Returns [viewpoint] with the chosen field of view and zoom. */
    private fun magnified(viewpoint: Viewpoint): Viewpoint = when (viewpoint) {
        is FittedViewpoint -> {
            requireKind(viewpoint.kind == Fit.PERSPECTIVE)
            val fitted = fieldOfView?.takeIf { eye == null }
            if (fitted != null && fitted > Camera.MAX_FITTED_FIELD_OF_VIEW) {
                val most = "${names.of(FOV)} must be at most ${Camera.MAX_FITTED_FIELD_OF_VIEW.toInt()}"
                refuse("$most for a camera that shows all; for more, place it with ${names.of(EYE)}")
            }
            Camera.fit(
                viewpoint.azimuth, viewpoint.elevation, zoom ?: if (fieldOfView == null) viewpoint.zoom else 1.0,
                viewpoint.kind, viewpoint.margin, fitted ?: viewpoint.fieldOfView,
            )
        }
        is Camera -> magnified(viewpoint)
        else -> viewpoint
    }

    private fun magnified(camera: Camera): Camera = with(camera) {
        if (projection == Projection.Screen) return unmoved(this)
        requireKind(projection is Projection.Perspective)
        when (val own = projection) {
            is Projection.Perspective -> {
                val angle = fieldOfView ?: own.verticalFieldOfView
                Camera.perspective(eye, target, up, narrowed(angle, zoom), near, far)
            }
            is Projection.Orthographic ->
                Camera.orthographic(eye, target, up, if (zoom == null) own.height else own.height / zoom, near, far)
            Projection.Screen -> this
        }
    }

    private fun turned(viewpoint: Viewpoint, turn: (FittedViewpoint) -> Viewpoint): Viewpoint {
        if (viewpoint is FittedViewpoint) return turn(viewpoint)
        refuse("${names.of("turntable")}: a scene given on the screen has no camera that could go around it")
    }

    private fun unmoved(camera: Camera): Camera {
        val parameter = settings.firstGiven(ZOOM, FOV)
            ?: if (isPlaced) "the options that place a camera" else return camera
        refuse("a scene given on the screen has no camera that could be changed by $parameter")
    }

    /** Refuses a value for the other kind of projection. */
    private fun requireKind(isPerspective: Boolean) {
        val fov = names.of(FOV)
        val height = names.of(HEIGHT)
        if (isPerspective && settings[HEIGHT] != null) {
            refuse("$height is for an orthographic camera; use $fov, or ${names.of(PROJECTION, "orthographic")}")
        }
        if (!isPerspective && fieldOfView != null) {
            refuse("$fov is for a perspective camera; use $height, or ${names.of(PROJECTION, "perspective")}")
        }
    }
}

/** Returns the vertical field of view, in degrees, of a camera with this one that magnifies by [zoom]. */
private fun narrowed(degrees: Double, zoom: Double?): Double =
    Projection.Perspective(degrees).magnified(zoom ?: 1.0).verticalFieldOfView

/** The camera of [base], placed by [settings] for a model that was turned so that the axis [axis] points up. */
private class PlacedViewpoint(private val base: Viewpoint, private val settings: PictureSettings, axis: UpAxis) :
    Viewpoint {
    private val chosenEye = settings[EYE]?.let(axis::toWorld)
    private val chosenTarget = settings[TARGET]?.let(axis::toWorld)
    private val chosenUp = settings[CAMERA_UP]?.let(axis::toWorld)

    /** Field of view of a camera that stands where the user says, so that it is not fitted, or null. */
    private val fieldOfView = settings[FOV]?.takeIf { chosenEye != null }?.let { narrowed(it, settings[ZOOM]) }

    override fun camera(extent: Extent, aspect: Double): Camera {
        // To fit a camera takes time, and one that is wholly placed needs nothing of it
        val own by lazy(LazyThreadSafetyMode.NONE) { base.camera(extent, aspect) }
        val height = settings[HEIGHT]
        val kind = (base as? FittedViewpoint)?.kind
        val projection = when {
            kind == Fit.PERSPECTIVE && fieldOfView != null -> Projection.Perspective(fieldOfView)
            kind == Fit.ORTHOGRAPHIC && height != null -> Projection.Orthographic(height)
            else -> own.projection
        }
        val eye = chosenEye ?: eye(own)
        val target = chosenTarget ?: if (chosenEye == null) own.target else extent.bounds?.center ?: own.target
        val up = chosenUp ?: own.up

        // The distances of the near and the far plane are the chosen ones, or around the scene
        val isMoved = chosenEye != null || chosenTarget != null
        val (front, back) = if (isMoved) around(extent, projection, eye, target) else own.near to own.far
        val near = settings[NEAR] ?: front
        val far = settings[FAR] ?: back
        return when (projection) {
            is Projection.Perspective ->
                Camera.perspective(eye, target, up, fieldOfView ?: projection.verticalFieldOfView, near, far)
            is Projection.Orthographic ->
                Camera.orthographic(eye, target, up, height ?: projection.height, near, far)
            Projection.Screen -> own
        }
    }

    /** Returns the eye for a new target: a fitted camera keeps direction and distance, others stay where they are. */
    private fun eye(own: Camera): Vector3dc {
        if (chosenTarget == null || base !is FittedViewpoint) return own.eye
        return Vector3d(
            chosenTarget.x() + (own.eye.x() - own.target.x()), chosenTarget.y() + (own.eye.y() - own.target.y()),
            chosenTarget.z() + (own.eye.z() - own.target.z()),
        )
    }

    private fun around(
        extent: Extent,
        projection: Projection,
        eye: Vector3dc,
        target: Vector3dc,
    ): Pair<Double, Double> {
        // The third row of the view matrix points from the scene to the eye
        val view = Camera.orthographic(eye, target, chosenUp ?: UP, 1.0, 0.0, 1.0).viewMatrix()
        val backward = Vector3d(view.m02(), view.m12(), view.m22())
        val first = extent.farthest(backward)
        val last = extent.farthest(Vector3d(-backward.x, -backward.y, -backward.z))
        val front = if (first == null) 0.0 else along(backward, eye) - along(backward, first)
        val back = if (last == null) 1.0 else along(backward, eye) - along(backward, last)

        // Leave room for rounding
        val room = maxOf(0.005 * (back - front), 1e-6 * StrictMath.abs(back), 1e-9)
        if (projection is Projection.Orthographic) return front - room to back + room
        if (back <= 0.0) return 1.0 to 2.0
        return maxOf(front - room, (back + room) / DEPTH_RATIO) to back + room
    }

    private fun along(direction: Vector3dc, point: Vector3dc): Double =
        direction.x() * point.x() + direction.y() * point.y() + direction.z() * point.z()

    private companion object {
        /** Greatest ratio of far and near plane, for an eye that is within the scene. */
        const val DEPTH_RATIO = 8192.0

        val UP: Vector3dc = Vector3d(0.0, 1.0, 0.0)
    }
}

/** Whether a part of [scene], which has a camera, is outside the picture of [raster], see [PictureFrame.isCropped]. */
internal fun isCropped(scene: Scene, raster: Raster): Boolean {
    val camera = scene.viewpoint as Camera

    /** Whether a point is farther along a direction of the camera than [limit], from its eye. */
    fun isBeyond(x: Double, y: Double, z: Double, limit: Double): Boolean {
        val direction = camera.toWorldDirection(x, y, z)
        val point = scene.farthest(direction) ?: return false
        return direction.dot(point.sub(camera.eye)) > limit
    }

    // What is half a pixel outside may come from rounding
    val wide = (raster.width + 1.0) / raster.height
    val high = 1.0 + 1.0 / raster.height
    val slack = (camera.far - camera.near) * PLANE_SLACK
    if (isBeyond(0.0, 0.0, 1.0, slack - camera.near) || isBeyond(0.0, 0.0, -1.0, camera.far + slack)) return true
    val half = camera.halfHeight()
    return when (camera.projection) {
        is Projection.Perspective ->
            listOf(-1.0, 1.0).any { isBeyond(it, 0.0, half * wide, 0.0) || isBeyond(0.0, it, half * high, 0.0) }

        is Projection.Orthographic ->
            listOf(-1.0, 1.0).any { isBeyond(it, 0.0, 0.0, half * wide) || isBeyond(0.0, it, 0.0, half * high) }

        // In pixels from the upper left corner
        Projection.Screen -> {
            val bounds = scene.bounds ?: return false
            bounds.minX < -0.5 || bounds.minY < -0.5 ||
                bounds.maxX > raster.width + 0.5 || bounds.maxY > raster.height + 0.5
        }
    }
}

/** How far beyond a plane rounding takes a point, as a part of the distance between the near and the far plane. */
private const val PLANE_SLACK = 1e-6

/** How many cameras an error lists. */
private const val MOST_SHOWN = 20
