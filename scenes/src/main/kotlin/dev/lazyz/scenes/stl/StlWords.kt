package dev.lazyz.scenes.stl

/** Statistics of the 16-bit words after the facets of a binary file. */
internal class StlWords {
    /** Number of words that are not zero. */
    var nonZero = 0
        private set

    /** Whether a word with bit 15 clear is not zero. */
    var hasUnmarked = false
        private set

    /** Whether a word with bit 15 set is neither black nor white, which programs write for "no colour". */
    var hasMarkedColors = false
        private set

    /** Whether bit 15 of all words is set. */
    var areMarked = true
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
        if (word in 1 until BLACK) hasUnmarked = true
        if (word in BLACK + 1 until WHITE) hasMarkedColors = true
        if (word < BLACK) areMarked = false
        if (word > BLACK) hasColors = true
        if (word >= BLACK) return
        if (firstOther < 0) firstOther = word
        if (word != firstOther) areOthersEqual = false
    }

    /** Adds the words of [other], which follow. */
    fun add(other: StlWords) {
        nonZero += other.nonZero
        hasUnmarked = hasUnmarked || other.hasUnmarked
        hasMarkedColors = hasMarkedColors || other.hasMarkedColors
        areMarked = areMarked && other.areMarked
        hasColors = hasColors || other.hasColors
        areOthersEqual = areOthersEqual && other.areOthersEqual &&
            (firstOther < 0 || other.firstOther < 0 || firstOther == other.firstOther)
        if (firstOther < 0) firstOther = other.firstOther
    }

    private companion object {
        /** Bit 15 alone, the colour black. */
        const val BLACK = 1 shl 15

        /** All bits set, the colour white. */
        const val WHITE = 0xFFFF
    }
}
