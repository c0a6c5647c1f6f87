package dev.lazyz.scenes.loading

import dev.lazyz.geometry.Box
import org.joml.Vector3d
import org.joml.Vector3dc

/** Keeps the details of files with decimal or 64-bit positions that lie far away from the world's origin. */
internal object FarOrigin {
    /**
     * Returns what [read] makes of a file, given what it subtracts from all positions. That is nothing at first. If the
     * model then lies so far away that 32-bit positions are too coarse, the file is read once more, and its middle is
     * subtracted.
     *
     * @param bounds the box around what was read, or null if there is nothing
     */
    inline fun <T> reading(read: (Vector3dc) -> T, bounds: (T) -> Box?): T {
        val first = read(Vector3d())
        val origin = bounds(first)?.origin() ?: return first
        return if (origin == Vector3d()) first else read(origin)
    }
}
