package dev.lazyz.conformance.probes

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.Properties
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask

// Checks for side effects of renderings. Other threads of the process may print, and other processes may create files.
// Therefore only output of the renderer's own threads counts, and only files that appear with each rendering.

/**
 * Fails if making a renderer and rendering a few frames, one with many layers, leaves output, changed global state,
 * threads or files. The caller's thread is no daemon, because a new thread is a daemon only if its parent is one.
 */
internal fun leavesNothingBehind(make: () -> Renderer) {
    val task = FutureTask { leavesNothingBehindHere(make) }
    Thread(task, "lazyz-no-daemon").apply { isDaemon = false }.start()
    try {
        task.get()
    } catch (e: ExecutionException) {
        throw e.cause ?: e
    }
}

private fun leavesNothingBehindHere(make: () -> Renderer) {
    val renderer = make()
    fun render() {
        renderAll(renderer, smallFrames + largeFrames)
        failAll(renderer, smallFrames)
    }
    fun failIf(words: String?) {
        if (words != null) throw AssertionError("${renderer.id} leaves behind $words")
    }
    failIf(TryUnderWay.current?.settingChanged?.let { "another $it" })
    failIf(
        settingChangedBy {
            make()
            render()
        }?.let { "another $it" },
    )

    // Render once: some side effects show immediately
    val here = names(Path.of(""))
    val before = GlobalState()
    val printed = printedBy { failIf(propertySetBy { render() }) }
    failIf(before.changedTo(GlobalState()))
    failIf(if (printed.isEmpty()) null else "output: ${printed.take(MOST_PRINTED)}")
    failIf(threadsBeyond(threads()))
    failIf((names(Path.of("")) - here).firstOrNull()?.let { "the file $it" })

    // Render many times: a thread pool fills up only after a while, and other processes create files occasionally
    repeat(ENOUGH * Runtime.getRuntime().availableProcessors()) { renderAll(renderer, smallFrames) }
    val threads = threads()
    val temporary = Path.of(System.getProperty("java.io.tmpdir"))
    val files = names(temporary)
    repeat(WATCHED) { render() }
    val newFiles = names(temporary) - files
    failIf(if (newFiles.size < WATCHED) null else "a temporary file for each rendering, such as ${newFiles.first()}")
    failIf(threadsBeyond(threads))
}

/** Renders [frames], also one by one if [renderer] can; each frame has its own deadline. */
internal fun renderAll(renderer: Renderer, frames: List<Frame>) {
    for (frame in frames) {
        TryUnderWay.current?.goesOn()
        for (way in renderer.ways()) way.inTime(frame) { _, _, _, _ -> }
    }
}

private const val ENOUGH = 16
private const val WATCHED = 10
private const val MOST_PRINTED = 80

/** Two polygons; many primitives at each sample; no primitives. */
internal val smallFrames: List<Frame> = listOf(
    FrameBuilder(Raster(24, 16))
        .polygon(Frames.tint(0), FillRule.NON_ZERO, doubleArrayOf(1.0, 1.0, 0.5, 23.0, 2.0, 0.5, 4.0, 15.0, 0.5))
        .polygon(Frames.tint(1), FillRule.NON_ZERO, doubleArrayOf(2.0, 14.0, 0.2, 20.0, 15.0, 0.8, 12.0, 1.0, 0.5))
        .build(),
    Frame(Raster(5, 3), List(300) { Confetti(it, 0, 5, 0, 3, 20) }),
    Frame(Raster(3, 5), emptyList()),
)

/** A wide and a high raster. */
private val largeFrames: List<Frame> = listOf(
    Frame(Raster(FAR, 2), List(2) { Confetti(it, 0, FAR, 0, 2, 20) }),
    Frame(Raster(2, FAR), List(2) { Confetti(it, 0, 2, 0, FAR, 20) }),
)

/** More columns or rows than most renderers process at a time. */
private const val FAR = 1500

private fun names(folder: Path): Set<String> = Files.newDirectoryStream(folder).use { paths ->
    paths.mapTo(HashSet()) { "${it.fileName}" }
}

/** Returns the threads of the current thread's group and its subgroups. */
private fun threads(): Set<Thread> {
    val group = Thread.currentThread().threadGroup
    val threads = arrayOfNulls<Thread>(2 * group.activeCount() + WATCHED)
    return threads.take(group.enumerate(threads)).filterNotNullTo(HashSet())
}

/** Describes threads that were started since [before] and do not end; null if they are few, as in a thread pool. */
private fun threadsBeyond(before: Set<Thread>): String? {
    val end = System.nanoTime() + PATIENCE_NANOSECONDS
    while (true) {
        val more = threads() - before
        val lasting = threads().filter { !it.isDaemon && it !== Thread.currentThread() }
        val words = when {
            lasting.isNotEmpty() -> "the thread ${lasting.first().name}, which keeps the process running"
            more.size >= WATCHED -> "a thread for each rendering, such as ${more.first().name}"
            else -> return null
        }
        if (System.nanoTime() > end) return words
        Thread.sleep(1)
    }
}

/** Long enough for threads that end, also on a busy machine. */
private const val PATIENCE_NANOSECONDS = 5_000_000_000L

/** State of the whole process that no mark can replace meanwhile, see [settingChangedBy]. */
private class GlobalState {
    private val parts: Map<String, Any?> = mapOf(
        "standard output" to System.out,
        "standard error" to System.err,
        "standard input" to System.`in`,
    ) + System.getProperties().entries.associate { "system property ${it.key}" to it.value }

    fun changedTo(after: GlobalState): String? =
        (parts.keys + after.parts.keys).firstOrNull { parts[it] != after.parts[it] }?.let { "another $it" }
}

/**
 * Returns the name of a system property that this thread's group sets while [block] runs, even to its old value; null
 * if there is none.
 */
private fun propertySetBy(block: () -> Unit): String? {
    val group = Thread.currentThread().threadGroup
    val usual = System.getProperties()
    val set = ConcurrentLinkedQueue<Any>()
    val watched = object : Properties() {
        override fun put(key: Any?, value: Any?): Any? {
            if (group.parentOf(Thread.currentThread().threadGroup)) set.add(key ?: "null")
            return super.put(key, value)
        }

        override fun remove(key: Any?): Any? {
            if (group.parentOf(Thread.currentThread().threadGroup)) set.add(key ?: "null")
            return super.remove(key)
        }
    }
    synchronized(usual) { for ((key, value) in usual) watched[key] = value }
    set.clear()
    System.setProperties(watched)
    try {
        block()
    } finally {
        if (System.getProperties() === watched) System.setProperties(usual)
    }
    return set.firstOrNull()?.let { "another system property $it" }
}

/** Returns what this thread's group prints while [block] runs. */
private fun printedBy(block: () -> Unit): String {
    val (out, err) = System.out to System.err
    val printed = ByteArrayOutputStream()
    val group = Thread.currentThread().threadGroup
    fun watched(stream: PrintStream) = PrintStream(
        object : OutputStream() {
            override fun write(byte: Int) {
                if (group.parentOf(Thread.currentThread().threadGroup)) printed.write(byte) else stream.write(byte)
            }
        },
        true,
    )
    val (watchedOut, watchedErr) = watched(out) to watched(err)
    System.setOut(watchedOut)
    System.setErr(watchedErr)
    try {
        block()
    } finally {
        if (System.out === watchedOut) System.setOut(out)
        if (System.err === watchedErr) System.setErr(err)
    }
    return printed.toString()
}

/**
 * Renders [frames] so that no rendering is completed: a primitive throws, the sink throws, or the thread is
 * interrupted. Each frame has its own deadline.
 */
internal fun failAll(renderer: Renderer, frames: List<Frame>) {
    for (frame in frames) {
        TryUnderWay.current?.goesOn()
        for (way in renderer.ways()) {
            answer { way.inTime(Trap(frame, Question.COLOUR, 0).frame) { _, _, _, _ -> } }
            answer { way.inTime(frame) { _, _, _, _ -> throw Planted.EXCEPTION.make() } }
            Thread.currentThread().interrupt()
            answer { way.inTime(frame) { _, _, _, _ -> } }

            // The renderer may have cleared the status already
            Thread.interrupted()
        }
    }
}
