package dev.lazyz.conformance.judgement

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.oracle.covers

/**
 * Renders [case] with [renderer] and checks the result. Failure messages name the renderer and contain the code of the
 * frame.
 *
 * @param how how the renderer differs from the default, for messages; empty if it does not
 */
internal class Judgement(private val renderer: Renderer, private val case: FrameCase, private val how: String = "") {
    init {
        TryUnderWay.current?.saw(case, how)
    }

    private val isAgain = TryUnderWay.current?.isAgain(renderer) ?: false

    /** The frame, rendered row by row. */
    val rendering: Recording = attempt { Recording.of(renderer, case.frame) }

    /** Fails unless the picture equals the reference renderer's picture, bit for bit. */
    fun equalsReference(): Judgement = equalsPictureOf(ReferenceRenderer())

    /** Fails unless the picture equals that of [oracle], bit for bit. */
    fun equalsPictureOf(oracle: Renderer): Judgement = equalsPicture(Recording.of(oracle, case.frame).image)

    /** Fails unless the picture is [expected], bit for bit. */
    fun equalsPicture(expected: Image): Judgement = apply {
        difference(expected, rendering.image)?.let { fail("", it) }
    }

    /** Fails unless rendering the frame into memory gives the same picture. */
    fun equalsItsImage(): Judgement = apply {
        val image = attempt { renderer.render(case.frame) }
        if (image.region != rendering.image.region) fail("into memory: ${differenceInWords(rendering.image, image)}")
        difference(rendering.image, image)?.let { fail("into memory: ", it) }
    }

    /** Fails unless the rows of the frame's region were delivered from top to bottom, each once. */
    fun rowsInOrder(): Judgement = apply {
        val expected = (case.frame.region.rowStart until case.frame.region.rowEnd).toList()
        if (rendering.rows == expected) return@apply
        val words = "rows arrived as ${rendering.rows}, not as $expected"
        throw violation(words, rendering.image, rendering.image, null, areRowsWrong = true)
    }

    /** Fails with the message [what]. */
    fun fail(what: String, cause: Throwable? = null): Nothing {
        val expected = Recording.of(ReferenceRenderer(), case.frame).image
        throw violation(what, expected, rendering.image, cause)
    }

    /** Fails because of a [difference]; [lead] is put before its description. */
    fun fail(lead: String, difference: FirstDifference): Nothing =
        throw violation("$lead$difference", difference.expected, difference.actual, null)

    private fun violation(
        what: String,
        expected: Image?,
        actual: Image?,
        cause: Throwable?,
        areRowsWrong: Boolean = false,
    ) = Violation(
        message(what), case, expected, actual, cause,
        isConfigured = how.isNotEmpty(),
        isAgain = isAgain,
        areRowsWrong = areRowsWrong,
    )

    private fun message(what: String): String =
        "${renderer.id}${if (how.isEmpty()) "" else " with $how"}: $what\nin\n$case"

    private fun <T> attempt(block: () -> T): T = try {
        block()
    } catch (e: Throwable) {
        val where = if (e is Error) e.stackTrace.take(MOST_CALLS).joinToString("") { "\n    at $it" } else ""
        throw violation("threw $e$where", null, null, e)
    }

    private companion object {
        /** Calls that are enough to find an error, or the recursion that caused it. */
        const val MOST_CALLS = 6
    }
}

/**
 * Fails unless [renderer] rejects [case] before it delivers a row, with a message that has the index of a translucent
 * primitive.
 */
internal fun refused(renderer: Renderer, case: FrameCase) {
    var rows = 0
    val answer = try {
        renderer.render(case.frame) { _, _, _, _ -> rows++ }
        "renders it"
    } catch (e: IllegalArgumentException) {
        val index = case.frame.primitives.indexOfFirst { it.isTranslucent }
        val isNamed = numbersIn(e.message.orEmpty()).any { case.frame.primitives.getOrNull(it)?.isTranslucent == true }
        if (rows == 0 && isNamed) return
        if (rows > 0) "delivers $rows rows before it throws" else "does not name primitive $index: ${e.message}"
    } catch (e: Exception) {
        "throws $e"
    }
    throw Violation("${renderer.id} does not blend, and $answer\nin\n$case", case)
}

/** Returns the whole numbers that are words of [text]. */
internal fun numbersIn(text: String): List<Int> =
    text.map { if (it.isLetterOrDigit() || it == '_') it else ' ' }.joinToString("").split(' ')
        .filter { word -> word.all { it in '0'..'9' } }.mapNotNull { it.toIntOrNull() }

/** Returns whether the primitives [a] and [b] both cover column [x] of row [y], at the same depth. */
internal fun Frame.isTie(a: Int, b: Int, x: Int, y: Int): Boolean =
    covers(a, x, y) && covers(b, x, y) && primitives[a].depth(x, y) == primitives[b].depth(x, y)

private fun Frame.covers(index: Int, x: Int, y: Int): Boolean = primitives.getOrNull(index)?.covers(x, y) ?: false

/**
 * Thrown when a renderer breaks a rule for [case]. Contains what reports show.
 *
 * @param expected the oracle's picture, or null if it is not relevant
 * @param actual the renderer's picture, or null if there is none
 * @param isConfigured whether the renderer was configured with options
 * @param isAgain whether the same renderer had rendered another frame before, in the same try
 * @param areRowsWrong whether rows came in another order, or not each once
 * @param isPlain whether the message is the whole cause, however many rules are broken by it
 */
internal class Violation(
    message: String,
    val case: FrameCase,
    val expected: Image? = null,
    val actual: Image? = null,
    cause: Throwable? = null,
    val isConfigured: Boolean = false,
    val isAgain: Boolean = false,
    val areRowsWrong: Boolean = false,
    val isPlain: Boolean = false,
) : AssertionError(message, cause)

/**
 * Thrown when a try did not end before its deadline. [case] is the frame that was being rendered, if any, and
 * [isAsleep] whether it was waiting, not running.
 */
internal class TimedOut(message: String, val case: FrameCase?, val isAsleep: Boolean = false) : AssertionError(message)

/** Thrown when a try was given up, although it may have been in time: the machine was too busy to tell. No failure. */
internal class Inconclusive(message: String) : RuntimeException(message)

/** A process of an earlier part of the run ended during a try. */
internal class ProcessEnded(message: String) : AssertionError(message)

/** Returns the error with which the renderer crashed if [thrown] ended a try; null if it did not crash. */
internal fun crash(thrown: Throwable): Error? =
    if (thrown is AssertionError) (thrown as? Violation)?.cause as? Error else thrown as? Error

/** Ends a rule that does not apply, for this [reason]. Reported, but not a failure. */
internal class NotDeclared(reason: String) : RuntimeException(reason)

/** Ends the rule, as not applicable, if [renderer] does not declare [capability]. */
internal fun requireDeclared(renderer: Renderer, capability: Capability) {
    if (capability !in renderer.capabilities) throw NotDeclared("$capability is not declared")
}

/** Returns [renderer] if primitives can be passed to it one by one; otherwise ends the rule, as not applicable. */
internal fun requireStreaming(renderer: Renderer): StreamingRenderer =
    renderer as? StreamingRenderer ?: throw NotDeclared("it is not a StreamingRenderer")

/** Ends the rule, as not applicable, because this JVM cannot make the required measurement, for this [reason]. */
internal fun notMeasured(reason: String): Nothing = throw NotDeclared("not measured: $reason")

/** Fails with the message [what], for rules without a frame to show. */
internal fun fail(renderer: Renderer, what: String): Nothing = throw AssertionError("${renderer.id}: $what")
