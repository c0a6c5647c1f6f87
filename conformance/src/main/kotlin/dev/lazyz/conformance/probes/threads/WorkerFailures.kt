package dev.lazyz.conformance.probes.threads

import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.watched
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recorder
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.Planted
import dev.lazyz.conformance.probes.Question
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.changed
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.Executor
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.locks.LockSupport

/** Fails unless what a primitive throws in one of [renderer]'s own threads reaches the caller unchanged. */
internal fun passesOnFailuresOfWorkers(renderer: Renderer) {
    val quiet = WorkerProbe.quiet()
    for (question in Question.entries) {
        for (kind in Planted.entries) {
            val planted = kind.make()
            val isThrown = AtomicBoolean()
            val workers = WorkerProbe(Thread.currentThread()) { asked, _ ->
                if (asked == question && isThrown.compareAndSet(false, true)) throw planted
            }
            val thrown = answer { Recording.of(renderer, workers.frame) }

            // A renderer without worker threads has nothing to pass on
            if (!workers.hasWorker) return
            val expected = if (isThrown.get()) planted else null
            val change = changed(expected, thrown) ?: continue
            val what = "in one of its threads the query $question throws $change"
            throw Violation("${renderer.id}: $what\nin\n$quiet", quiet)
        }
    }
    repeat(ATTEMPTS) { passesOnOneOfSeveral(renderer, quiet) }
    Judgement(renderer, quiet, "a failure before").equalsReference()
}

/** Several threads fail at about the same time, and the caller gets one of the exceptions. */
private fun passesOnOneOfSeveral(renderer: Renderer, quiet: FrameCase) {
    val planted = ConcurrentLinkedQueue<Throwable>()
    fun fail(): Nothing = throw Planted.EXCEPTION.make().also { planted.add(it) }
    val workers = WorkerProbe(Thread.currentThread(), { fail() }) { _, _ -> fail() }
    val thrown = answer { Recording.of(renderer, workers.frame) }
    if (!workers.hasWorker) return
    val one = planted.firstOrNull { it === thrown } ?: planted.first()
    val change = changed(one, thrown) ?: return
    throw Violation("${renderer.id}: when several threads fail, one throws $change\nin\n$quiet", quiet)
}

private const val ATTEMPTS = 5

/**
 * Fails unless [renderer], if its caller is interrupted while its own threads still work, returns the whole picture or
 * throws InterruptedException. How far the threads are is different in each attempt.
 */
internal fun completesOrThrowsIfInterrupted(renderer: Renderer, isBefore: Boolean) =
    repeat(ATTEMPTS) { completesOrThrowsOnce(renderer, isBefore) }

private fun completesOrThrowsOnce(renderer: Renderer, isBefore: Boolean) {
    val quiet = WorkerProbe.quiet()
    val rendering = InterruptedCaller(renderer, isBefore)
    inOwnThread(rendering)
    val what = rendering.complaint(quiet) ?: return
    val moment = if (isBefore) "before it renders" else "while it waits for other threads"
    Judgement(renderer, quiet, "a thread that is interrupted $moment").fail(what, rendering.thrown)
}

/**
 * Fails unless [renderer] returns the whole picture though a primitive interrupts its own threads. Which thread does
 * what is different in each attempt.
 */
internal fun finishesIfWorkersAreInterrupted(renderer: Renderer) {
    val quiet = WorkerProbe.quiet()
    repeat(ATTEMPTS) {
        // Who looks at the frame of a failure afterwards is not interrupted
        val isOver = AtomicBoolean()
        val workers =
            WorkerProbe(Thread.currentThread()) { _, _ -> if (!isOver.get()) Thread.currentThread().interrupt() }
        val case = quiet.watched(workers.frame)
        try {
            Judgement(renderer, case, "primitives that interrupt other threads").equalsPictureOf(ReferenceRenderer())
        } finally {
            isOver.set(true)
        }
    }
}

/**
 * Fails if a rendering that fails leaves a thread of the caller's executor interrupted. The caller's part fails while
 * the workers wait to be interrupted, in the first query of each and for a moment at most.
 */
internal fun leavesNoInterrupt(renderer: Renderer) {
    val isLeft = AtomicBoolean()
    val tasks = AtomicInteger()
    val isUsed = AtomicBoolean()
    val executor = Executor { task ->
        isUsed.set(true)
        tasks.incrementAndGet()
        val thread = Thread {
            task.run()
            if (Thread.currentThread().isInterrupted) isLeft.set(true)
            tasks.decrementAndGet()
        }
        thread.isDaemon = true
        thread.start()
    }
    val configured = renderer.configured(RenderOptions(threads = 4, tileSize = 8, executor = executor))
    repeat(ATTEMPTS) {
        val waited = ConcurrentHashMap.newKeySet<Thread>()
        val workers = WorkerProbe(Thread.currentThread(), { throw Planted.EXCEPTION.make() }) { _, _ ->
            val worker = Thread.currentThread()
            if (waited.add(worker)) awaitUntil(BRIEF) { worker.isInterrupted }
        }
        answer { Recording.of(configured, workers.frame) }

        // A renderer that does not use the executor cannot interrupt its threads
        if (!isUsed.get()) return
        awaitUntil(PATIENCE * MILLISECOND) { tasks.get() == 0 }
        if (isLeft.get()) {
            fail(renderer, "a thread of the caller's executor is still interrupted when its task has ended")
        }
    }
}

private const val MILLISECOND = 1_000_000L

/** Nanoseconds of its processor time that a worker waits for an interrupt. */
private const val BRIEF = 20_000_000L

/** Milliseconds of processor time to wait for the tasks of a failed rendering to end. */
private const val PATIENCE = 20_000L

private class InterruptedCaller(private val renderer: Renderer, private val isBefore: Boolean) : Runnable {
    private lateinit var caller: Thread
    private val isFirst = AtomicBoolean(true)
    private val pauses = AtomicInteger()
    private val late = AtomicInteger()
    private var image: Image? = null
    private var isSet = false

    @Volatile
    private var isSent = false

    @Volatile
    private var hasEnded = false

    /** Whether a row has been delivered. */
    @Volatile
    private var isHandedOut = false

    /** What the renderer threw. */
    @Volatile
    var thrown: Throwable? = null
        private set

    override fun run() {
        caller = Thread.currentThread()
        val workers = WorkerProbe(caller) { _, _ ->
            if (hasEnded) late.incrementAndGet()
            hold()
            if (isSent && pauses.getAndIncrement() < MOST_PAUSES) LockSupport.parkNanos(PAUSE)
        }
        if (isBefore) send()
        thrown = answer {
            val recorder = Recorder(workers.frame.region)
            val counters = renderer.render(workers.frame) { y, argb, depth, primitive ->
                isHandedOut = true
                recorder.row(y, argb, depth, primitive)
            }
            image = recorder.image(counters)
        }
        isSet = Thread.interrupted()
        hasEnded = true
        if (thrown is InterruptedException) Thread.sleep(AFTERWARDS)
    }

    private fun send() {
        isSent = true
        caller.interrupt()
    }

    /** Holds the first worker until the caller waits for it or has delivered a row. */
    private fun hold() {
        if (!isFirst.compareAndSet(true, false)) return
        awaitUntil(WAIT) { isHandedOut || caller.isWaiting }
        if (isBefore || isHandedOut) return
        send()
        awaitUntil(MOMENT) { isHandedOut }
    }

    /** Describes what is wrong, or returns null. */
    fun complaint(case: FrameCase): String? {
        val image = image
        return lostInterrupt(thrown, isSent, isSet) ?: when {
            late.get() > 0 -> "threw $thrown, but its threads queried primitives ${late.get()} times afterwards"
            thrown is InterruptedException -> null
            image == null -> "threw $thrown"
            else -> difference(Recording.of(ReferenceRenderer(), case.frame).image, image)?.toString()
        }
    }

    private companion object {
        /** Nanoseconds of processor time in which the caller usually finishes its own part of the work. */
        const val WAIT = 200_000_000L

        /** Nanoseconds of processor time in which a thread continues after it was woken up. */
        const val MOMENT = 30_000_000L

        /** Number of slow answers after the interrupt, and nanoseconds that each takes. */
        const val MOST_PAUSES = 200
        const val PAUSE = 200_000L

        /** Milliseconds to wait for queries after the end. */
        const val AFTERWARDS = 20L
    }
}
