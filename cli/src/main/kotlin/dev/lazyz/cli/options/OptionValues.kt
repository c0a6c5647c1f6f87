package dev.lazyz.cli.options

import com.github.ajalt.clikt.completion.CompletionCandidates
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.RawOption
import com.github.ajalt.clikt.parameters.options.convert
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.cli.output.Bytes
import dev.lazyz.scenes.pictures.FileValues
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.pictures.ParameterValues
import dev.lazyz.scenes.pictures.RangeValues
import dev.lazyz.scenes.text.EditDistance
import java.nio.file.Path

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
                val hint = EditDistance.hint(text, selectors.keys)
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

/** An option whose value is one of [values]. */
internal fun <T : Any> RawOption.value(values: ParameterValues<T>): NullableOption<T, T> =
    convert(values.form.orEmpty(), Completions.of(values)) { values.read(it) }

/** An option whose value is a decimal number in [range]. In messages, [unit] follows the range. */
internal fun RawOption.number(
    metavar: String,
    range: ClosedRange<Double>,
    unit: String,
): NullableOption<Double, Double> = value(RangeValues(metavar, range, unit))

/** An option whose value is one of the names of [values]. */
internal fun <T : Any> RawOption.oneOf(metavar: String, values: Map<String, T>): NullableOption<T, T> =
    value(NamedValues(metavar, values))

/** An option whose value is a list of names of [values], separated by commas, each at most once. */
internal fun <T : Any> RawOption.listOf(metavar: String, values: Map<String, T>): NullableOption<List<T>, List<T>> =
    convert(metavar, Completions.lists { values.keys }) { text ->
        val named = NamedValues(metavar, values)
        val found = LinkedHashSet<T>()
        for (name in text.split(',')) {
            if (!found.add(named.read(name))) fail("'$name' is named twice: $text")
        }
        found.toList()
    }

/** An option whose value is a file or a folder. */
internal fun RawOption.path(metavar: String = "FILE"): NullableOption<Path, Path> = value(FileValues(metavar))
