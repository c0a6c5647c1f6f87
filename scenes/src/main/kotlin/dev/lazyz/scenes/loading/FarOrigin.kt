package dev.lazyz.scenes.loading

import dev.lazyz.geometry.Box
import org.joml.Vector3d
import org.joml.Vector3dc

/** Keeps the details of files with decimal or 64-bit positions that lie far away from the world's origin. */
internal object FarOrigin {
    /**
     * Returns what [read] makes of a file, given what it subtracts from all positions. That is nothing at first. If the
     * model then lies so far away that 32-bit positions are too coarse, what was read is dropped, the file is read once
     * more, and its middle is subtracted.
     *
     * @param bounds the box around what was read, or null if there is nothing
     */
    fun <T : Any> reading(read: (Vector3dc) -> T, bounds: (T) -> Box?): T {
        val first = First(read(Vector3d()))
        val origin = bounds(first.found())?.origin()
        if (origin == null || origin == Vector3d()) return first.found()
        first.drop()
        return read(origin)
    }

    /** Not a variable, which would hold what was read as long as the call lasts. */
    private class First<T : Any>(private var found: T?) {
        fun found(): T = checkNotNull(found)

        fun drop() {
            found = null
        }
    }
}
