package dev.lazyz

/**
 * Observes the shading calls of a rendering: which samples are shaded, how often, and in which order. See
 * [Frame.observed].
 *
 * It is called before a colour is computed, by the threads of the renderer, several at the same time if the renderer
 * uses several; so it must be thread safe, or the renderer be configured with one thread.
 */
public fun interface ShadingObserver {
    /** The primitive with the submission index [primitive] is about to be shaded at column [x] and row [y]. */
    public fun shading(x: Int, y: Int, primitive: Int)
}

/** A primitive like [whole], with the submission index [index], which reports each shading call to [observer]. */
internal class ObservedPrimitive(val whole: Primitive, private val index: Int, private val observer: ShadingObserver) :
    Primitive by whole {
    override fun shade(fragment: Fragment) {
        observer.shading(fragment.x, fragment.y, index)
        whole.shade(fragment)
    }

    /** Without a shading call. */
    override fun geometry(fragment: Fragment): Unit = whole.geometry(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)?.let { ObservedCursor(it) }

    override fun toString(): String = "ObservedPrimitive($whole)"

    private inner class ObservedCursor(private val cursor: ShadingCursor) : ShadingCursor {
        override fun step() = cursor.step()

        override fun shade(fragment: Fragment) {
            observer.shading(fragment.x, fragment.y, index)
            cursor.shade(fragment)
        }
    }
}
