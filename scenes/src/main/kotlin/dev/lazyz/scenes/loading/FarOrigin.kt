package dev.lazyz.scenes.loading

import dev.lazyz.geometry.Box
import org.joml.Vector3d
import org.joml.Vector3dc

/** Keeps the precision of files whose decimal or 64-bit positions are far from the world's origin. */
internal object FarOrigin {
    /**
     * Returns the result of [read], whose argument is the vector that [read] subtracts from all positions. First the
     * vector is zero. If the model is so far from the origin that 32-bit positions are too coarse, the result is
     * discarded, and the file is read again with the model's centre subtracted. It counts towards the limits of
     * [loading] once.
     *
     * @param bounds the bounding box of a result, or null if it is empty
     */
    fun <T : Any> reading(loading: Loading, read: (Vector3dc) -> T, bounds: (T) -> Box?): T {
        val before = loading.used
        val first = First(read(Vector3d()))
        val origin = bounds(first.found())?.origin()
        if (origin == null || origin == Vector3d()) return first.found()
        first.drop()
        loading.used = before
        return read(origin)
    }

    /** Holds the first result. A local variable would keep it in memory until the call ends. */
    private class First<T : Any>(private var found: T?) {
        fun found(): T = checkNotNull(found)

        fun drop() {
            found = null
        }
    }
}
