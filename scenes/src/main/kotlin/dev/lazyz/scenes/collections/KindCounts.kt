package dev.lazyz.scenes.collections

/** Counts the ignored elements of a file by kind, for one warning about all of them. Not thread safe. */
internal class KindCounts {
    private val counts = LinkedHashMap<String, Int>()

    /** Number of elements that were added. */
    var total = 0
        private set

    fun add(kind: String) {
        total++
        if (counts.size < MOST_KINDS || kind in counts) counts.merge(kind, 1, Int::plus)
    }

    /** Lists the kinds in the order of the file, `2 curv, 8 vp`; kinds after the first [MOST_KINDS] are `others`. */
    override fun toString(): String {
        val named = counts.entries.joinToString { (kind, count) -> "$count $kind" }
        val others = total - counts.values.sum()
        return if (others > 0) "$named and $others others" else named
    }

    private companion object {
        const val MOST_KINDS = 8
    }
}
