package dev.lazyz.conformance.probes.threads

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recorder
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.Asking
import dev.lazyz.conformance.probes.answer
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger

/** When the rendering thread is interrupted. */
internal enum class Interruption(private val words: String) {
    BEFORE("before it renders"),
    IN_THE_SINK("while the sink is called"),
    IN_A_PRIMITIVE("while a primitive is queried"),
    IN_A_SELECTOR("while the selector is called"),
    ;

    /** Returns whether it can happen to [renderer]. */
    fun isFor(renderer: Renderer): Boolean = this != IN_A_SELECTOR || Capability.SELECTION in renderer.capabilities

    override fun toString(): String = words
}

/**
 * Fails unless [renderer], called by an interrupted thread, soon returns the whole picture or throws
 * InterruptedException.
 */
internal fun endsInterrupted(renderer: Renderer, case: FrameCase): Unit =
    interrupt(renderer, case, Interruption.BEFORE, Random(0)) { it.lostPicture(case) }

/**
 * Fails unless [renderer], if its thread is interrupted at some [moment], also reports that, by the interrupt status or
 * by the exception.
 */
internal fun reportsInterrupt(renderer: Renderer, case: FrameCase, moment: Interruption, random: Random): Unit =
    interrupt(renderer, case, moment, random) { it.lostInterrupt() ?: it.lostPicture(case) }

private fun interrupt(
    renderer: Renderer,
    case: FrameCase,
    moment: Interruption,
    random: Random,
    complaint: (InterruptedRendering) -> String?,
) {
    val rendering = InterruptedRendering(renderer, case.frame, moment, random)
    inOwnThread(rendering)
    val what = complaint(rendering) ?: return
    Judgement(renderer, case, "a thread that is interrupted $moment").fail(what, rendering.thrown)
}

/** Runs [rendering] in a thread of its own. A thread that hangs makes the try hang, which has a deadline. */
internal fun inOwnThread(rendering: Runnable) = Thread(rendering, "lazyz-interrupted").run {
    isDaemon = true
    start()
    join()
}

private class InterruptedRendering(
    private val renderer: Renderer,
    private val frame: Frame,
    private val moment: Interruption,
    random: Random,
) : Runnable {
    private val row = frame.region.rowStart + random.nextInt(frame.height)
    private val questions = AtomicInteger(random.nextInt(MOST_QUESTIONS))
    private val recorder = Recorder(frame.region)
    private lateinit var caller: Thread

    @Volatile
    private var isSent = false
    private var isSet = false
    private var counters: Counters? = null

    /** What the renderer threw. */
    @Volatile
    var thrown: Throwable? = null
        private set

    override fun run() {
        caller = Thread.currentThread()
        if (moment == Interruption.BEFORE) send()
        val asking =
            Frame(frame.raster, frame.primitives.map { primitive -> Asking(primitive) { ask() } }, frame.region)
        val subject = if (moment == Interruption.IN_A_PRIMITIVE) asking else frame
        val sink = RowSink { y, argb, depth, primitive ->
            recorder.row(y, argb, depth, primitive)
            if (moment == Interruption.IN_THE_SINK && y == row) send()
        }
        thrown = answer { counters = chosen().render(subject, sink) }
        isSet = caller.isInterrupted
    }

    /** Returns the renderer, with a selector that shows the usual picture if that is to interrupt. */
    private fun chosen(): Renderer {
        if (moment != Interruption.IN_A_SELECTOR) return renderer
        val asking = Selector { cell ->
            ask()
            cell.show(0)
        }
        return renderer.configured(RenderOptions(selector = asking))
    }

    /** Interrupts the caller after some queries, counted over all primitives or cells. */
    private fun ask() {
        if (questions.getAndDecrement() == 0) send()
    }

    private fun send() {
        isSent = true
        caller.interrupt()
    }

    /** Describes how the interrupt was lost, or returns null. */
    fun lostInterrupt(): String? = when {
        thrown is InterruptedException && !isSent -> "threw InterruptedException, although it was not interrupted"
        thrown is InterruptedException && isSet -> "threw InterruptedException, but left the interrupt status set"
        thrown != null -> null
        isSent && !isSet -> "returned, but the interrupt status is no longer set"
        !isSent && isSet -> "set the interrupt status, although it was not interrupted"
        else -> null
    }

    /**
     * Describes what is wrong with the picture, or returns null. After an InterruptedException there need not be a
     * picture.
     */
    fun lostPicture(case: FrameCase): String? {
        if (thrown is InterruptedException) return null
        val image = recorder.image(counters ?: return "threw $thrown")
        return difference(Recording.of(ReferenceRenderer(), case.frame).image, image)?.toString()
    }

    private companion object {
        const val MOST_QUESTIONS = 200
    }
}
