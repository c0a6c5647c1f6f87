package dev.lazyz.cli.options

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.RawOption
import com.github.ajalt.clikt.parameters.options.convert
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.cli.input.Backdrop
import dev.lazyz.cli.input.CameraChoice
import dev.lazyz.cli.input.decimal
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Nearest
import dev.lazyz.filter.VerticalGradient
import dev.lazyz.scenes.ImageSize
import java.nio.file.Path
import org.joml.Vector3d
import org.joml.Vector3dc

/** Returns the constants of an enum class, as they are written on the command line. */
internal fun <E : Enum<E>> words(entries: List<E>): Map<String, E> =
    entries.associateBy { it.name.lowercase().replace('_', '-') }

/** Returns a list of words for a help text. */
internal fun names(all: Collection<String>): String = all.toList().dropLast(1).joinToString() + " or " + all.last()

/** An option whose value is a size: `640x480`, or `512` for a square. */
internal fun RawOption.size(): NullableOption<ImageSize, ImageSize> = convert("WxH") { text ->
    val words = text.split(*TIMES)
    if (words.size > 2 || !words.all(::isWhole)) {
        fail("'$text' is not WIDTHxHEIGHT, such as 640x480, or one number for a square")
    }
    val sides = words.map { side ->
        side.toIntOrNull()?.takeIf { it in 1..Raster.MAX_SIDE }
            ?: fail("width and height must be in 1..${Raster.MAX_SIDE}: $text")
    }
    ImageSize(sides.first(), sides.last())
}

/** An option whose value is a region: `100,50,320x240`, column and row of the upper left pixel, width and height. */
internal fun RawOption.region(): NullableOption<Region, Region> = convert("X,Y,WxH") { text ->
    val parts = text.split(',')
    val words = parts.dropLast(1) + parts.last().split(*TIMES)
    if (parts.size != 3 || words.size != 4 || !words.all(::isWhole)) {
        fail("'$text' is not X,Y,WIDTHxHEIGHT, such as 100,50,320x240")
    }
    val (x, y, width, height) = words.map { it.toIntOrNull()?.takeIf { side -> side <= Raster.MAX_SIDE } ?: -1 }
    if (x < 0 || y < 0) fail("column and row must be in 0..${Raster.MAX_SIDE - 1}: $text")
    if (width < 1 || height < 1) fail("width and height must be in 1..${Raster.MAX_SIDE}: $text")
    Region(x, y, x + width, y + height)
}

private val selectors = mapOf(
    "nearest" to Selector.nearest(),
    "farthest" to Selector.farthest(),
    "count" to Selector.count(),
    "blend" to Selector.blend(),
)

/** An option whose value is the name of a selector, or `kth:K`. */
internal fun RawOption.selector(): NullableOption<Selector, Selector> =
    convert("SELECTOR", CompletionCandidates.Fixed(selectors.keys)) { text ->
        val name = text.lowercase()
        val number = name.substringAfter("kth:", "").takeIf { it.isNotEmpty() }
        when {
            name in selectors -> selectors.getValue(name)
            number != null -> Selector.kthNearest(
                number.toIntOrNull()?.takeIf { it >= 1 } ?: fail("K of kth:K must be a whole number, 1 or more: $text"),
            )
            else -> {
                val hint = Nearest.hint(text, selectors.keys)
                fail("'$text' is not one of nearest, farthest, kth:K, count, blend$hint")
            }
        }
    }

/** An option whose value is an amount of memory: `65536`, `64k`, `16MiB`. */
internal fun RawOption.bytes(): NullableOption<Long, Long> = convert("SIZE") { text ->
    Bytes.parse(text) ?: fail("'$text' is not an amount of memory, such as 65536, 64k or 16MiB")
}

/** An option whose value is an integer for [RenderOptions]. [use] passes it to the constructor, which checks it. */
internal fun RawOption.count(use: (Int) -> RenderOptions): NullableOption<Int, Int> = convert("N") { text ->
    val number = text.toIntOrNull() ?: fail("'$text' is not a whole number")
    try {
        use(number)
    } catch (illegal: IllegalArgumentException) {
        // The message begins with the name of the property in the library
        fail(illegal.message.orEmpty().substringAfter(' '))
    }
    number
}

/** An option whose value is an integer in [range]. */
internal fun RawOption.count(range: IntRange): NullableOption<Int, Int> = convert("N") { text ->
    val number = text.toIntOrNull() ?: fail("'$text' is not a whole number")
    if (number !in range) fail("must be in $range: $text")
    number
}

/** An option whose value is an integer, 0 or more. */
internal fun RawOption.count(): NullableOption<Long, Long> = convert("N") { text ->
    text.toLongOrNull()?.takeIf { it >= 0 } ?: fail("'$text' is not a whole number, 0 or more")
}

/** An option whose value is a decimal number in [range]. In messages, [unit] follows the range. */
internal fun RawOption.number(
    metavar: String,
    range: ClosedRange<Double>,
    unit: String,
): NullableOption<Double, Double> = convert(metavar) { text ->
    val number = decimal(text) ?: fail("'$text' is not a number")
    if (number !in range) fail("must be in ${plain(range.start)}..${plain(range.endInclusive)}$unit: $text")
    number
}

/** An option whose value is a decimal number for which [use] does not throw [IllegalArgumentException]. */
internal fun RawOption.number(metavar: String, use: (Double) -> Unit): NullableOption<Double, Double> =
    convert(metavar) { text ->
        val number = decimal(text) ?: fail("'$text' is not a number")
        try {
            use(number)
        } catch (illegal: IllegalArgumentException) {
            // The message begins with the name of the property in the library
            fail(illegal.message.orEmpty().substringAfter(' '))
        }
        number
    }

/** An option whose value is a point or a direction: `1,-2.5,0`. */
internal fun RawOption.vector(): NullableOption<Vector3dc, Vector3dc> = convert("X,Y,Z") { text ->
    val numbers = text.split(',').mapNotNull(::decimal)
    if (numbers.size != 3 || text.count { it == ',' } != 2) fail("'$text' is not X,Y,Z, such as 1,-2.5,0")
    if (!numbers.all { it.isFinite() }) fail("numbers must be finite: $text")
    Vector3d(numbers[0], numbers[1], numbers[2])
}

/** An option whose value is `fit`, `scene` or the number of a camera. */
internal fun RawOption.camera(): NullableOption<CameraChoice, CameraChoice> =
    convert("CAMERA", CompletionCandidates.Fixed("fit", "scene")) { text ->
        when (text.lowercase()) {
            "fit" -> CameraChoice.Fit
            "scene" -> CameraChoice.OfScene
            else -> CameraChoice.OfModel(
                text.toIntOrNull()?.takeIf { it >= 0 } ?: fail("'$text' is not fit, scene or a number, 0 or more"),
            )
        }
    }

/**
 * An option whose value is a colour: `#rgb`, `#rrggbb`, `#rrggbbaa`, the same without `#` (which begins a comment in
 * shells), or a name of CSS.
 */
internal fun RawOption.color(): NullableOption<Rgba, Rgba> =
    convert("COLOR", Completions.words { Rgba.names }) { text -> color(text) { fail(it) } }

/** An option whose value is a colour, or two colours, the upper and the lower end of a gradient: `skyblue,white`. */
internal fun RawOption.backdrop(): NullableOption<Backdrop, Backdrop> =
    convert("COLOR", Completions.lists { Rgba.names }) { text ->
        val colors = text.split(',').map { word -> color(word) { fail(it) } }
        when {
            colors.size == 1 -> Backdrop(colors[0])
            colors.size > 2 -> fail("a gradient has two colours, TOP,BOTTOM: $text")
            colors.any { it.alpha < 1f } -> fail("the colours of a gradient must be opaque: $text")
            else -> Backdrop(VerticalGradient(colors[0], colors[1]))
        }
    }

/** Returns the colour that [text] describes, or calls [fail] with a message. */
private fun color(text: String, fail: (String) -> Nothing): Rgba = try {
    Rgba.parse(if (text.startsWith('#') || text.lowercase() in Rgba.names) text else "#$text")
} catch (_: IllegalArgumentException) {
    val hint = Nearest.hint(text, Rgba.names)
    fail("'$text' is not a colour: neither a name of CSS nor hexadecimal rgb, rrggbb or rrggbbaa$hint")
}

/** An option whose value is one of the names of [values]. */
internal fun <T : Any> RawOption.oneOf(metavar: String, values: Map<String, T>): NullableOption<T, T> =
    convert(metavar, CompletionCandidates.Fixed(values.keys)) { text -> named(text, values) { fail(it) } }

/** An option whose value is a list of names of [values], separated by commas, each at most once. */
internal fun <T : Any> RawOption.listOf(metavar: String, values: Map<String, T>): NullableOption<List<T>, List<T>> =
    convert(metavar, Completions.lists { values.keys }) { text ->
        val found = LinkedHashSet<T>()
        for (name in text.split(',')) {
            if (!found.add(named(name, values) { fail(it) })) fail("'$name' is named twice: $text")
        }
        found.toList()
    }

/** An option whose value is a file or a folder. */
internal fun RawOption.path(metavar: String = "FILE"): NullableOption<Path, Path> =
    convert(metavar, CompletionCandidates.Path) { text -> fileOf(text) { fail(it) } }

/** Returns the file or folder that [text] names. `-`, which is none, is passed to [fail] as a message. */
internal inline fun fileOf(text: String, fail: (String) -> Nothing): Path =
    if (text == "-") fail("'-', standard input or output, is not possible here: name a file") else Path.of(text)

/** Returns the value called [name], or calls [fail] with a message. */
private fun <T : Any> named(name: String, values: Map<String, T>, fail: (String) -> Nothing): T =
    values[name.lowercase()]
        ?: fail("'$name' is not one of ${values.keys.joinToString()}${Nearest.hint(name, values.keys)}")

/** What stands between a width and a height. */
private val TIMES = charArrayOf('x', 'X', '×')

private fun isWhole(word: String): Boolean {
    val digits = word.removePrefix("-")
    return digits.isNotEmpty() && digits.all { it in '0'..'9' }
}

private fun plain(number: Double): String = if (number % 1.0 == 0.0) number.toLong().toString() else number.toString()
