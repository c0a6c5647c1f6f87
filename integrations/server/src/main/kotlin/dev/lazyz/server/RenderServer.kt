package dev.lazyz.server

import io.netty.bootstrap.ServerBootstrap
import io.netty.buffer.UnpooledByteBufAllocator
import io.netty.channel.ChannelInitializer
import io.netty.channel.ChannelOption
import io.netty.channel.MultiThreadIoEventLoopGroup
import io.netty.channel.group.DefaultChannelGroup
import io.netty.channel.nio.NioIoHandler
import io.netty.channel.socket.SocketChannel
import io.netty.channel.socket.nio.NioServerSocketChannel
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
 * An HTTP server that renders models: `POST /render` with a model as the body is answered with a PNG file.
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
    private class Running(
        val service: Service,
        val threads: MultiThreadIoEventLoopGroup,
        val channels: DefaultChannelGroup,
        val listening: NioServerSocketChannel,
    ) {
        val port = listening.localAddress().port
    }

    // Read without the lock, which close() holds until the last answer is sent
    @Volatile
    private var running: Running? = null
    private var isClosed = false

    /**
     * The port at which the server listens.
     *
     * @throws IllegalStateException if it is not running
     */
    public val port: Int get() = running().port

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
        val factory = NioIoHandler.newFactory()
        val threads = MultiThreadIoEventLoopGroup(IO_THREADS, DefaultThreadFactory("lazyz-io", true), factory)
        val channels = DefaultChannelGroup(GlobalEventExecutor.INSTANCE, true)
        val bound = ServerBootstrap().group(threads)
            .channel(NioServerSocketChannel::class.java)
            .option(ChannelOption.SO_BACKLOG, BACKLOG)
            .childOption(ChannelOption.ALLOCATOR, UnpooledByteBufAllocator(false))
            .childHandler(
                object : ChannelInitializer<SocketChannel>() {
                    override fun initChannel(channel: SocketChannel) {
                        channels.add(channel)
                        channel.pipeline().addLast(HttpServerCodec(), ChunkedWriteHandler(), Connection(service))
                    }
                },
            )
            .bind(InetSocketAddress(config.host, config.port))
            .awaitUninterruptibly()
        if (!bound.isSuccess) {
            service.close()
            threads.shutdownGracefully(0, 0, TimeUnit.SECONDS)
            throw IOException("cannot listen at ${config.host}:${config.port}: ${reason(bound.cause())}", bound.cause())
        }
        running = Running(service, threads, channels, bound.channel() as NioServerSocketChannel)
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
     * that are left, and ends all threads. Calling it again does nothing.
     */
    @Synchronized
    override fun close() {
        isClosed = true
        val closing = running ?: return
        val service = closing.service
        service.isDraining = true
        closing.listening.close().awaitUninterruptibly()
        for (channel in closing.channels) {
            val connection = channel.pipeline().get(Connection::class.java) ?: continue
            channel.eventLoop().execute { connection.drain() }
        }
        val isInterrupted = !awaitAnswers(service, config.drainTime)

        // Those that are left get an answer, too
        service.close()
        awaitAnswers(service, LAST_ANSWERS)
        closing.channels.close().awaitUninterruptibly()
        closing.threads.shutdownGracefully(0, 1, TimeUnit.SECONDS).awaitUninterruptibly()
        running = null
        if (isInterrupted) Thread.currentThread().interrupt()
    }

    private fun reason(failure: Throwable): String = when (failure) {
        is UnresolvedAddressException ->
            "the host is unknown; use the name or number of an address of this machine"
        else -> failure.message ?: failure.toString()
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
        const val BACKLOG = 1024

        /** Milliseconds. */
        const val POLL = 10L
        val LAST_ANSWERS: Duration = Duration.ofSeconds(2)
    }
}
