package dev.lazyz.scenes.stl

/** What the words behind the facets of a binary file have in common. */
internal class StlWords {
    /** How many are not zero. */
    var nonZero = 0
        private set

    private var hasColors = false
    private var firstOther = -1
    private var areOthersEqual = true

    /** Whether they are colours as VisCAM writes them: with bit 15 set, and the others all the same. */
    val areVisCam: Boolean get() = hasColors && areOthersEqual

    fun add(word: Int) {
        if (word != 0) nonZero++
        if (word > BLACK) hasColors = true
        if (word >= BLACK) return
        if (firstOther < 0) firstOther = word
        if (word != firstOther) areOthersEqual = false
    }

    private companion object {
        /** Bit 15, and no colour else. */
        const val BLACK = 1 shl 15
    }
}
