package dev.lazyz

/** See [Selector.nearest]. */
internal object NearestSelector : Selector {
    override fun select(cell: Cell) = cell.show(0)

    override fun toString(): String = "nearest"
}

/** See [Selector.farthest]. */
internal object FarthestSelector : Selector {
    override fun select(cell: Cell) = cell.show(cell.size - 1)

    override fun toString(): String = "farthest"
}

/** See [Selector.kthNearest]. */
internal class KthNearestSelector(private val k: Int) : Selector {
    override fun select(cell: Cell) {
        if (k <= cell.size) cell.show(k - 1)
    }

    override fun equals(other: Any?): Boolean = other is KthNearestSelector && k == other.k

    override fun hashCode(): Int = k

    override fun toString(): String = "kthNearest($k)"
}

/** See [Selector.count]. */
internal object CountSelector : Selector {
    override fun select(cell: Cell) {
        val color = Viridis.step(step(cell.size))
        cell.show(0, color.red, color.green, color.blue, color.alpha)
    }

    private fun step(count: Int): Int = when {
        count <= 4 -> count - 1
        count <= 8 -> 4
        count <= 16 -> 5
        count <= 32 -> 6
        else -> 7
    }

    override fun toString(): String = "count"
}

/** See [Selector.blend]. */
internal object BlendSelector : Selector {
    override fun select(cell: Cell) {
        // An opaque fragment in front hides everything else
        if (!cell.isTranslucent(0)) {
            cell.show(0)
            return
        }
        val blending = Blending()
        blending.clear()
        var i = 0
        while (i < cell.size && cell.isTranslucent(i) && blending.isOpen) blending.add(cell.shade(i++))

        // The backdrop comes last, if any light from it passes through
        if (blending.isOpen && i < cell.size) blending.end(cell.shade(i)) else blending.end(cell.background)
        cell.show(0, blending.red, blending.green, blending.blue, blending.alpha)
    }

    override fun toString(): String = "blend"
}
