package dev.lazyz.server

import dev.lazyz.scenes.LoadLimits
import java.time.Duration
import java.util.function.Consumer

/**
 * The settings of a [RenderServer]. Immutable. The defaults suit uploads from strangers, behind a proxy on the same
 * machine.
 *
 * In Java: `new ServerConfig().withPort(0).withQueue(8)`.
 *
 * @property host the address to listen at: a name or a number. The default can be reached from this machine only
 * @property port the port to listen at, 0..65535; 0 takes a free one, see [RenderServer.port]
 * @property adminHost the address for health and metrics. The default can be reached from this machine only
 * @property adminPort the port for health and metrics, 0..65535; 0 takes a free one, see [RenderServer.adminPort].
 *   Null, the default, means that there is none; the program `lazyz-server` has 8081
 * @property renders pictures that are rendered at the same time, 1..1024, each by one thread. The default is the number
 *   of processors
 * @property queue requests that wait for their rendering, 0..100000. Further ones are answered with status 429
 * @property connections open connections, 1..1000000. Further ones are answered with status 503
 * @property memory bytes of heap for uploads, renderings and finished pictures, at least 1 MiB, and at most the
 *   maximum heap. A quarter of it is for uploads. The default is half of the maximum heap
 * @property body maximum bytes of a model, 1 or more. More than the memory for uploads is never accepted
 * @property pixels maximum pixels of a picture, 1 or more
 * @property limits limits on what a model can request. [LoadLimits.decodedBytes] is by default a part of [memory],
 *   such that all [renders] can use it at the same time; [LoadLimits.time] at most [renderTime]; references lead to
 *   files of the same archive only, whatever [LoadLimits.references] says
 * @property idleTime time for a client to send the next request up to the end of its headers
 * @property uploadTime time for a client to send a model
 * @property uploadRate bytes a second that a client must send on average, after the first 5 seconds; 0 or more
 * @property queueTime time that a request may wait for its rendering; after that it is answered with status 503
 * @property renderTime time for reading and rendering a model, on the wall, so that clients know how long they wait;
 *   after that the work is stopped, status 503
 * @property downloadTime time for a client to receive an answer
 * @property drainTime time for requests that are in work when the server is closed. The end takes at most 5 seconds
 *   more
 * @property log receives one line for each request, without control characters, on a thread of its own. If it is slow,
 *   lines are dropped. Null means the system logger `dev.lazyz.server`, level INFO
 * @throws IllegalArgumentException if a number is out of range, or a time is not positive
 */
public class ServerConfig @JvmOverloads constructor(
    public val host: String = "127.0.0.1",
    public val port: Int = 8080,
    public val adminHost: String = "127.0.0.1",
    public val adminPort: Int? = null,
    public val renders: Int = Runtime.getRuntime().availableProcessors(),
    public val queue: Int = 64,
    public val connections: Int = 1024,
    public val memory: Long = maxOf(Runtime.getRuntime().maxMemory() / 2, LEAST_MEMORY),
    public val body: Long = 64L shl 20,
    public val pixels: Long = 1L shl 24,
    public val limits: LoadLimits = LoadLimits(),
    public val idleTime: Duration = Duration.ofSeconds(30),
    public val uploadTime: Duration = Duration.ofSeconds(60),
    public val uploadRate: Long = 1024,
    public val queueTime: Duration = Duration.ofSeconds(30),
    public val renderTime: Duration = Duration.ofSeconds(30),
    public val downloadTime: Duration = Duration.ofSeconds(60),
    public val drainTime: Duration = Duration.ofSeconds(30),
    public val log: Consumer<String>? = null,
) {
    init {
        require(port in 0..MOST_PORT) { "port must be in 0..$MOST_PORT: $port" }
        require(adminPort == null || adminPort in 0..MOST_PORT) { "adminPort must be in 0..$MOST_PORT: $adminPort" }
        require(renders in 1..MOST_RENDERS) { "renders must be in 1..$MOST_RENDERS: $renders" }
        require(queue in 0..MOST_QUEUE) { "queue must be in 0..$MOST_QUEUE: $queue" }
        require(connections in 1..MOST_CONNECTIONS) { "connections must be in 1..$MOST_CONNECTIONS: $connections" }
        require(memory >= LEAST_MEMORY) { "memory must be at least $LEAST_MEMORY bytes: $memory" }
        val heap = Runtime.getRuntime().maxMemory()
        require(memory <= heap) {
            "memory must be at most the heap, $heap bytes: $memory; start Java with a larger -Xmx"
        }
        require(body >= 1) { "body must be at least 1 byte: $body" }
        require(pixels >= 1) { "pixels must be at least 1: $pixels" }
        require(uploadRate >= 0) { "uploadRate must not be negative: $uploadRate" }
        val times = mapOf(
            "idleTime" to idleTime, "uploadTime" to uploadTime, "queueTime" to queueTime, "renderTime" to renderTime,
            "downloadTime" to downloadTime, "drainTime" to drainTime,
        )
        for ((name, time) in times) {
            require(!time.isNegative && !time.isZero && time <= LONGEST) {
                "$name must be above 0, at most a day: $time"
            }
        }
    }

    /** Returns these settings with another [host]. */
    public fun withHost(host: String): ServerConfig = copy(host = host)

    /** Returns these settings with another [port]. */
    public fun withPort(port: Int): ServerConfig = copy(port = port)

    /** Returns these settings with another [adminHost]. */
    public fun withAdminHost(adminHost: String): ServerConfig = copy(adminHost = adminHost)

    /** Returns these settings with another [adminPort], or without one if null. */
    public fun withAdminPort(adminPort: Int?): ServerConfig = copy(adminPort = adminPort)

    /** Returns these settings with another number of [renders] at the same time. */
    public fun withRenders(renders: Int): ServerConfig = copy(renders = renders)

    /** Returns these settings with another length of the [queue]. */
    public fun withQueue(queue: Int): ServerConfig = copy(queue = queue)

    /** Returns these settings with another number of [connections]. */
    public fun withConnections(connections: Int): ServerConfig = copy(connections = connections)

    /** Returns these settings with another budget of [memory], bytes. */
    public fun withMemory(memory: Long): ServerConfig = copy(memory = memory)

    /** Returns these settings with another limit for the bytes of a model. */
    public fun withBody(body: Long): ServerConfig = copy(body = body)

    /** Returns these settings with another limit for the [pixels] of a picture. */
    public fun withPixels(pixels: Long): ServerConfig = copy(pixels = pixels)

    /** Returns these settings with other [limits] on what a model can request. */
    public fun withLimits(limits: LoadLimits): ServerConfig = copy(limits = limits)

    /** Returns these settings with another time for the headers of a request. */
    public fun withIdleTime(idleTime: Duration): ServerConfig = copy(idleTime = idleTime)

    /** Returns these settings with another time for an upload. */
    public fun withUploadTime(uploadTime: Duration): ServerConfig = copy(uploadTime = uploadTime)

    /** Returns these settings with another minimal rate of an upload, bytes a second. */
    public fun withUploadRate(uploadRate: Long): ServerConfig = copy(uploadRate = uploadRate)

    /** Returns these settings with another time in the queue. */
    public fun withQueueTime(queueTime: Duration): ServerConfig = copy(queueTime = queueTime)

    /** Returns these settings with another time for reading and rendering. */
    public fun withRenderTime(renderTime: Duration): ServerConfig = copy(renderTime = renderTime)

    /** Returns these settings with another time for receiving an answer. */
    public fun withDownloadTime(downloadTime: Duration): ServerConfig = copy(downloadTime = downloadTime)

    /** Returns these settings with another time for the end of the work when the server is closed. */
    public fun withDrainTime(drainTime: Duration): ServerConfig = copy(drainTime = drainTime)

    /** Returns these settings with another receiver of log lines, or with the system logger if null. */
    public fun withLog(log: Consumer<String>?): ServerConfig = copy(log = log)

    private fun copy(
        host: String = this.host,
        port: Int = this.port,
        adminHost: String = this.adminHost,
        adminPort: Int? = this.adminPort,
        renders: Int = this.renders,
        queue: Int = this.queue,
        connections: Int = this.connections,
        memory: Long = this.memory,
        body: Long = this.body,
        pixels: Long = this.pixels,
        limits: LoadLimits = this.limits,
        idleTime: Duration = this.idleTime,
        uploadTime: Duration = this.uploadTime,
        uploadRate: Long = this.uploadRate,
        queueTime: Duration = this.queueTime,
        renderTime: Duration = this.renderTime,
        downloadTime: Duration = this.downloadTime,
        drainTime: Duration = this.drainTime,
        log: Consumer<String>? = this.log,
    ): ServerConfig = ServerConfig(
        host, port, adminHost, adminPort, renders, queue, connections, memory, body, pixels, limits, idleTime,
        uploadTime, uploadRate, queueTime, renderTime, downloadTime, drainTime, log,
    )

    override fun toString(): String =
        "ServerConfig($host:$port, admin=$adminHost:$adminPort, renders=$renders, queue=$queue, " +
            "connections=$connections, memory=$memory, body=$body, pixels=$pixels, $limits)"

    private companion object {
        const val MOST_PORT = 65_535
        const val MOST_RENDERS = 1024
        const val MOST_QUEUE = 100_000
        const val MOST_CONNECTIONS = 1_000_000
        const val LEAST_MEMORY = 1L shl 20
        val LONGEST: Duration = Duration.ofDays(1)
    }
}
