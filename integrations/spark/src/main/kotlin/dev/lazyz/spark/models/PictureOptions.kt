package dev.lazyz.spark.models

import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import java.io.Serializable

/**
 * What a picture of a model shows, written as words `name=value` with spaces or commas between them, for example
 * `size=256 view=iso aa=4`. The names and values are those of [PictureParameters], which are those of `zcli render`; a
 * comma belongs to a value if no `=` follows, as in `eye=1,2,3`, spaces do between quotes, as in `variant="a b"`,
 * and to a name that switches something on, such as `edges`, `=true` can be left out. The default of `size`
 * is 256. There are more names: `output` is `png`, which is the default, `pixels` or `depth`, or several joined by `+`;
 * in place of one picture, `aov`, `turntable` and `views` ask for what [PictureOutput] says; `model` is the model in a
 * ZIP archive, if there are several. Files, as of `texture`, are names in the archive.
 *
 * Immutable. Throws [IllegalArgumentException] if a word is not understood, or two exclude each other; the message says
 * which.
 *
 * @property words the words as they were given
 */
public class PictureOptions(public val words: String) : Serializable {
    /** Names with their values. */
    private val pairs: List<Pair<String, String>> = pairs(words)

    init {
        // Look at all words now, so that the driver reports mistakes and not each task
        settings().check()
        output()
        columns()
    }

    internal val format: SceneFormat? get() = settings()[PictureParameters.FORMAT]

    internal fun has(column: String): Boolean = column in columns()

    internal fun settings(): PictureSettings =
        PictureDoor.SPARK.read(USUAL, pairs.filter { (name, _) -> name !in OWN })

    internal val model: String? get() = last(MODEL)

    /** Returns what there is in place of one picture, or null. */
    internal fun output(): PictureOutput? {
        val words = PictureOutput.WORDS.keys.mapNotNull { name -> last(name)?.let { name to it } }.toMap()
        return if (words.isEmpty()) null else PictureOutput.read(words, settings())
    }

    private fun columns(): List<String> {
        val word = last(COLUMNS)
        val other = PictureOutput.WORDS.keys.firstOrNull { last(it) != null }
        require(word == null || other == null) { "$COLUMNS cannot be combined with $other" }
        return (word ?: KNOWN[0]).split('+').onEach {
            require(it in KNOWN) { "$COLUMNS: '$it' is not one of ${KNOWN.joinToString()}" }
        }
    }

    private fun last(name: String): String? = pairs.lastOrNull { it.first == name }?.second

    override fun toString(): String = "PictureOptions($words)"

    public companion object {
        private const val COLUMNS = "output"
        private const val MODEL = "model"

        // Stand for what a quote keeps together
        private const val QUOTED_SPACE = '\uE000'
        private const val QUOTED_COMMA = '\uE001'
        private val USUAL = PictureSettings().withDefault(PictureParameters.SIZE, ImageSize(256, 256))
        private val KNOWN = listOf("png", "pixels", "depth")
        private val OWN = listOf(COLUMNS, MODEL) + PictureOutput.WORDS.keys
        private val NAMES = PictureDoor.SPARK.parameters.map { it.name } + OWN

        /** Returns names with their values. */
        private fun pairs(words: String): List<Pair<String, String>> {
            val pairs = ArrayList<Pair<String, String>>()
            val quoted = words.split('"')
            require(quoted.size % 2 == 1) { "a quote has no end: $words" }
            val plain = quoted.withIndex().joinToString("") { (number, part) ->
                if (number % 2 == 0) part else part.replace(' ', QUOTED_SPACE).replace(',', QUOTED_COMMA)
            }
            for (word in plain.split(' ').filter { it.isNotEmpty() }) {
                for ((number, part) in word.split(',').withIndex()) {
                    val isWord = number == 0 || '=' in part
                    val name = part.substringBefore('=')
                    when {
                        part.isEmpty() -> Unit
                        isWord && name !in NAMES -> throw IllegalArgumentException(
                            "'$part' is not NAME=VALUE with a NAME of ${NAMES.joinToString()}",
                        )
                        isWord -> pairs.add(name to part.substringAfter('=', "true"))
                        else -> pairs.add(pairs.removeLast().let { (last, value) -> last to "$value,$part" })
                    }
                }
            }
            return pairs.map { (name, value) -> name to value.replace(QUOTED_SPACE, ' ').replace(QUOTED_COMMA, ',') }
        }
    }
}
