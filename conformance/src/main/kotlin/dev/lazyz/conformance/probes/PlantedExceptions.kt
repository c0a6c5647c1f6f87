package dev.lazyz.conformance.probes

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans
import java.io.IOException
import java.util.concurrent.CancellationException
import java.util.concurrent.atomic.AtomicInteger

/**
 * Exceptions that the caller's code may throw. Includes those that renderers may catch for other reasons, such as the
 * end of an array or the cancellation of a coroutine, and a checked exception, because Kotlin and lambdas can throw
 * them.
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

    /** Returns a new instance. */
    fun make(): Throwable = throwable("planted")
}

/** A kind of query that a renderer makes to a primitive. */
internal enum class Question { SPANS, DEPTH, COLOUR, BOUNDS, TRANSLUCENCY }

/**
 * A copy of [frame] whose primitives throw after they have answered a total of [answers] queries of one kind.
 *
 * @property planted the exception, always the same instance
 */
internal class Trap(
    frame: Frame,
    private val question: Question,
    answers: Int,
    val planted: Throwable = Planted.EXCEPTION.make(),
) {
    private val left = AtomicInteger(answers)

    /** The frame whose primitives throw. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Trapped(it) }, frame.region)

    /** Whether the exception has been thrown. */
    val isSprung: Boolean get() = left.get() < 0

    /** Throws at a query of this kind, after some of them. */
    private fun ask(question: Question) {
        if (question == this.question && left.decrementAndGet() < 0) {
            left.set(-1)
            throw planted
        }
    }

    private inner class Trapped(whole: Primitive) : Asking(whole, ::ask) {
        /** Without a linear form, the renderer must call [depth], which may throw. */
        override val depthForm: LinearForm? get() = if (question == Question.DEPTH) null else whole.depthForm

        override val rowStart: Int get() = whole.rowStart.also { ask(Question.BOUNDS) }
        override val rowEnd: Int get() = whole.rowEnd.also { ask(Question.BOUNDS) }
        override val columnStart: Int get() = whole.columnStart.also { ask(Question.BOUNDS) }
        override val columnEnd: Int get() = whole.columnEnd.also { ask(Question.BOUNDS) }
        override val leastDepth: Int get() = whole.leastDepth.also { ask(Question.BOUNDS) }
        override val greatestDepth: Int get() = whole.greatestDepth.also { ask(Question.BOUNDS) }
        override val isTranslucent: Boolean get() = whole.isTranslucent.also { ask(Question.TRANSLUCENCY) }
    }
}

/** The primitive [whole]; each query passes [ask] before its answer. It computes each depth and each colour. */
internal open class Asking(whole: Primitive, private val ask: (Question) -> Unit) : Recovered(whole) {
    override val depthForm: LinearForm? get() = null

    override fun spans(y: Int, spans: Spans) {
        ask(Question.SPANS)
        whole.spans(y, spans)
    }

    override fun depth(x: Int, y: Int): Int {
        ask(Question.DEPTH)
        return whole.depth(x, y)
    }

    override fun shade(fragment: Fragment) {
        ask(Question.COLOUR)
        whole.shade(fragment)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
}

/** Calls [block] and returns what it throws, or null. */
internal fun answer(block: () -> Unit): Throwable? = try {
    block()
    null
} catch (e: Throwable) {
    e
}

/**
 * Fails unless [renderer], which supports selectors, passes on what a selector throws that is called more than
 * [answers] times.
 */
internal fun failsWithItsSelector(renderer: Renderer, case: FrameCase, answers: Int, planted: Throwable) {
    val left = AtomicInteger(answers)
    val selector = Selector {
        if (left.decrementAndGet() < 0) throw planted
        Selector.nearest().select(it)
    }
    val configured = renderer.configured(RenderOptions(selector = selector))
    val thrown = answer { configured.inTime(case.frame) { _, _, _, _ -> } }
    val expected = if (left.get() < 0) planted else null
    changed(expected, thrown)?.let { Judgement(renderer, case).fail("the selector throws $it", thrown) }
}

/** Describes how the caller did not get what was [planted] as it was, or returns null. */
internal fun changed(planted: Throwable?, thrown: Throwable?): String? = when {
    thrown !== planted -> "${planted ?: "nothing"}, but the caller got ${thrown ?: "nothing"}"
    thrown == null -> null
    thrown.suppressed.isNotEmpty() -> "$planted, but the caller got it with ${thrown.suppressed[0]} as suppressed"
    thrown.cause != null -> "$planted, but the caller got it with ${thrown.cause} as its cause"
    else -> null
}

/** Fails unless [renderer] passes on what [trap] throws, or never triggers it and renders correctly. */
internal fun failsAsPlanned(renderer: Renderer, case: FrameCase, trap: Trap) {
    var rendering: Recording? = null
    val thrown = answer { rendering = Recording.of(renderer, trap.frame) }
    val expected = if (trap.isSprung) trap.planted else null
    changed(expected, thrown)?.let { Judgement(renderer, case).fail("a primitive throws $it", thrown) }
    val image = rendering?.image ?: return
    difference(Recording.of(ReferenceRenderer(), case.frame).image, image)?.let {
        Judgement(renderer, case).fail("", it)
    }
}
