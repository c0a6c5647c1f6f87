package dev.lazyz

/** Is told of each shading call, by any thread. */
internal fun interface ShadingTally {
    fun count(x: Int, y: Int)
}

/** A primitive like [whole], which reports each shading call to [tally]. */
internal class TalliedPrimitive(val whole: Primitive, private val tally: ShadingTally) : Primitive by whole {
    override fun shade(fragment: Fragment) {
        tally.count(fragment.x, fragment.y)
        whole.shade(fragment)
    }

    /** Without a shading call. */
    override fun geometry(fragment: Fragment): Unit = whole.geometry(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)?.let { TalliedCursor(it) }

    override fun toString(): String = "TalliedPrimitive($whole)"

    private inner class TalliedCursor(private val cursor: ShadingCursor) : ShadingCursor {
        override fun step() = cursor.step()

        override fun shade(fragment: Fragment) {
            tally.count(fragment.x, fragment.y)
            cursor.shade(fragment)
        }
    }
}
