package dev.lazyz.scenes.obj.materials

import dev.lazyz.scenes.text.TextLines

/**
 * A texture statement of a material library.
 *
 * @property file the file's name, which may contain spaces
 * @property isClamped whether the texture is clamped instead of repeated
 * @property scale factors of u and v
 * @property offset offsets of u and v, added after scaling
 * @property multiplier factor of the heights of a bump map
 */
internal class MtlMap(
    val file: String,
    val isClamped: Boolean,
    val scale: List<Double>,
    val offset: List<Double>,
    val multiplier: Double,
) {
    companion object {
        /** The options, and the maximum number of words that follow each. */
        private val options = mapOf(
            "-blendu" to 1,
            "-blendv" to 1,
            "-boost" to 1,
            "-bm" to 1,
            "-cc" to 1,
            "-clamp" to 1,
            "-colorspace" to 1,
            "-imfchan" to 1,
            "-mm" to 2,
            "-o" to 3,
            "-s" to 3,
            "-t" to 3,
            "-texres" to 1,
            "-type" to 1,
        )
        private val vectors = listOf("-o", "-s", "-t")
        private val switches = listOf("-blendu", "-blendv", "-cc", "-clamp")
        private val names = listOf("-colorspace", "-imfchan", "-type")

        /**
         * Parses the part after the keyword: options, then a file name. Some programs write options behind the name,
         * which are options if all words up to the end, or to a comment, are options with their values.
         */
        fun parse(arguments: String): MtlMap {
            val words = words(arguments)
            val given = HashMap<String, List<String>>()
            var at = 0
            while (at < words.size) {
                val option = words[at].text.lowercase()
                val most = options[option] ?: break

                // A vector may have fewer than three numbers; the last word of the statement is the file name
                val following = words.subList(at + 1, (at + 1 + most).coerceIn(at + 1, maxOf(words.size - 1, at + 1)))
                    .map { it.text }
                given[option] = if (option in vectors) following.takeWhile(::isNumber) else following
                at += 1 + given.getValue(option).size
            }
            val start = words.getOrNull(at)?.start ?: arguments.length
            val name = arguments.substring(start).trimEnd()
            val shortName = withoutOptions(words(TextLines.uncommented(name)), given)
            return MtlMap(
                if (shortName == null) name else name.substring(0, shortName).trimEnd(),
                given["-clamp"]?.firstOrNull()?.lowercase() in listOf("on", "true"),
                vector(given["-s"], 1.0),
                vector(given["-o"], 0.0),
                vector(given["-bm"], 1.0)[0],
            )
        }

        /**
         * Adds the options at the end of [words] to [given], and returns where they begin, or null if there are none.
         */
        private fun withoutOptions(words: List<Word>, given: HashMap<String, List<String>>): Int? {
            var end = words.size
            var at = words.size - 1
            while (at > 0 && end - at <= MOST_VALUES + 1) {
                val option = words[at].text.lowercase()
                val values = words.subList(at + 1, end).map { it.text }
                if (values.size in 1..(options[option] ?: 0) && values.all { isValue(option, it) }) {
                    given[option] = values
                    end = at
                }
                at--
            }
            return words.getOrNull(end)?.start
        }

        private class Word(val text: String, val start: Int)

        private fun words(text: String): List<Word> {
            val words = ArrayList<Word>()
            var at = 0
            while (at < text.length) {
                val start = at
                while (at < text.length && !text[at].isWhitespace()) at++
                if (at > start) words.add(Word(text.substring(start, at), start))
                at++
            }
            return words
        }

        private fun isValue(option: String, word: String): Boolean = when (option) {
            in switches -> word.lowercase() in listOf("on", "off", "true", "false")
            in names -> '.' !in word
            else -> isNumber(word)
        }

        private fun isNumber(word: String): Boolean = word.toDoubleOrNull() != null

        private fun vector(words: List<String>?, missing: Double): List<Double> =
            List(2) { words?.getOrNull(it)?.toDoubleOrNull()?.takeIf { number -> number.isFinite() } ?: missing }

        /** The maximum number of words that follow any option. */
        private const val MOST_VALUES = 3
    }
}
