package dev.lazyz.server

import dev.lazyz.server.render.Problem
import io.netty.bootstrap.ServerBootstrap
import io.netty.buffer.UnpooledByteBufAllocator
import io.netty.channel.ChannelFutureListener
import io.netty.channel.ChannelHandler
import io.netty.channel.ChannelHandlerContext
import io.netty.channel.ChannelInitializer
import io.netty.channel.ChannelOption
import io.netty.channel.MultiThreadIoEventLoopGroup
import io.netty.channel.SimpleChannelInboundHandler
import io.netty.channel.group.DefaultChannelGroup
import io.netty.channel.nio.NioIoHandler
import io.netty.channel.socket.SocketChannel
import io.netty.channel.socket.nio.NioServerSocketChannel
import io.netty.handler.codec.http.HttpMethod
import io.netty.handler.codec.http.HttpObject
import io.netty.handler.codec.http.HttpRequest
import io.netty.handler.codec.http.HttpServerCodec
import io.netty.handler.stream.ChunkedWriteHandler
import io.netty.util.concurrent.DefaultThreadFactory
import io.netty.util.concurrent.GlobalEventExecutor
import java.io.IOException
import java.net.InetSocketAddress
import java.nio.channels.UnresolvedAddressException
import java.time.Duration
import java.util.concurrent.TimeUnit

/**
 * An HTTP server that renders models: `POST /render` with a model as the body is answered with a picture of it, or data
 * of its pixels.
 *
 * ```
 * RenderServer(ServerConfig(port = 0)).start().use { server ->
 *     println("http://127.0.0.1:${server.port}/")
 * }
 * ```
 *
 * Requests, answers and limits are described in `docs/server.md`. The pictures are those of `zcli render` with the
 * options of the same names, bit for bit. All threads are daemons: the server ends with the process. Thread safe.
 *
 * @property config the settings
 */
public class RenderServer @JvmOverloads constructor(public val config: ServerConfig = ServerConfig()) : AutoCloseable {
    private class Running(val service: Service, val pictures: Listener, val admin: Listener?)

    // Read without the lock, which close() holds until the last answer is sent
    @Volatile
    private var running: Running? = null
    private var isClosed = false

    /**
     * The port at which the server listens.
     *
     * @throws IllegalStateException if it is not running
     */
    public val port: Int get() = running().pictures.port

    /**
     * The port at which the server answers about its health and its metrics.
     *
     * @throws IllegalStateException if it is not running, or has no such port
     */
    public val adminPort: Int get() = checkNotNull(running().admin) { "the configuration has no adminPort" }.port

    /**
     * Starts listening. Returns this server when it can be reached.
     *
     * @throws IOException if the address is unknown or in use
     * @throws IllegalStateException if the server was started before
     */
    @Synchronized
    @Throws(IOException::class)
    public fun start(): RenderServer {
        check(running == null && !isClosed) { "a server can be started once" }
        val service = Service(config)
        var pictures: Listener? = null
        try {
            pictures = Listener(config.host, config.port, IO_THREADS) { Connection(service) }
            val admin = config.adminPort?.let { Listener(config.adminHost, it, 1) { AdminConnection(service) } }
            running = Running(service, pictures, admin)
        } catch (e: IOException) {
            pictures?.close()
            service.close()
            throw e
        }
        return this
    }

    /**
     * Returns the numbers that `GET /metrics` shows, in the text format of Prometheus.
     *
     * @throws IllegalStateException if the server is not running
     */
    public fun metrics(): String = running().service.metrics.text()

    /**
     * Stops listening, waits until the requests in work are answered, at most for [ServerConfig.drainTime], stops those
     * that are left, and ends all threads: at most 5 seconds later, also if a rendering does not react. Health and
     * metrics can be read until the end. Calling it again does nothing.
     */
    @Synchronized
    override fun close() {
        isClosed = true
        val closing = running ?: return
        val service = closing.service
        service.isDraining = true
        closing.pictures.stop()
        for (channel in closing.pictures.channels) {
            val connection = channel.pipeline().get(Connection::class.java) ?: continue
            channel.eventLoop().execute { connection.drain() }
        }
        val isInterrupted = !awaitAnswers(service, config.drainTime)

        // Those that are left get an answer, too
        service.queue.close()
        awaitAnswers(service, LAST_ANSWERS)
        closing.pictures.close()
        closing.admin?.close()
        service.close()
        running = null
        if (isInterrupted) Thread.currentThread().interrupt()
    }

    /** Waits until all requests are answered, or [time] is over. Returns false if the thread is interrupted. */
    private fun awaitAnswers(service: Service, time: Duration): Boolean = try {
        val end = System.nanoTime() + time.toNanos()
        while (service.requests.get() > 0 && System.nanoTime() < end) Thread.sleep(POLL)
        true
    } catch (_: InterruptedException) {
        false
    }

    private fun running(): Running = checkNotNull(running) { "the server is not running" }

    override fun toString(): String = "RenderServer($config)"

    private companion object {
        /** They only move bytes. */
        const val IO_THREADS = 2

        /** Milliseconds. */
        const val POLL = 10L
        val LAST_ANSWERS: Duration = Duration.ofMillis(500)
    }
}

/**
 * A connection to the port for health and metrics: one request, one answer, and the end. It has an event loop of its
 * own, so that it says how the process is however many clients there are.
 */
internal class AdminConnection(private val service: Service) : SimpleChannelInboundHandler<HttpObject>() {
    private var isAnswered = false

    override fun channelActive(context: ChannelHandlerContext) {
        Clock(context.executor()).after(LONGEST) { context.close() }
    }

    override fun channelRead0(context: ChannelHandlerContext, message: HttpObject) {
        if (message !is HttpRequest || isAnswered) return
        isAnswered = true
        val answer = try {
            RequestHead.problem(message)?.let { throw it }
            val path = RequestHead.originForm(message.uri()).substringBefore('?')
            Pages.admin(service, message.method(), path)
        } catch (problem: Problem) {
            Answer.problem(problem)
        }
        answer.write(context, message.method() == HttpMethod.HEAD, true).addListener(ChannelFutureListener.CLOSE)
    }

    override fun exceptionCaught(context: ChannelHandlerContext, cause: Throwable) {
        context.close()
    }

    private companion object {
        /** For the request and the answer. */
        val LONGEST: Duration = Duration.ofSeconds(10)
    }
}

/**
 * A port at which the server listens for HTTP, with event loops of its own.
 *
 * @param handler returns the handler of a new connection
 * @throws IOException if the address is unknown or in use
 */
internal class Listener(host: String, port: Int, threads: Int, handler: () -> ChannelHandler) : AutoCloseable {
    private val loops = MultiThreadIoEventLoopGroup(
        threads,
        DefaultThreadFactory("lazyz-io", true),
        NioIoHandler.newFactory(),
    )
    private val listening: NioServerSocketChannel

    /** The open connections. */
    val channels = DefaultChannelGroup(GlobalEventExecutor.INSTANCE, true)

    init {
        val bound = ServerBootstrap().group(loops)
            .channel(NioServerSocketChannel::class.java)
            .option(ChannelOption.SO_BACKLOG, BACKLOG)
            .childOption(ChannelOption.ALLOCATOR, UnpooledByteBufAllocator(false))
            .childHandler(
                object : ChannelInitializer<SocketChannel>() {
                    override fun initChannel(channel: SocketChannel) {
                        channels.add(channel)
                        channel.pipeline().addLast(HttpServerCodec(), ChunkedWriteHandler(), handler())
                    }
                },
            )
            .bind(InetSocketAddress(host, port))
            .awaitUninterruptibly()
        if (!bound.isSuccess) {
            loops.shutdownGracefully(0, 0, TimeUnit.SECONDS)
            throw IOException("cannot listen at $host:$port: ${reason(bound.cause())}", bound.cause())
        }
        listening = bound.channel() as NioServerSocketChannel
    }

    /** The port. */
    val port: Int = listening.localAddress().port

    /** Accepts no more connections. */
    fun stop() {
        listening.close().awaitUninterruptibly(LAST_STEP)
    }

    /** Closes all connections, and ends the event loops. */
    override fun close() {
        stop()
        channels.close().awaitUninterruptibly(LAST_STEP)
        loops.shutdownGracefully(0, LAST_STEP, TimeUnit.MILLISECONDS).awaitUninterruptibly(2 * LAST_STEP)
    }

    private fun reason(failure: Throwable): String = when (failure) {
        is UnresolvedAddressException ->
            "the host is unknown; use the name or number of an address of this machine"
        else -> failure.message ?: failure.toString()
    }

    private companion object {
        const val BACKLOG = 1024

        /** Milliseconds that each step of the end takes at most; otherwise it goes on without. */
        const val LAST_STEP = 150L
    }
}
