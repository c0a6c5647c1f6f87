package dev.lazyz.conformance.probes.threads

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recorder
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.notMeasured
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.Asking
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.dust
import dev.lazyz.spi.Fragment
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger
import kotlin.concurrent.thread

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
internal fun inOwnThread(rendering: Runnable) =
    thread(isDaemon = true, name = "lazyz-interrupted", block = rendering::run).join()

/**
 * Describes how an interrupt of the calling thread was lost, or made up, by a renderer that threw [thrown] or returned;
 * or returns null.
 *
 * @param isSent whether the thread was interrupted
 * @param isSet whether its interrupt status is set at the end
 */
internal fun lostInterrupt(thrown: Throwable?, isSent: Boolean, isSet: Boolean): String? = when {
    thrown is InterruptedException && !isSent -> "threw InterruptedException, although it was not interrupted"
    thrown is InterruptedException && isSet -> LEFT_SET
    thrown != null -> null
    isSent && !isSet -> "returned, but the interrupt status is no longer set"
    !isSent && isSet -> "set the interrupt status, although it was not interrupted"
    else -> null
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

    fun lostInterrupt(): String? = lostInterrupt(thrown, isSent, isSet)

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

/**
 * Fails if [renderer], in each of several attempts, throws an InterruptedException late: after more than a part of the
 * processor time that its thread takes for the whole picture of very many triangles, of rows of slow colours, or of
 * primitives with slow bounds of depth. Also fails if it then leaves the interrupt status set.
 */
internal fun endsSoon(renderer: Renderer) {
    if (!times.isCurrentThreadCpuTimeSupported) notMeasured("this JVM does not measure the processor time of a thread")
    val configured = renderer.configured(RenderOptions(threads = 1))
    endsSoon(configured, "$GRAINS triangles") { dust(it, GRAINS) }
    val rows = Slow(Stripe(0..<WIDE, 0..1, 1000))
    endsSoon(configured, "two rows of $WIDE samples with slow colours") { Frame(Raster(WIDE, 2), listOf(rows)) }
    val small = List(WIDE) { Slow(Stripe(it % 8..it % 8, 0..it % 8, it)) }
    endsSoon(configured, "$WIDE primitives with slow bounds of depth") { Frame(Raster(8, 8), small) }
}

private fun endsSoon(renderer: Renderer, what: String, frame: (salt: Long) -> Frame) {
    var salt = 0L

    fun rendered(moment: Long): TimedRendering {
        TryUnderWay.current?.goesOn()
        // A frame makes its list of primitives when it is first asked for, and to the end
        val made = frame(salt++).also { it.primitives.first() }
        val rendering = TimedRendering(renderer, made, moment)
        rendering.await()
        if (rendering.isTwice) fail(renderer, "drawing $what: $LEFT_SET")
        return rendering
    }
    val whole = (1..ATTEMPTS).minOf { rendered(Long.MAX_VALUE).whole }
    for (part in 0 until PARTS step 2) {
        if ((1..ATTEMPTS).any { rendered(whole * part / PARTS).late <= maxOf(whole / PARTS, SHORT) }) continue
        val moment = "after $part of $PARTS parts of the time that it takes to draw $what"
        fail(renderer, "interrupted $moment, it goes on for more than one part, and then throws InterruptedException")
    }
}

/** A primitive whose colours and bounds of depth take about a microsecond each. */
private class Slow(private val whole: Primitive) : Primitive by whole {
    override val leastDepth: Int get() = whole.leastDepth.also { work() }
    override val greatestDepth: Int get() = whole.greatestDepth.also { work() }

    override fun shade(fragment: Fragment) = whole.shade(fragment).also { work() }

    private fun work() = awaitUntil(MICROSECOND) { false }
}

/** Renders [frame], and is interrupted when it has taken [moment] nanoseconds of processor time. */
private class TimedRendering(private val renderer: Renderer, private val frame: Frame, private val moment: Long) :
    Thread("lazyz-interrupted") {
    @Volatile
    private var begin = 0L
    private var end = 0L
    private var thrown: Throwable? = null

    /** Whether the interrupt status is set after an InterruptedException. */
    var isTwice = false
        private set

    /** The processor time at the interrupt, see [moment]; 0 before it, negative if the thread has ended meanwhile. */
    private var reached = 0L

    /** Nanoseconds that the rendering takes. */
    val whole: Long get() = end - begin

    /** Nanoseconds from the interrupt to the InterruptedException; 0 if there is none, or no time to read one. */
    val late: Long get() = if (thrown is InterruptedException && reached > 0) end - reached else 0

    override fun run() {
        val start = times.currentThreadCpuTime
        if (moment == 0L) interruptAt { start }
        begin = start
        thrown = answer { renderer.render(frame) { _, _, _, _ -> } }
        end = times.currentThreadCpuTime
        isTwice = thrown is InterruptedException && isInterrupted
    }

    /** The time is read after the interrupt, because a busy machine may let this thread wait before it. */
    private fun interruptAt(time: () -> Long) {
        interrupt()
        reached = time()
    }

    fun await() {
        isDaemon = true
        start()
        while (isAlive) {
            if (reached == 0L && begin > 0 && times.getThreadCpuTime(id) - begin >= moment) {
                interruptAt { times.getThreadCpuTime(id) }
            }
            join(1)
        }
    }
}

private const val LEFT_SET = "threw InterruptedException, but left the interrupt status set"

private const val GRAINS = 30_000
private const val ATTEMPTS = 3
private const val PARTS = 8
private const val WIDE = 20_000
private const val MICROSECOND = 1_000L

/** Nanoseconds that are never long. */
private const val SHORT = 5_000_000L
