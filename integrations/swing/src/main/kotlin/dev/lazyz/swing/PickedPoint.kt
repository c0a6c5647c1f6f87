package dev.lazyz.swing

import dev.lazyz.Frame.SeenPoint
import dev.lazyz.scenes.pictures.PictureFrame
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A point that a user selected in a [ModelView]. Immutable.
 *
 * @property seen the surface and its part, the triangle and texture coordinates. Where the model is cut, numbers of
 *   surfaces and triangles are those of the cut model
 * @property position the point, in the coordinates of the model
 */
public class PickedPoint private constructor(public val seen: SeenPoint, public val position: Vector3dc) {
    override fun toString(): String {
        val part = seen.part.ifEmpty { "surface ${seen.surface}" }
        return "$part, triangle ${seen.triangle}, at ${position.x()}, ${position.y()}, ${position.z()}"
    }

    internal companion object {
        /** Returns what is at a pixel of [frame], or null. */
        fun of(frame: PictureFrame, x: Int, y: Int): PickedPoint? {
            val seen = frame.samples.at(x, y) ?: return null
            return PickedPoint(seen, frame.up.toModel(Vector3d(seen.x, seen.y, seen.z)))
        }
    }
}
