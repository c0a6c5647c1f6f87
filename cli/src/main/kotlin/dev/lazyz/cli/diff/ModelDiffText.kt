package dev.lazyz.cli.diff

import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.output.printable
import dev.lazyz.scenes.diff.Measure
import dev.lazyz.scenes.diff.ModelDifference
import dev.lazyz.scenes.diff.ModelDifference.Change
import dev.lazyz.scenes.diff.PartDifference
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.abs
import kotlinx.serialization.json.JsonElement

/** The [difference] of the models [old] and [new] as text and as JSON. Scripts depend on the names in [toJson]. */
internal class ModelDiffText(private val old: String, private val new: String, val difference: ModelDifference) {
    /** The result in one line. */
    val verdict: String = "$new ${if (difference.isEqual) "is equal to" else "differs from"} $old"

    /** The parts that differ; none if both models have only one. */
    val changedParts: List<PartDifference> =
        if (difference.parts.size > 1) difference.parts.filter { !it.isEqual } else emptyList()

    /** What changed, in words. */
    val pixels: String = Change.entries.joinToString(prefix = "pixels: ") {
        counted(difference.count(it), it.id, it.id)
    }

    /** What is printed. */
    val lines: String = buildString {
        appendLine(printable(verdict))
        appendLine(pixels)
        append("".padEnd(COLUMN))
        appendLine(listOf("old", "new", "difference").joinToString("") { it.padStart(COLUMN) })
        for (measure in Measure.entries) {
            append(title(measure).padEnd(COLUMN))
            appendLine(texts(measure, difference.whole).joinToString("") { it.padStart(COLUMN) })
        }
        for (part in changedParts) appendLine("${part.change} part: ${printable(part.name)}${details(part)}")
    }

    fun toJson(): JsonElement = Json.element(difference.toData(old, new))

    companion object {
        private const val COLUMN = 14

        fun title(measure: Measure): String = measure.name.lowercase().replace('_', ' ')

        /** Returns [measure] of [part] before and after, and the difference, as text; `-` if there is none. */
        fun texts(measure: Measure, part: PartDifference): List<String> {
            val texts = values(measure, part).map { it?.let { value -> text(measure, value) } ?: "-" }
            return texts.take(2) + (if ((part.difference(measure) ?: 0.0) > 0) "+" else "").plus(texts[2])
        }

        /** Returns the numbers of [part] that changed: `, area 1 to 2`. */
        fun details(part: PartDifference): String = Measure.entries.map { it to texts(it, part) }
            .filter { (_, texts) -> "-" !in texts && texts[2] != "0" }
            .joinToString("") { (measure, texts) -> ", ${title(measure)} ${texts[0]} to ${texts[1]}" }

        private fun values(measure: Measure, part: PartDifference): List<Double?> =
            listOf(part.before?.get(measure), part.after?.get(measure), part.difference(measure))

        private fun text(measure: Measure, value: Double): String {
            if (measure.isCount) return "%,d".format(null, value.toLong())
            val digits = BigDecimal(value).round(MathContext(DIGITS)).stripTrailingZeros()
            return if (value == 0.0 || abs(value) in 1e-4..1e9) digits.toPlainString() else digits.toString()
        }

        private const val DIGITS = 7
    }
}
