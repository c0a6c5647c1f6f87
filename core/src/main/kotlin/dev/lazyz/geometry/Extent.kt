package dev.lazyz.geometry

import org.joml.Vector3d
import org.joml.Vector3dc

/** What takes up a part of world space, a surface or a whole scene. */
public interface Extent {
    /** A box around it, or null if it is empty. */
    public val bounds: Box?

    /**
     * Returns the point that is farthest along [direction]: the one whose dot product with it is greatest; one of them
     * if there are several, or null if there is none. World space; a new vector for each call. [direction] has any
     * length above 0.
     *
     * A fitted camera calls it some 30 times, see `Camera.fit`. What does not override this function is fitted by its
     * [bounds], so it can look smaller than it could.
     */
    public fun farthest(direction: Vector3dc): Vector3d? = bounds?.farthest(direction)
}
