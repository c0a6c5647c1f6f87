package dev.lazyz.cli

/**
 * Which packages name which others, by their sources: an arrow for each import, and for each full name in the text.
 *
 * @param sources the sources of one module
 * @param modulePackages packages of all modules; a name belongs to the longest of them that is its prefix
 */
internal class PackageGraph(sources: List<Source>, private val modulePackages: Set<String> = packagesOf(sources)) {
    /**
     * A source file.
     *
     * @property path its path, for messages
     */
    class Source(val path: String, val text: String) {
        /** The package that the file declares. */
        val packageName: String = PACKAGE.find(text)?.groupValues?.get(1).orEmpty()

        override fun toString(): String = path
    }

    /** A dependency: [source] names a declaration of package [to]. */
    private class Arrow(val source: Source, val to: String) {
        val from: String get() = source.packageName
    }

    private val arrows: List<Arrow> = sources.flatMap { source -> named(source).map { Arrow(source, it) } }

    /** Returns the other packages that [source] names. */
    private fun named(source: Source): Set<String> {
        val text = source.text.replace(PACKAGE, "").replace(LITERAL, "")
        return NAME.findAll(text).mapNotNull { packageOf(it.value) }.filter { it != source.packageName }.toSet()
    }

    private fun packageOf(name: String): String? =
        generateSequence(name.substringBeforeLast('.', "")) { it.substringBeforeLast('.', "") }
            .takeWhile { it.isNotEmpty() }
            .firstOrNull { it in modulePackages }

    /**
     * Returns the cycles: sets of packages that depend on each other, directly or indirectly. A cycle is returned as a
     * few lines: its packages, and the files that create the dependencies.
     */
    fun cycles(): List<String> {
        val next = arrows.groupBy({ it.from }, { it.to }).mapValues { it.value.toSet() }
        val reached = next.keys.associateWith { reachedFrom(it, next) }
        val cycles = next.keys.filter { it in reached.getValue(it) }
            .groupBy { start -> reached.getValue(start).filter { start in reached[it].orEmpty() }.sorted() }
        return cycles.keys.map { cycle ->
            val inside = arrows.filter { it.from in cycle && it.to in cycle }
            val lines = inside.groupBy({ "${it.from} -> ${it.to}" }, { it.source.path.substringAfterLast('/') })
            cycle.joinToString() + lines.toSortedMap().map { (arrow, files) -> "\n    $arrow: ${files.joinToString()}" }
                .joinToString("")
        }
    }

    /**
     * Returns the dependencies on packages that are not below the package of the source, as [level] defines it: a
     * package has a higher level than those below it.
     */
    fun upward(level: (packageName: String) -> Int): List<String> =
        arrows.filter { level(it.to) >= level(it.from) }
            .map { "${it.source} names ${it.to}" }

    private fun reachedFrom(start: String, next: Map<String, Set<String>>): Set<String> {
        val reached = HashSet<String>()
        val open = ArrayDeque(next[start].orEmpty())
        while (open.isNotEmpty()) {
            val one = open.removeFirst()
            if (reached.add(one)) open.addAll(next[one].orEmpty())
        }
        return reached
    }

    companion object {
        private val PACKAGE = Regex("""(?m)^package ([\w.]+);?""")

        /** Matches text in quotes, and names between backticks in comments. They are not dependencies. */
        private val LITERAL = Regex("\"(?:\\\\.|[^\"\\\\\n])*\"|`[^`\n]*`")
        private val NAME = Regex("""\bdev\.lazyz(?:\.\w+)+""")

        /** Returns the packages of [sources]. */
        fun packagesOf(sources: List<Source>): Set<String> = sources.map { it.packageName }.toSet()
    }
}
