package dev.lazyz.scenes.loading

/**
 * Warnings about files: each is there once, and those that differ only in what they are about are one. So a file with a
 * thousand missing textures has one warning about them. Not thread safe.
 */
internal class Warnings {
    /** What each kind of warning is about, by the text before and after it. */
    private val subjects = LinkedHashMap<Pair<String, String>, MutableSet<String>>()

    /** Adds the warning [before] [subject] [after], unless it is there already: some files are read twice. */
    fun add(before: String, subject: String, after: String) {
        subjects.getOrPut(before to after) { LinkedHashSet() }.add(subject)
    }

    /** Returns a sentence for each kind, in the order of their first warnings. */
    fun toList(): List<String> = subjects.map { (text, all) ->
        val (before, after) = text
        val others = all.drop(1)
        val names = others.take(NAMED).joinToString() + if (others.size > NAMED) ", ..." else ""
        before + all.first() + after + if (others.isEmpty()) "" else " (the same for ${others.size} more: $names)"
    }

    private companion object {
        /** How many are named besides the first. */
        const val NAMED = 3
    }
}
