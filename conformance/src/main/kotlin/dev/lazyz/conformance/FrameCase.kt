package dev.lazyz.conformance

import dev.lazyz.Frame

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
    override fun toString(): String = code
}
