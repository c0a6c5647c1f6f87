package dev.lazyz.scenes.stl

/** Statistics of the 16-bit words after the facets of a binary file. */
internal class StlWords {
    /** Number of words that are not zero. */
    var nonZero = 0
        private set

    private var hasColors = false
    private var firstOther = -1
    private var areOthersEqual = true

    /**
     * Whether the words are colours as VisCAM writes them: at least one has bit 15 set and is not black, and all those
     * with bit 15 clear are the same.
     */
    val areVisCam: Boolean get() = hasColors && areOthersEqual

    fun add(word: Int) {
        if (word != 0) nonZero++
        if (word > BLACK) hasColors = true
        if (word >= BLACK) return
        if (firstOther < 0) firstOther = word
        if (word != firstOther) areOthersEqual = false
    }

    /** Adds the words of [other], which follow. */
    fun add(other: StlWords) {
        nonZero += other.nonZero
        hasColors = hasColors || other.hasColors
        areOthersEqual = areOthersEqual && other.areOthersEqual &&
            (firstOther < 0 || other.firstOther < 0 || firstOther == other.firstOther)
        if (firstOther < 0) firstOther = other.firstOther
    }

    private companion object {
        /** Bit 15 alone, the colour black. */
        const val BLACK = 1 shl 15
    }
}
