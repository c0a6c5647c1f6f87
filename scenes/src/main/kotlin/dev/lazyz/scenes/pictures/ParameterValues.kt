package dev.lazyz.scenes.pictures

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.filter.PixelBackground.VerticalGradient
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.text.EditDistance
import java.nio.file.Path
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * The values of a [PictureParameter], and the words that mean them. Thread safe.
 *
 * @property form the form of a word in capital letters, such as `WxH`; null if the name alone is enough, as for options
 *   that switch something on
 */
public abstract class ParameterValues<T : Any> internal constructor(public val form: String?) {
    /** Words that complete what a user types: all that there are, or names beside other forms. */
    public open val words: Collection<String> get() = emptyList()

    /** How a word is completed. */
    public open val completion: WordCompletion get() = WordCompletion.NONE

    /** Whether all words are decimal numbers. */
    public open val isNumber: Boolean get() = words.isNotEmpty() && words.all { it.toDoubleOrNull() != null }

    /**
     * Returns the value that [word] means.
     *
     * @throws IllegalArgumentException if it means none; the message is for the user
     */
    public abstract fun read(word: String): T

    /** Returns the words that mean [value], one each time the parameter is repeated. Colours are rounded to 8 bits. */
    internal open fun words(value: T): List<String> = listOf("$value")

    /** Checks a value that comes from a program. */
    internal open fun check(value: T) = Unit

    /** Returns both values, one after the other, if the parameter can be repeated, or [next]. */
    internal open fun added(before: T, next: T): T = next

    override fun toString(): String = form ?: "on"
}

/** How what a user types for a parameter is completed. */
public enum class WordCompletion {
    /** Not at all. */
    NONE,

    /** As one of the words, which are all there are. */
    CHOICE,

    /** As one of the words, beside which other forms exist. */
    NAME,

    /** As words separated by commas. */
    NAMES,

    /** As the path of a file. */
    FILE,
}

/** A value that is there or not. */
internal class SwitchValues : ParameterValues<Boolean>(null) {
    override fun read(word: String): Boolean = when (word.lowercase()) {
        "true" -> true
        "false" -> false
        else -> unfit("'$word' is not one of true, false")
    }
}

/** One of a few values with a name. */
public class NamedValues<T : Any>(form: String, private val values: Map<String, T>) : ParameterValues<T>(form) {
    override val words: Collection<String> get() = values.keys
    override val completion: WordCompletion get() = WordCompletion.CHOICE

    override fun read(word: String): T = values[word.lowercase()]
        ?: unfit("'$word' is not one of ${words.joinToString()}${EditDistance.hint(word, words)}")

    override fun words(value: T): List<String> = listOf(values.entries.first { it.value == value }.key)

    override fun check(value: T) = require(value in values.values) { "$value is not one of ${words.joinToString()}" }

    public companion object {
        /** Returns the constants of an enum class by their words: lower case, with hyphens. */
        @JvmStatic
        public fun <E : Enum<E>> words(entries: List<E>): Map<String, E> =
            entries.associateBy { it.name.lowercase().replace('_', '-') }

        /** Returns [words] as a sentence lists them: `a, b or c`. */
        @JvmStatic
        public fun list(words: Collection<String>): String =
            words.toList().dropLast(1).joinToString() + " or " + words.last()
    }
}

/** A decimal number in [range]; in messages, [unit] follows the range. */
public class RangeValues(form: String, private val range: ClosedRange<Double>, private val unit: String) :
    ParameterValues<Double>(form) {
    override val isNumber: Boolean get() = true

    override fun read(word: String): Double = number(word).also { checked(it, word) }

    override fun check(value: Double) = checked(value, value)

    private fun checked(value: Double, shown: Any) =
        require(value in range) { "must be in ${plain(range.start)}..${plain(range.endInclusive)}$unit: $shown" }

    private fun plain(number: Double): String = if (number % 1.0 == 0.0) "${number.toLong()}" else "$number"
}

/** A decimal number that [check] accepts; the message of the exception begins with the name of a property. */
internal abstract class CheckedValues(form: String) : ParameterValues<Double>(form) {
    override val isNumber: Boolean get() = true

    abstract fun checked(value: Double)

    override fun check(value: Double) = try {
        checked(value)
    } catch (illegal: IllegalArgumentException) {
        unfit(illegal.message.orEmpty().substringAfter(' '))
    }

    override fun read(word: String): Double = number(word).also { check(it) }
}

/** A size: `640x480`, or `512` for a square. */
internal class SizeValues : ParameterValues<ImageSize>("WxH") {
    override fun read(word: String): ImageSize {
        val sides = word.split(*TIMES)
        if (sides.size > 2 || !sides.all(::isWhole)) {
            unfit("'$word' is not WIDTHxHEIGHT, such as 640x480, or one number for a square")
        }
        val (width, height) = listOf(sides.first(), sides.last()).map { side ->
            side.toIntOrNull()?.takeIf { it in 1..Raster.MAX_SIDE }
                ?: unfit("width and height must be in 1..${Raster.MAX_SIDE}: $word")
        }
        return ImageSize(width, height)
    }
}

/** A region: `100,50,320x240`, column and row of the upper left pixel, width and height. */
internal class RegionValues : ParameterValues<Region>("X,Y,WxH") {
    override fun read(word: String): Region {
        val parts = word.split(',')
        val words = parts.dropLast(1) + parts.last().split(*TIMES)
        if (parts.size != 3 || words.size != 4 || !words.all(::isWhole)) {
            unfit("'$word' is not X,Y,WIDTHxHEIGHT, such as 100,50,320x240")
        }
        val (x, y, width, height) = words.map { it.toIntOrNull()?.takeIf { side -> side <= Raster.MAX_SIDE } ?: -1 }
        if (x < 0 || y < 0) unfit("column and row must be in 0..${Raster.MAX_SIDE - 1}: $word")
        if (width < 1 || height < 1) unfit("width and height must be in 1..${Raster.MAX_SIDE}: $word")
        return Region(x, y, x + width, y + height)
    }

    override fun words(value: Region): List<String> =
        listOf("${value.columnStart},${value.rowStart},${value.width}x${value.height}")
}

/** A scale: `1:2`, or `2.5:1`. */
internal class ScaleValues : ParameterValues<DrawingScale>("PAPER:MODEL") {
    override fun read(word: String): DrawingScale {
        val numbers = word.split(':').mapNotNull(::decimal)
        if (numbers.size != 2 || word.count { it == ':' } != 1) unfit("'$word' is not PAPER:MODEL, such as 1:2")
        return try {
            DrawingScale(numbers[0], numbers[1])
        } catch (_: IllegalArgumentException) {
            unfit("both numbers must be above 0: $word")
        }
    }
}

/** A point or a direction: `1,-2.5,0`. */
internal class VectorValues : ParameterValues<Vector3dc>("X,Y,Z") {
    override fun read(word: String): Vector3dc {
        val numbers = word.split(',').mapNotNull(::decimal)
        if (numbers.size != 3 || word.count { it == ',' } != 2) unfit("'$word' is not X,Y,Z, such as 1,-2.5,0")
        if (!numbers.all { it.isFinite() }) unfit("numbers must be finite: $word")
        return Vector3d(numbers[0], numbers[1], numbers[2])
    }

    override fun words(value: Vector3dc): List<String> = listOf("${value.x()},${value.y()},${value.z()}")

    override fun check(value: Vector3dc) = require(value.isFinite) { "numbers must be finite: $value" }
}

/**
 * A colour: `#rgb`, `#rrggbb`, `#rrggbbaa`, the same without `#` (which begins a comment in shells), or a name of CSS.
 */
internal class ColorValues : ParameterValues<Rgba>("COLOR") {
    override val words: Collection<String> get() = Rgba.names
    override val completion: WordCompletion get() = WordCompletion.NAME

    override fun read(word: String): Rgba = color(word)

    override fun words(value: Rgba): List<String> = listOf(hexadecimal(value))
}

/** A colour; two colours, the upper and the lower end of a gradient: `skyblue,white`; or `environment`. */
internal class BackdropValues : ParameterValues<Backdrop>("COLOR") {
    override val words: Collection<String> get() = Rgba.names + ENVIRONMENT
    override val completion: WordCompletion get() = WordCompletion.NAMES

    override fun read(word: String): Backdrop {
        if (word.lowercase() == ENVIRONMENT) return Backdrop.ENVIRONMENT
        val colors = word.split(',').map(::color)
        return when {
            colors.size == 1 -> Backdrop(colors[0])
            colors.size > 2 -> unfit("a gradient has two colours, TOP,BOTTOM: $word")
            colors.any { it.alpha < 1f } -> unfit("the colours of a gradient must be opaque: $word")
            else -> Backdrop(VerticalGradient(colors[0], colors[1]))
        }
    }

    override fun words(value: Backdrop): List<String> = listOf(
        value.gradient?.let { "${hexadecimal(it.top)},${hexadecimal(it.bottom)}" }
            ?: if (value.isPlain) hexadecimal(value.color) else ENVIRONMENT,
    )

    private companion object {
        const val ENVIRONMENT = "environment"
    }
}

/** `fit`, `scene`, or the number or the name of a camera. */
internal class CameraValues : ParameterValues<CameraChoice>("CAMERA") {
    override val words: Collection<String> get() = listOf("fit", "scene")
    override val completion: WordCompletion get() = WordCompletion.CHOICE

    override fun read(word: String): CameraChoice = when (word.lowercase()) {
        "fit" -> CameraChoice.FIT
        "scene" -> CameraChoice.SCENE
        "" -> unfit("it is empty")
        else -> {
            val number = word.toIntOrNull()
            if (number != null && number < 0) unfit("a number must be 0 or more: $word")
            number?.let(CameraChoice::ofModel) ?: CameraChoice.ofModel(word)
        }
    }
}

/** Any text. */
internal class TextValues(form: String) : ParameterValues<String>(form) {
    override fun read(word: String): String = word.ifEmpty { unfit("it is empty") }
}

/** Numbers of scenes. */
internal class ScenesValues : ParameterValues<Int>("N") {
    override val isNumber: Boolean get() = true

    override fun read(word: String): Int =
        word.toIntOrNull()?.takeIf { it >= 0 } ?: unfit("'$word' is not a number, 0 or more")
}

/** Planes that cut, each a word. */
internal class CutValues : ParameterValues<List<CutPlane>>("PLANE") {
    override fun read(word: String): List<CutPlane> =
        listOf(CutPlane.parse(word) ?: unfit("'$word' is not a plane, such as x=0.5, -z=10% or a,b,c,d"))

    override fun added(before: List<CutPlane>, next: List<CutPlane>): List<CutPlane> = before + next

    override fun words(value: List<CutPlane>): List<String> = value.map { it.text }
}

/** A file. */
public open class FileValues(form: String = "FILE") : ParameterValues<Path>(form) {
    override val completion: WordCompletion get() = WordCompletion.FILE

    override fun read(word: String): Path =
        if (word == "-") unfit("'-', standard input or output, is not possible here: name a file") else Path.of(word)
}

/** `studio`, or a file. */
internal class EnvironmentValues : FileValues() {
    override val words: Collection<String> get() = listOf("${PictureSettings.STUDIO}")
}

private fun unfit(message: String): Nothing = throw IllegalArgumentException(message)

private fun number(word: String): Double = decimal(word) ?: unfit("'$word' is not a number")

private fun color(word: String): Rgba = try {
    Rgba.parse(if (word.startsWith('#') || word.lowercase() in Rgba.names) word else "#$word")
} catch (_: IllegalArgumentException) {
    val hint = EditDistance.hint(word, Rgba.names)
    unfit("'$word' is not a colour: neither a name of CSS nor hexadecimal rgb, rrggbb or rrggbbaa$hint")
}

/** Returns [color] as `rrggbb`, or `rrggbbaa`. */
private fun hexadecimal(color: Rgba): String {
    val argb = color.toArgb()
    val rgb = "%06x".format(argb and 0xFFFFFF)
    return if (argb ushr 24 == 0xFF) rgb else rgb + "%02x".format(argb ushr 24)
}

/** What stands between a width and a height. */
private val TIMES = charArrayOf('x', 'X', '×')

private fun isWhole(word: String): Boolean {
    val digits = word.removePrefix("-")
    return digits.isNotEmpty() && digits.all { it in '0'..'9' }
}
