package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.Scene

/**
 * A frame to try a renderer on, that prints itself as the Kotlin code that makes it.
 *
 * [Frames] generates them; a test may also make its own. Immutable and thread safe if the frame is.
 *
 * @property frame what to render
 * @property code a Kotlin expression whose value is a frame equal to [frame], given imports of `dev.lazyz.*`,
 *   `dev.lazyz.conformance.*` and `org.joml.Vector3d`
 */
public class FrameCase(public val frame: Frame, public val code: String) {
    /** The scene of which this is the frame, if it is the whole frame of a scene: then a scene file can say it. */
    internal var scene: Scene? = null
        private set

    internal constructor(frame: Frame, code: String, scene: Scene) : this(frame, code) {
        this.scene = scene
    }

    override fun toString(): String = code
}
