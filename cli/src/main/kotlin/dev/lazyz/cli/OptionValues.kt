package dev.lazyz.cli

import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.RawOption
import com.github.ajalt.clikt.parameters.options.convert
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.scenes.ImageSize

private val sizeForm = Regex("""(-?\d+)[xX×](-?\d+)""")

private val numberForm = Regex("""[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?""")

/** Takes `640x480`. */
internal fun RawOption.size(): NullableOption<ImageSize, ImageSize> = convert("WxH") { text ->
    val (width, height) = sizeForm.matchEntire(text)?.destructured
        ?: fail("'$text' is not WIDTHxHEIGHT, such as 640x480")
    val sides = listOf(width, height).map { side ->
        side.toIntOrNull()?.takeIf { it in 1..Raster.MAX_SIDE }
            ?: fail("width and height must be in 1..${Raster.MAX_SIDE}: $text")
    }
    ImageSize(sides[0], sides[1])
}

/** Takes a decimal number in [range], which [unit] follows in messages. */
internal fun RawOption.number(
    metavar: String,
    range: ClosedRange<Double>,
    unit: String,
): NullableOption<Double, Double> = convert(metavar) { text ->
    val number = if (numberForm.matches(text)) text.toDouble() else fail("'$text' is not a number")
    if (number !in range) fail("must be in ${plain(range.start)}..${plain(range.endInclusive)}$unit: $text")
    number
}

/** Takes `#rgb`, `#rrggbb`, `#rrggbbaa`, the same without `#` (which shells take for a comment), or a name. */
internal fun RawOption.color(): NullableOption<Rgba, Rgba> = convert("COLOR") { text ->
    try {
        Rgba.parse(if (text.matches(Regex("[0-9a-fA-F]{3,8}"))) "#$text" else text.lowercase())
    } catch (unknown: IllegalArgumentException) {
        val hint = Nearest.hint(text, listOf("transparent", "black", "white"))
        fail("'$text' is not black, white, transparent, nor hexadecimal rgb, rrggbb or rrggbbaa$hint")
    }
}

/** Takes one of the names of [values]. */
internal fun <T : Any> RawOption.oneOf(metavar: String, values: Map<String, T>): NullableOption<T, T> =
    convert(metavar) { text ->
        values[text.lowercase()]
            ?: fail("'$text' is not one of ${values.keys.joinToString()}${Nearest.hint(text, values.keys)}")
    }

private fun plain(number: Double): String = if (number % 1.0 == 0.0) number.toLong().toString() else number.toString()
