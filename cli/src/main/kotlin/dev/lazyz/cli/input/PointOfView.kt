package dev.lazyz.cli.input

import dev.lazyz.cli.output.Mistake
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.scenes.TurntableCamera
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.View
import dev.lazyz.world.Viewpoint
import org.joml.Vector3dc

/**
 * The camera options of the user; null means the value of the scene.
 *
 * @property isPrinted whether to print the camera
 * @param turn the step of a turntable, or null
 */
internal class PointOfView(
    private val choice: CameraChoice? = null,
    private val view: View? = null,
    private val azimuth: Double? = null,
    private val elevation: Double? = null,
    private val projection: Fit? = null,
    private val margin: Double? = null,
    private val zoom: Double? = null,
    private val fieldOfView: Double? = null,
    private val placement: Placement = Placement(),
    val isPrinted: Boolean = false,
    private val turn: Turn? = null,
) {
    /** The options that choose a side. */
    private val direction = listOfNotNull(
        view?.let { "--view" }, azimuth?.let { "--azimuth" }, elevation?.let { "--elevation" },
    )

    /** The options that need a fitted camera. */
    private val fitting = direction + listOfNotNull(projection?.let { "--projection" }, margin?.let { "--margin" })

    /** The options that determine a direction, so that the picture cannot be seen from several sides. */
    val directed: List<String> get() = direction + placed

    /** The options that place the camera, so that it cannot go around the scene. */
    val placed: List<String> = listOfNotNull(
        if (choice == null || choice == CameraChoice.Fit) null else "--camera",
        placement.eye?.let { "--eye" },
        placement.target?.let { "--target" },
        placement.up?.let { "--camera-up" },
    )

    init {
        if (choice != null && choice != CameraChoice.Fit && fitting.isNotEmpty()) {
            throw Mistake("--camera with the scene's own camera cannot be combined with ${fitting[0]}")
        }
        val contrary = direction + listOfNotNull(margin?.let { "--margin" })
        if (placement.eye != null && contrary.isNotEmpty()) {
            throw Mistake("--eye cannot be combined with ${contrary[0]}")
        }
    }

    /**
     * Returns the scene of [loaded], rotated so that the axis [up] points up, with the camera that the user chose.
     *
     * @throws UnsupportedOperationException if the scene cannot be rotated
     */
    fun applyTo(loaded: LoadedScene, up: UpAxis): Scene {
        val scene = loaded.scene.withViewpoint(chosen(loaded)).withUpAxis(up)
        val viewpoint = turned(magnified(framed(scene.viewpoint)))
        if (!placement.isGiven) return scene.withViewpoint(viewpoint)
        return scene.withViewpoint(PlacedViewpoint(viewpoint, placement.withUpAxis(up), standingFieldOfView))
    }

    /** Returns these options with the defaults of [style], unless the user chose otherwise, or another camera. */
    fun withDefaults(style: PictureStyle?): PointOfView {
        if (style == null || !(choice == null || choice == CameraChoice.Fit)) return this
        return PointOfView(
            choice, view, azimuth, elevation,
            projection ?: style.projection.takeIf { fieldOfView == null },
            margin ?: style.margin.takeIf { placement.eye == null },
            zoom, fieldOfView, placement, isPrinted, turn,
        )
    }

    /** Returns whether the user asks for the own camera of [loaded], a model that has none. */
    fun lacksCamera(loaded: LoadedScene): Boolean =
        choice != null && choice == CameraChoice.OfScene && loaded.isModel && loaded.cameras.isEmpty()

    /** Whether the user did not choose the near or the far plane. */
    val hasFreePlanes: Boolean get() = placement.near == null && placement.far == null

    /** Returns these options with the side [other]. */
    fun from(other: View): PointOfView =
        PointOfView(choice, other, null, null, projection, margin, zoom, fieldOfView, placement, isPrinted, turn)

    /** Returns these options for a step of a turntable, which begins at the side that they choose. */
    fun at(step: Turn): PointOfView = PointOfView(
        choice, view, azimuth, elevation, projection, margin, zoom, fieldOfView, placement, isPrinted, step,
    )

    /** Returns the camera that `--camera` names. A model's own cameras are not used unless the user asks for them. */
    private fun chosen(loaded: LoadedScene): Viewpoint {
        val own = loaded.scene.viewpoint
        val cameras = loaded.cameras
        return when (choice) {
            null -> if (cameras.isEmpty()) own else Camera.fit()
            CameraChoice.Fit -> when {
                loaded.scene.isOnScreen -> own
                cameras.isEmpty() -> whole(own)
                else -> Camera.fit()
            }
            CameraChoice.OfScene -> own
            is CameraChoice.OfModel ->
                cameras.getOrNull(choice.number)?.camera ?: throw Mistake(noCamera(choice.number, loaded))
        }
    }

    private fun noCamera(number: Int, loaded: LoadedScene): String {
        val names = loaded.cameras.mapIndexed { i, it -> if (it.name.isEmpty()) "$i" else "$i (${it.name})" }
        if (names.isEmpty()) return "--camera $number: the input has no cameras with a number"
        return "--camera $number: the input has ${names.size}: ${names.joinToString()}"
    }

    /** Returns [viewpoint], or a fitted camera if an option needs it. */
    private fun framed(viewpoint: Viewpoint): Viewpoint {
        val isOnScreen = (viewpoint as? Camera)?.projection == Projection.Screen
        if (fitting.isEmpty() && (turn == null || isOnScreen)) return viewpoint
        val own = FittedViewpoint.like(viewpoint)
        return Camera.fit(
            azimuth ?: view?.azimuth ?: own.azimuth,
            elevation ?: view?.elevation ?: own.elevation,
            own.zoom,
            projection ?: own.kind,
            margin ?: own.margin,
            own.fieldOfView,
        )
    }

    /** Returns a camera that shows the whole scene, with the direction and projection of [viewpoint]. */
    private fun whole(viewpoint: Viewpoint): Viewpoint = FittedViewpoint.like(viewpoint).withZoom(1.0)

    /** Field of view of a camera that stands where the user says, so that it is not fitted; null if not given. */
    private val standingFieldOfView: Double?
        get() = fieldOfView?.takeIf { placement.eye != null }?.let { narrowed(it, zoom ?: 1.0) }

    /** Returns [viewpoint] with the field of view and the zoom of the options. */
    private fun magnified(viewpoint: Viewpoint): Viewpoint = when (viewpoint) {
        is FittedViewpoint -> {
            requireKind(viewpoint.kind == Fit.PERSPECTIVE)
            val fitted = fieldOfView?.takeIf { placement.eye == null }
            if (fitted != null && fitted > Camera.MAX_FITTED_FIELD_OF_VIEW) {
                val most = Camera.MAX_FITTED_FIELD_OF_VIEW.toInt()
                throw Mistake("--fov must be at most $most for a camera that shows all; for more, place it with --eye")
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
                Camera.perspective(eye, target, up, narrowed(angle, zoom ?: 1.0), near, far)
            }
            is Projection.Orthographic ->
                Camera.orthographic(eye, target, up, if (zoom == null) own.height else own.height / zoom, near, far)
            Projection.Screen -> this
        }
    }

    private fun turned(viewpoint: Viewpoint): Viewpoint {
        if (turn == null) return viewpoint
        if (viewpoint is FittedViewpoint) return turn.viewpoint(viewpoint)
        throw Mistake("--turntable: a scene given on the screen has no camera that could go around it")
    }

    private fun unmoved(camera: Camera): Camera {
        val option = listOfNotNull(zoom?.let { "--zoom" }, fieldOfView?.let { "--fov" }).firstOrNull()
            ?: if (placement.isGiven) "the options that place a camera" else return camera
        throw Mistake("a scene given on the screen has no camera that could be changed by $option")
    }

    /** Throws a [Mistake] if the options have a value for the other kind of projection. */
    private fun requireKind(isPerspective: Boolean) {
        if (isPerspective && placement.height != null) {
            throw Mistake("--height is for an orthographic camera; use --fov, or --projection orthographic")
        }
        if (!isPerspective && fieldOfView != null) {
            throw Mistake("--fov is for a perspective camera; use --height, or --projection perspective")
        }
    }

    companion object {
        /**
         * Returns the vertical field of view, in degrees, of a camera with this one that magnifies by [zoom]: at 1,
         * exactly this one.
         */
        private fun narrowed(degrees: Double, zoom: Double): Double {
            if (zoom == 1.0) return degrees
            return StrictMath.atan(StrictMath.tan(degrees * (StrictMath.PI / 360.0)) / zoom) * (360.0 / StrictMath.PI)
        }

        /** Returns the options that give exactly [camera] for a model whose axis [up] points up. */
        fun words(camera: Camera, up: UpAxis): String {
            val (kind, size) = when (val projection = camera.projection) {
                is Projection.Perspective -> "perspective" to "--fov=${projection.verticalFieldOfView}"
                is Projection.Orthographic -> "orthographic" to "--height=${projection.height}"
                Projection.Screen -> return "--camera=scene"
            }
            val eye = vector(up.toModel(camera.eye))
            val target = vector(up.toModel(camera.target))
            val upward = vector(up.toModel(camera.up))
            return "--projection=$kind --eye=$eye --target=$target --camera-up=$upward $size " +
                "--near=${camera.near} --far=${camera.far}"
        }

        private fun vector(v: Vector3dc): String = "${v.x()},${v.y()},${v.z()}"
    }
}

/** The value of `--camera`. */
internal sealed class CameraChoice {
    /** A camera that shows the whole scene. */
    data object Fit : CameraChoice()

    /** The scene's own camera, or a fitted one if it has none. */
    data object OfScene : CameraChoice()

    /** The camera of the model with this number, from 0. */
    data class OfModel(val number: Int) : CameraChoice()
}

/**
 * A turn of one input around the up axis, in [steps] equal steps. Remembers how the camera sees the scene from all of
 * them, so that it is computed once. Not thread safe.
 */
internal class Turns(val steps: Int) {
    private var camera: TurntableCamera? = null

    /** Returns the step with this number, from 0. */
    fun step(number: Int) = Turn { start ->
        Viewpoint { scene, aspect ->
            (camera ?: TurntableCamera(scene, aspect, steps, start).also { camera = it }).at(number)
        }
    }
}

/** A step of a turn. */
internal fun interface Turn {
    /** Returns the camera of [start], turned, from the same distance in all steps. */
    fun viewpoint(start: FittedViewpoint): Viewpoint
}
