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

        /** Parses the part after the keyword: options, then a file name. */
        fun parse(arguments: String): MtlMap {
            val given = HashMap<String, List<String>>()
            var rest = arguments.trim()
            while (true) {
                val words = TextLines.words(rest)
                val option = words.firstOrNull()?.lowercase()
                val most = options[option] ?: break

                // A vector may have fewer than three numbers; the last word of the statement is the file name
                val following = words.drop(1).take(most).take(maxOf(words.size - 2, 0))
                val values = if (option in vectors) following.takeWhile { it.toDoubleOrNull() != null } else following
                given[checkNotNull(option)] = values
                repeat(1 + values.size) { rest = rest.dropWhile { it != ' ' }.trimStart() }
            }
            return MtlMap(
                rest,
                given["-clamp"]?.firstOrNull()?.lowercase() in listOf("on", "true"),
                vector(given["-s"], 1.0),
                vector(given["-o"], 0.0),
                vector(given["-bm"], 1.0)[0],
            )
        }

        private fun vector(words: List<String>?, missing: Double): List<Double> =
            List(2) { words?.getOrNull(it)?.toDoubleOrNull()?.takeIf { number -> number.isFinite() } ?: missing }
    }
}
