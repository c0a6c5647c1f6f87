package dev.lazyz.scenes.gltf.document

import dev.lazyz.scenes.loading.Source

/** Warnings about the file [source], one for each kind, with how often it occurs. Not thread safe. */
internal class CountedWarnings(val source: Source) {
    private class Total(val example: String?) {
        var count = 0
    }

    private val totals = LinkedHashMap<String, Total>()

    /** Adds [more] to the count of [sentence]. The first [example] of a sentence is shown in brackets. */
    fun count(sentence: String, more: Int = 1, example: String? = null) {
        if (more > 0) totals.getOrPut(sentence) { Total(example) }.count += more
    }

    /** Reports one warning for each sentence that was counted. */
    fun report() {
        for ((sentence, total) in totals) {
            source.warn("$sentence: ${total.count}${total.example?.let { " ($it)" }.orEmpty()}")
        }
    }
}
