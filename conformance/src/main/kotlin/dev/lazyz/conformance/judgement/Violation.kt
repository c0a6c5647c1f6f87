package dev.lazyz.conformance.judgement

import dev.lazyz.Capability
import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.FrameCase

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
