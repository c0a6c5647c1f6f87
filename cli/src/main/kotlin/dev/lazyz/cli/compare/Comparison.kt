package dev.lazyz.cli.compare

import com.github.ajalt.mordant.rendering.TextAlign
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.SectionBuilder
import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.PlainTable
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.output.StatisticsTable
import dev.lazyz.cli.output.printable
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.world.camera.FittedViewpoint.View
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray

/** The outcome of rendering with one strategy. */
internal sealed interface Outcome {
    /** A complete picture. [difference] is the difference from the reference, or null if they are equal. */
    class Rendered(val counters: Counters, val nanoseconds: Long, val difference: Difference?) : Outcome

    /** The strategy threw [failure], or did not deliver the expected rows. */
    class Failed(val failure: Throwable) : Outcome {
        /** Describes the failure for the user. */
        val message: String
            get() = Failure.mistake(failure)
                ?: listOfNotNull(failure.javaClass.simpleName, failure.message).joinToString(": ")
    }

    /** The scene is translucent, and the strategy does not blend. */
    object NotBlending : Outcome
}

/** The picture with which all others are compared, and the id of its strategy. */
internal class Reference(val id: String, val image: Image)

/**
 * The result of `zcli compare` for one frame: an outcome for each strategy id, in the order in which the strategies
 * ran. Scripts depend on the names in [toJson].
 *
 * @property view one of the requested sides, or null if there were none
 */
internal class Comparison(
    private val input: String,
    val view: View?,
    val shot: PictureFrame,
    val repeat: Int,
    private val warnings: Int,
    val reference: Reference?,
    val outcomes: List<Pair<String, Outcome>>,
) {
    /** What the picture is called in messages. */
    val name: String get() = listOfNotNull(printable(input), view?.name?.lowercase()).joinToString(", ")

    /** Whether no strategy failed, and all pictures are equal. */
    val isGood: Boolean = outcomes.none { (_, outcome) ->
        outcome is Outcome.Failed || (outcome is Outcome.Rendered && outcome.difference != null)
    }

    /** See the function of this name. */
    val bugs: List<Throwable> get() = bugs(outcomes)

    /** Returns the whole result as one line of JSON. */
    fun toJson(): String = Json.of(
        buildJsonObject {
            put("input", input)
            if (view != null) put("view", view.name.lowercase())
            put("width", shot.pixels.width)
            put("height", shot.pixels.height)
            put("repeat", repeat)
            put("warnings", warnings)
            put("identical", isGood)
            put("reference", reference?.id)
            put("pixelHash", reference?.image?.pixelHash())
            put("blank", blank != null)
            put("cropped", shot.isCropped)
            putJsonArray("strategies") { for ((id, outcome) in outcomes) addJsonObject { add(id, outcome) } }
        },
    )

    /** Why there is nothing to see in the picture, or null if there is something, or no picture. */
    val blank: String? by lazy { reference?.image?.let { BlankPictures.reason(it) } }

    /** Returns a sentence that describes the [difference] of the strategy [id]. */
    fun sentence(id: String, difference: Difference): String =
        "$id differs from ${reference?.id} at %,d of %,d pixels, "
            .format(null, difference.pixels, shot.pixels.size) +
            "first at column ${difference.x}, row ${difference.y}"

    /** Returns counters and time of [outcome], under the names of the statistics of `zcli render`. */
    fun statistics(outcome: Outcome.Rendered): Map<String, Any> =
        Statistics.counted(outcome.counters, shot.pixels, shot.factor) +
            ("millis" to Statistics.millis(outcome.nanoseconds))

    private fun JsonObjectBuilder.add(id: String, outcome: Outcome) {
        put("strategy", id)
        when (outcome) {
            is Outcome.NotBlending -> put("outcome", "not blending")

            is Outcome.Failed -> {
                put("outcome", "failed")
                put("message", outcome.message)
            }

            is Outcome.Rendered -> {
                val difference = outcome.difference
                val word = when {
                    difference != null -> "different"
                    id == reference?.id -> "reference"
                    else -> "identical"
                }
                put("outcome", word)
                for ((key, value) in statistics(outcome)) put(key, Json.primitive(value))
                difference?.addTo(this)
            }
        }
    }

    companion object {
        /**
         * Returns the exceptions that built-in strategies threw. They are bugs in Lazy Z, except those for which
         * [Failure] has a message.
         */
        fun bugs(outcomes: List<Pair<String, Outcome>>): List<Throwable> =
            outcomes.filter { (id, _) -> Strategies.isBuiltIn(id) }
                .mapNotNull { (_, outcome) -> (outcome as? Outcome.Failed)?.failure }
                .filter { Failure.mistake(it) == null }
    }
}

/** Formats a [Comparison] as a table with a row for each strategy, followed by the differences. */
internal object ComparisonTable {
    private val numbers = mapOf(
        "shadingCalls" to "shading calls",
        "depthEvaluations" to "depth evaluations",
        "overdraw" to "overdraw",
        "peakBytes" to "working memory",
        "millis" to "ms",
    )

    fun of(comparison: Comparison): String = table(comparison) + differences(comparison)

    private fun table(comparison: Comparison): String = PlainTable.of {
        for (column in numbers.keys.indices) column(2 + column) { align = TextAlign.RIGHT }
        header {
            cellBorders = Borders.ALL
            rowFrom(listOf("strategy", "identical") + numbers.values)
        }
        body {
            for ((id, outcome) in comparison.outcomes) {
                when (outcome) {
                    is Outcome.Rendered ->
                        rowFrom(listOf(id, verdict(id, outcome, comparison)) + values(outcome, comparison))
                    is Outcome.Failed -> textRow(id, "failed: ${outcome.message}")
                    is Outcome.NotBlending -> textRow(id, "does not blend")
                }
            }
        }
    }

    /** Adds a row without numbers. Its text spans the columns of the numbers. */
    private fun SectionBuilder.textRow(id: String, words: String) = row {
        cell(id)
        cell(words) {
            columnSpan = 1 + numbers.size
            align = TextAlign.LEFT
        }
    }

    private fun verdict(id: String, outcome: Outcome.Rendered, comparison: Comparison): String = when {
        outcome.difference != null -> "no"
        id == comparison.reference?.id -> "(reference)"
        else -> "yes"
    }

    private fun values(outcome: Outcome.Rendered, comparison: Comparison): List<String> {
        val statistics = comparison.statistics(outcome)
        return numbers.keys.map { StatisticsTable.readable(it, statistics.getValue(it)) }
    }

    private fun differences(comparison: Comparison): String = buildString {
        val reference = comparison.reference ?: return@buildString
        for ((id, outcome) in comparison.outcomes) {
            val difference = (outcome as? Outcome.Rendered)?.difference ?: continue
            val width = maxOf(id.length, reference.id.length)
            appendLine()
            appendLine(comparison.sentence(id, difference) + ":")
            appendLine("  ${reference.id.padEnd(width)}  ${difference.expected}")
            appendLine("  ${id.padEnd(width)}  ${difference.actual}")
        }
    }
}
