package dev.lazyz.scenes.loading

import dev.lazyz.world.surface.Surface

/** Names of parts, see [Surface.name]. */
internal object PartNames {
    /** In characters: a name in the file can be long, and many parts can be inside the part that has it. */
    const val LONGEST: Int = 1000

    private const val CUT = "..."

    /**
     * Returns the path of the part [name] in the part with the path [parent]; either can be empty. A path with more
     * than [LONGEST] characters loses its beginning.
     */
    fun path(parent: String, name: String?): String {
        if (name.isNullOrBlank()) return parent
        val own = name.trim().takeLast(LONGEST + 1)
        val path = if (parent.isEmpty()) own else "${parent.takeLast(LONGEST)}/$own"
        return if (path.length <= LONGEST) path else CUT + path.takeLast(LONGEST - CUT.length)
    }

    /** Returns the memory of [path]. */
    fun bytes(path: String): Long = 2L * path.length
}
