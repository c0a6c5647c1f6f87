package dev.lazyz.server

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.server.render.MemoryBudget
import dev.lazyz.server.render.PictureMaker
import dev.lazyz.server.render.Problem
import dev.lazyz.server.render.RenderQueue
import java.util.concurrent.atomic.AtomicInteger
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
