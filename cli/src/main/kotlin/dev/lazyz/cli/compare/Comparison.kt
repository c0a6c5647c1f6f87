package dev.lazyz.cli.compare

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.cli.input.View
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.Statistics
import dev.lazyz.cli.strategies.Strategies

/** What came of rendering with one strategy. */
internal sealed interface Outcome {
    /** A whole picture, with what it took; [difference] is from the reference, null if there is none. */
    class Rendered(val counters: Counters, val nanoseconds: Long, val difference: Difference?) : Outcome

    /** The strategy threw [failure], or did not hand out the rows that it ought to. */
    class Failed(val failure: Throwable) : Outcome {
        /** What went wrong, in words. */
        val message: String
            get() = Failure.mistake(failure)
                ?: listOfNotNull(failure.javaClass.simpleName, failure.message).joinToString(": ")
    }

    /** The scene is translucent, and the strategy is not for such. */
    object NotBlending : Outcome
}

/** The picture that the others are held against, and whose it is. */
internal class Reference(val id: String, val image: Image)

/**
 * What `zcli compare` found out about one frame: an outcome for each strategy, by id, in the order in which they ran.
 * The names of [entries] are an interface to scripts.
 *
 * @property view one of several that were asked for, or null
 */
internal class Comparison(
    private val input: String,
    val view: View?,
    val frame: Frame,
    val repeat: Int,
    private val warnings: Int,
    val reference: Reference?,
    val outcomes: List<Pair<String, Outcome>>,
) {
    /** Whether no strategy failed, and none gave another picture. */
    val isGood: Boolean = outcomes.none { (_, outcome) ->
        outcome is Outcome.Failed || (outcome is Outcome.Rendered && outcome.difference != null)
    }

    /** What strategies of ours threw: our bugs, unless all that lacked was memory. */
    val bugs: List<Throwable>
        get() = outcomes.filter { (id, _) -> Strategies.isBuiltIn(id) }
            .mapNotNull { (_, outcome) -> (outcome as? Outcome.Failed)?.failure }
            .filter { Failure.mistake(it) == null }

    /** All of it, for [Json]. */
    val entries: Map<String, Any?>
        get() = mapOf(
            "input" to input,
            *listOfNotNull(view?.let { "view" to it.name.lowercase() }).toTypedArray(),
            "width" to frame.width,
            "height" to frame.height,
            "repeat" to repeat,
            "warnings" to warnings,
            "identical" to isGood,
            "reference" to reference?.id,
            "pixelHash" to reference?.image?.pixelHash(),
            "strategies" to outcomes.map { (id, outcome) -> mapOf("strategy" to id) + entries(id, outcome) },
        )

    /** Whether all that was rendered is background. */
    val isBlank: Boolean get() = reference?.image?.visible == 0

    /** Says by how much the strategy called [id] differs. */
    fun sentence(id: String, difference: Difference): String =
        "$id differs from ${reference?.id} at %,d of %,d pixels, ".format(null, difference.pixels, frame.region.size) +
            "first at column ${difference.x}, row ${difference.y}"

    /** What [outcome] took, as the statistics of a rendering have it. */
    fun statistics(outcome: Outcome.Rendered): Map<String, Any> =
        Statistics.counted(outcome.counters, frame.region) + ("millis" to Statistics.millis(outcome.nanoseconds))

    private fun entries(id: String, outcome: Outcome): Map<String, Any?> = when (outcome) {
        is Outcome.NotBlending -> mapOf("outcome" to "not blending")
        is Outcome.Failed -> mapOf("outcome" to "failed", "message" to outcome.message)
        is Outcome.Rendered -> {
            val difference = outcome.difference
            val word = when {
                difference != null -> "different"
                id == reference?.id -> "reference"
                else -> "identical"
            }
            mapOf("outcome" to word) + statistics(outcome) + difference?.entries.orEmpty()
        }
    }
}
