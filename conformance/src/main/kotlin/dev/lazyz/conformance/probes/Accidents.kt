package dev.lazyz.conformance.probes

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Renderer
import dev.lazyz.ShadingCursor
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Rendering
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.oracle.ReferenceRenderer
import java.io.IOException
import java.util.concurrent.CancellationException
import java.util.concurrent.atomic.AtomicInteger

/**
 * What code of the caller's may throw: what renderers catch for reasons of their own, such as the end of an array or of a
 * coroutine; and checked exceptions, too, since Kotlin and lambdas let them pass.
 */
internal enum class Planted(private val throwable: (String) -> Throwable) {
    EXCEPTION({ IllegalStateException(it) }),
    INDEX({ IndexOutOfBoundsException(it) }),
    NULL({ NullPointerException(it) }),
    END({ NoSuchElementException(it) }),
    CANCELLATION({ CancellationException(it) }),
    ERROR({ Error(it) }),
    CHECKED({ IOException(it) }),
    ;

    /** Returns a new one. */
    fun make(): Throwable = throwable("planted")
}

/** What a renderer asks a primitive. */
internal enum class Question { SPANS, DEPTH, COLOUR }

/**
 * The primitives of [frame], which throw when they have answered a question [patience] times, all together.
 *
 * @property planted what is thrown: always the same
 */
internal class Trap(
    frame: Frame,
    private val question: Question,
    patience: Int,
    val planted: Throwable = Planted.EXCEPTION.make(),
) {
    private val left = AtomicInteger(patience)

    /** The frame whose primitives throw. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Trapped(it) }, frame.region)

    /** Whether it has been thrown. */
    val isSprung: Boolean get() = left.get() < 0

    private fun step(question: Question) {
        if (question == this.question && left.decrementAndGet() < 0) {
            left.set(-1)
            throw planted
        }
    }

    private inner class Trapped(whole: Primitive) : Recovered(whole) {
        /** Depth is asked for, not stepped, if that is what throws. */
        override val depthForm: LinearForm? get() = if (question == Question.DEPTH) null else whole.depthForm

        override fun spans(y: Int, spans: Spans) {
            step(Question.SPANS)
            whole.spans(y, spans)
        }

        override fun depth(x: Int, y: Int): Int {
            step(Question.DEPTH)
            return whole.depth(x, y)
        }

        override fun shade(fragment: Fragment) {
            step(Question.COLOUR)
            whole.shade(fragment)
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
    }
}

/** Calls [block] and returns what it throws, or null. */
internal fun answer(block: () -> Unit): Throwable? = try {
    block()
    null
} catch (e: Throwable) {
    e
}

/** Fails unless [renderer] passes on what [trap] throws, or never runs into it and renders right. */
internal fun failsAsPlanned(renderer: Renderer, case: FrameCase, trap: Trap) {
    var rendering: Rendering? = null
    val thrown = answer { rendering = Rendering.of(renderer, trap.frame) }
    val expected = if (trap.isSprung) trap.planted else null
    if (thrown !== expected) {
        val what = "${expected ?: "nothing"} was thrown, the caller got ${thrown ?: "nothing"}"
        Judgement(renderer, case).fail(what, thrown)
    }
    val image = rendering?.image ?: return
    difference(Rendering.of(ReferenceRenderer(), case.frame).image, image)?.let {
        Judgement(renderer, case).fail("", it)
    }
}
