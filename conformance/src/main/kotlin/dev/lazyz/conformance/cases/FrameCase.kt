package dev.lazyz.conformance.cases

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.scenefile.SceneFile
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import org.joml.Vector3dc

/**
 * A frame for testing a renderer. Its text is the Kotlin code that creates it.
 *
 * `Frames` generates such frames; a test may also create its own. Immutable and thread safe if the frame is.
 *
 * @property frame the frame to render
 * @property code a Kotlin expression whose value is a frame equal to [frame], with imports of `dev.lazyz.*`,
 *   `dev.lazyz.conformance.SuiteFrames`, `dev.lazyz.conformance.cases.*`, `dev.lazyz.conformance.frames.*`,
 *   `dev.lazyz.world.*`, `dev.lazyz.world.camera.*`, `dev.lazyz.world.light.*`, `dev.lazyz.world.material.*`,
 *   `dev.lazyz.world.surface.*` and `org.joml.Vector3d`
 */
public class FrameCase(public val frame: Frame, public val code: String) {
    /** The scene from which [frame], or the whole frame of which it is a region, is set up; null if there is none. */
    internal var scene: Scene? = null
        private set

    /** [scene] and its expression, if [frame] is all of what it shows on a raster; otherwise null. */
    internal var codedScene: Coded<Scene>? = null
        private set

    /** The frame as a scene of the corpus, which programs in any language read; null if it is none. */
    internal var corpusScene: String? = null
        private set

    internal constructor(frame: Frame, code: String, scene: Scene?, corpusScene: String? = null) : this(frame, code) {
        this.scene = scene
        this.corpusScene = corpusScene
    }

    /** The frame of [scene] on [raster]. */
    internal constructor(scene: Coded<Scene>, raster: Raster) :
        this(scene.value.frame(raster), "${scene.code}.frame(${code(raster)})", scene.value) {
        codedScene = scene
    }

    /**
     * Returns the frame as the text of a scene file ([SceneFile]) that gives the same pixels, depths and primitives.
     * Returns null if a scene file cannot express the frame, for example because of custom primitives. If the frame is
     * a region, the file has the whole raster. A frame of the corpus is a scene of the corpus instead.
     */
    public fun sceneFile(): String? {
        corpusScene?.let { return it }
        val raster = frame.raster
        val scene = scene?.withBackground(raster.background) ?: return null
        if (scene.ambientVisibility != null || scene.environment?.map != null) return null
        return SceneFile.format(scene, ImageSize(raster.width, raster.height), DepthRules.of(raster))
    }

    /**
     * Returns the scene with changed surfaces; null if there is none, or the surfaces do not correspond to the
     * primitives one to one. The tone mapping stays the same, even if the default of the changed scene is another one.
     */
    internal fun sceneOf(change: (List<Surface>) -> List<Surface>?): Scene? {
        val scene = scene ?: return null
        if (scene.surfaces.size != frame.primitives.size || scene.surfaces.any { it.isOfMany }) return null
        val surfaces = change(scene.surfaces) ?: return null
        return scene.withSurfaces(surfaces).withToneMapping(scene.effectiveToneMapping)
    }

    /** Whether the number of primitives of the surface may be other than one. */
    private val Surface.isOfMany: Boolean get() = this is Mesh || this is Points || this is Lines

    override fun toString(): String = code
}

/** Returns the frames among the [parameters] of a rule. */
internal fun casesAmong(parameters: List<Any?>): List<FrameCase> =
    parameters.flatMap { if (it is List<*>) it else listOf(it) }.filterIsInstance<FrameCase>()

/** A value and its Kotlin expression. */
internal class Coded<out T>(val value: T, val code: String)

/** Returns [value] as a Kotlin expression. */
internal fun code(value: Double): String = when {
    value.isNaN() -> "Double.NaN"
    value.isInfinite() -> if (value > 0) "Double.POSITIVE_INFINITY" else "Double.NEGATIVE_INFINITY"
    else -> value.toString()
}

/** Returns [value] as a Kotlin expression. */
internal fun code(value: Float): String = when {
    value.isNaN() -> "Float.NaN"
    value.isInfinite() -> if (value > 0) "Float.POSITIVE_INFINITY" else "Float.NEGATIVE_INFINITY"
    else -> "${value}f"
}

/** Returns [values] as a Kotlin expression. */
internal fun code(values: FloatArray): String = values.joinToString(prefix = "floatArrayOf(", postfix = ")") {
    code(it)
}

/** Returns [v] as a Kotlin expression. */
internal fun code(v: Vector3dc): String = "Vector3d(${code(v.x())}, ${code(v.y())}, ${code(v.z())})"

/** Returns [value] as a Kotlin expression. */
internal fun code(value: Long): String = if (value == Long.MIN_VALUE) "Long.MIN_VALUE" else "${value}L"

/** Returns [color] as a Kotlin expression. Its components must be finite. */
internal fun code(color: Rgba): String = when (color) {
    Rgba.WHITE -> "Rgba.WHITE"
    else -> "Rgba(${color.red}f, ${color.green}f, ${color.blue}f, ${color.alpha}f)"
}

/** Returns [raster] as a Kotlin expression. */
internal fun code(raster: Raster): String = "Raster(${raster.width}, ${raster.height}, ${code(raster.background)}, " +
    "DepthConvention.${raster.convention}, DepthTest.${raster.depthTest}, ${raster.backgroundDepth})"
