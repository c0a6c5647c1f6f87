package dev.lazyz.conformance.judgement

import dev.lazyz.Capability
import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase

/**
 * A renderer breaks a rule on [case], with what a report shows of it.
 *
 * @param expected what the oracle makes of the frame, or null if that is not to the point
 * @param actual what the renderer made of it, or null if it made nothing
 * @param isConfigured whether the renderer was configured with options
 * @param isAgain whether the same renderer had rendered another frame before, in the same try
 */
internal class Violation(
    message: String,
    val case: FrameCase,
    val expected: Image? = null,
    val actual: Image? = null,
    cause: Throwable? = null,
    val isConfigured: Boolean = false,
    val isAgain: Boolean = false,
) : AssertionError(message, cause)

/** A try was not over at its deadline; [case] is what it was rendering, if that is a frame. */
internal class TimedOut(message: String, val case: FrameCase?) : AssertionError(message)

/** A process that an earlier part of the run was made in ended during a try. */
internal class ProcessEnded(message: String) : AssertionError(message)

/** Ends a rule that does not apply, for this [reason]. Reports say so; it is no failure. */
internal class NotDeclared(reason: String) : RuntimeException(reason)

/** The rule applies to those that declare [capability]: it ends here if [renderer] does not. */
internal fun requireDeclared(renderer: Renderer, capability: Capability) {
    if (capability !in renderer.capabilities) throw NotDeclared("$capability is not declared")
}

/** The rule does not apply: this JVM cannot measure what it is about, for this [reason]. */
internal fun notMeasured(reason: String): Nothing = throw NotDeclared("not measured: $reason")

/** Fails because of [what], where there is no frame to show. */
internal fun fail(renderer: Renderer, what: String): Nothing = throw AssertionError("${renderer.id}: $what")
