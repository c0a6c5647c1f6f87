package dev.lazyz.conformance.cases

import dev.lazyz.Frame
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.scenefile.SceneFile
import dev.lazyz.world.Lines
import dev.lazyz.world.Mesh
import dev.lazyz.world.Points
import dev.lazyz.world.Scene
import dev.lazyz.world.Surface

/**
 * A frame to try a renderer on, that prints itself as the Kotlin code that makes it.
 *
 * `Frames` generates them; a test may also make its own. Immutable and thread safe if the frame is.
 *
 * @property frame what to render
 * @property code a Kotlin expression whose value is a frame equal to [frame], given imports of `dev.lazyz.*`,
 *   `dev.lazyz.conformance.cases.*`, `dev.lazyz.conformance.frames.*`, `dev.lazyz.world.*` and
 *   `org.joml.Vector3d`
 */
public class FrameCase(public val frame: Frame, public val code: String) {
    /** The scene that is set up to [frame], or to what [frame] is a region of; null if there is none. */
    internal var scene: Scene? = null
        private set

    internal constructor(frame: Frame, code: String, scene: Scene?) : this(frame, code) {
        this.scene = scene
    }

    /**
     * Returns the frame as the text of a scene file ([SceneFile]), which is set up to the same pixels, depths and
     * primitives; null where a scene file has no words for it, as for primitives of one's own. Of a frame that is a
     * region it has the whole raster.
     */
    public fun sceneFile(): String? {
        val raster = frame.raster
        val scene = scene?.withBackground(raster.background) ?: return null
        return SceneFile.format(scene, ImageSize(raster.width, raster.height), DepthRules.of(raster))
    }

    /** The scene with other surfaces; null if there is none, or not one surface for each primitive. */
    internal fun sceneOf(change: (List<Surface>) -> List<Surface>?): Scene? {
        val scene = scene ?: return null
        if (scene.surfaces.size != frame.primitives.size || scene.surfaces.any { it.isOfMany }) return null
        val surfaces = change(scene.surfaces) ?: return null
        return Scene(surfaces, scene.lights, scene.viewpoint, scene.background)
    }

    /** Whether a surface may be any number of primitives. */
    private val Surface.isOfMany: Boolean get() = this is Mesh || this is Points || this is Lines

    override fun toString(): String = code
}

/** The frames among the [parameters] of a rule. */
internal fun casesAmong(parameters: List<Any?>): List<FrameCase> =
    parameters.flatMap { if (it is List<*>) it else listOf(it) }.filterIsInstance<FrameCase>()
