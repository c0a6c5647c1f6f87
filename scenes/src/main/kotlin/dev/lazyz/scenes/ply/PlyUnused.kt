package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source

/** Collects the elements and properties of a file that are not shown, for one warning about all of them. */
internal class PlyUnused {
    private val unused = ArrayList<String>()
    private var others = 0

    /** Adds the columns of [element] whose numbers are not in [used]. */
    fun add(element: PlyElement, used: Set<Int>) {
        if (element.count == 0 || element.properties.isEmpty()) return
        val names = element.properties.filterIndexed { column, _ -> column !in used }.map { it.name }
        if (names.isEmpty()) return
        if (unused.size == MOST_NAMES) {
            others++
            return
        }
        val more = names.size - MOST_NAMES
        val listed = names.take(MOST_NAMES).joinToString() + (if (more > 0) " and $more more" else "")
        unused.add("$listed of ${element.count} ${element.name}")
    }

    fun warn(source: Source) {
        if (unused.isEmpty()) return
        val more = if (others > 0) "; and those of $others more elements" else ""
        source.warn("properties that are not used: ${unused.joinToString("; ")}$more")
    }

    private companion object {
        const val MOST_NAMES = 12
    }
}
