package dev.lazyz.server

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.server.render.MemoryBudget
import dev.lazyz.server.render.PictureMaker
import dev.lazyz.server.render.Problem
import dev.lazyz.server.render.RenderQueue
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ConcurrentSkipListMap
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.atomic.LongAdder
import java.util.function.Consumer

/** What all connections of a server share. Thread safe. */
internal class Service(val config: ServerConfig) : AutoCloseable {
    val uploads = MemoryBudget(config.memory / UPLOAD_PART)
    val queue = RenderQueue(config.renders, config.queue, config.memory - uploads.total)
    val maker = PictureMaker(limits(), queue.memory / (config.renders * PictureMaker.MEMORY_PER_DECODED) * 3 / 4)
    val metrics = Metrics()

    /** Maximum bytes of a model. An array of them, and a copy while it grows, must fit. */
    val mostBody: Long = minOf(config.body, uploads.total / 2, Int.MAX_VALUE - 16L)

    /** The open connections. */
    val connections = AtomicInteger()

    /** The requests that have begun, and whose answer is not yet sent. */
    val requests = AtomicInteger()

    /** Whether the server is being closed: it finishes its work and takes no more. */
    @Volatile
    var isDraining = false

    /** One line for each request. */
    val log = LineLog(config.log ?: Consumer { LOGGER.log(System.Logger.Level.INFO, it) })

    val renderTime = metrics.Histogram("lazyz_render_seconds", "Time of reading and rendering a model.")
    val received = metrics.counter("lazyz_received_bytes_total", "Bytes of models received.")
    val sent = metrics.counter("lazyz_sent_bytes_total", "Bytes of pictures sent.")

    init {
        metrics.gauge("lazyz_connections", "Open connections.") { connections.get() }
        metrics.gauge("lazyz_requests_open", "Requests whose answer is not yet sent.") { requests.get() }
        metrics.gauge("lazyz_renders_waiting", "Requests that wait for their rendering.") { queue.waiting }
        metrics.gauge("lazyz_renders_running", "Pictures that are being rendered.") { queue.running }
        metrics.gauge("lazyz_renders_hanging", "Threads that do not react to their end.") { queue.hanging }
        metrics.gauge("lazyz_upload_memory_bytes", "Memory that uploads take.") { uploads.used }
        metrics.gauge("lazyz_upload_memory_max_bytes", "Memory for uploads.") { uploads.total }
        metrics.gauge("lazyz_render_memory_bytes", "Memory that renderings and finished pictures take.") { queue.taken }
        metrics.gauge("lazyz_render_memory_max_bytes", "Memory for renderings.") { queue.memory }
        metrics.gauge("jvm_memory_used_bytes", "Heap in use, with garbage.") {
            Runtime.getRuntime().run { totalMemory() - freeMemory() }
        }
        metrics.gauge("jvm_memory_max_bytes", "Maximum heap.") { Runtime.getRuntime().maxMemory() }
    }

    /** Counts a request that has ended. */
    fun count(status: Int) {
        metrics.counter("lazyz_requests_total", "Requests by status; 499: the client was gone.", "status=\"$status\"")
            .add()
    }

    /** The answer to clients after [isDraining] is set. */
    fun draining() = Problem(Problem.UNAVAILABLE, "the server is being closed", Problem.SOON)

    /** Reports a bug to the system logger, with its stack trace. */
    fun report(bug: Throwable) = LOGGER.log(System.Logger.Level.ERROR, "this is a bug in lazyz-server", bug)

    override fun close() {
        queue.close()
        log.close()
    }

    private fun limits(): LoadLimits {
        val time = config.limits.time

        // The end of the time for reading and rendering interrupts the loader, too
        return config.limits.withTime(time?.takeIf { it < config.renderTime })
    }

    private companion object {
        const val UPLOAD_PART = 4
        val LOGGER: System.Logger = System.getLogger("dev.lazyz.server")
    }
}

/**
 * Passes lines to [consumer], without control characters, on a thread of its own: if it is slow, because nobody reads
 * the output of the process, requests do not wait for it. Lines that are too many meanwhile are dropped and counted.
 */
internal class LineLog(private val consumer: Consumer<String>) : AutoCloseable {
    private val lines = LinkedBlockingQueue<String>(CAPACITY)
    private val dropped = AtomicLong()

    @Volatile
    private var isClosed = false
    private val thread = Thread({ run() }, "lazyz-log").apply {
        isDaemon = true
        start()
    }

    fun add(line: String) {
        if (!lines.offer(line)) dropped.incrementAndGet()
    }

    /** Waits a moment until all lines are written. */
    override fun close() {
        isClosed = true
        thread.join(LAST_LINES)
    }

    private fun run() {
        while (true) {
            val line = lines.poll(PERIOD, TimeUnit.MILLISECONDS)
            if (line == null && isClosed) return
            if (line != null) write(line)
            val lost = dropped.getAndSet(0)
            if (lost > 0) write("$lost lines of the log were dropped, since it is too slow")
        }
    }

    /** A log that fails does not stop the work. */
    private fun write(line: String) = try {
        consumer.accept(line.map { if (it in ' '..'~') it else '?' }.joinToString(""))
    } catch (failure: RuntimeException) {
        LOGGER.log(System.Logger.Level.ERROR, "a line of the log could not be written: $line", failure)
    }

    private companion object {
        const val CAPACITY = 10_000

        /** Milliseconds. */
        const val PERIOD = 50L
        const val LAST_LINES = 1000L
        val LOGGER: System.Logger = System.getLogger("dev.lazyz.server")
    }
}

/** The numbers of a server, in the text format of Prometheus (version 0.0.4). Thread safe. */
internal class Metrics {
    private class Family(val type: String, val help: String) {
        private val samples = LinkedHashMap<String, () -> Number>()

        /** Adds a number, after those before. */
        fun add(sample: String, read: () -> Number) = synchronized(samples) { samples[sample] = read }

        /** Returns all numbers, in the order in which they were added. */
        fun all(): Map<String, () -> Number> = synchronized(samples) { LinkedHashMap(samples) }
    }

    /** A number that only grows. */
    class Counter {
        private val sum = LongAdder()

        fun add(count: Long = 1) = sum.add(count)

        val value: Long get() = sum.sum()
    }

    /** Counts durations by upper bounds. */
    inner class Histogram(name: String, help: String) {
        private val counts = BOUNDS.map { Counter() }
        private val all = Counter()
        private val nanoseconds = Counter()

        init {
            val family = family(name, "histogram", help)
            BOUNDS.forEachIndexed { i, bound ->
                family.add("${name}_bucket{le=\"$bound\"}") { counts.take(i + 1).sumOf { it.value } }
            }
            family.add("${name}_bucket{le=\"+Inf\"}") { all.value }
            family.add("${name}_count") { all.value }
            family.add("${name}_sum") { nanoseconds.value / 1e9 }
        }

        fun add(duration: Long) {
            val seconds = duration / 1e9
            BOUNDS.indexOfFirst { seconds <= it }.let { if (it >= 0) counts[it].add() }
            all.add()
            nanoseconds.add(duration)
        }
    }

    private val families = ConcurrentSkipListMap<String, Family>()

    /** Unlike a skip list, this map makes a new counter once, also for two threads. */
    private val counters = ConcurrentHashMap<String, Counter>()

    /** Returns the counter called [name] with the [labels], such as `status="200"`. */
    fun counter(name: String, help: String, labels: String = ""): Counter {
        val sample = if (labels.isEmpty()) name else "$name{$labels}"
        return counters.computeIfAbsent(sample) {
            Counter().also { counter -> family(name, "counter", help).add(sample) { counter.value } }
        }
    }

    /** Adds a number that is read when it is asked for. */
    fun gauge(name: String, help: String, read: () -> Number) {
        family(name, "gauge", help).add(name, read)
    }

    /** Returns all numbers. */
    fun text(): String = buildString {
        for ((name, family) in families) {
            append("# HELP ").append(name).append(' ').append(family.help).append('\n')
            append("# TYPE ").append(name).append(' ').append(family.type).append('\n')
            for ((sample, read) in family.all()) append(sample).append(' ').append(read()).append('\n')
        }
    }

    private fun family(name: String, type: String, help: String): Family =
        families.computeIfAbsent(name) { Family(type, help) }

    private companion object {
        /** Seconds. */
        val BOUNDS = listOf(0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0)
    }
}
