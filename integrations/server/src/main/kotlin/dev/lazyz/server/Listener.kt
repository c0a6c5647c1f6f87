package dev.lazyz.server

import io.netty.bootstrap.ServerBootstrap
import io.netty.buffer.UnpooledByteBufAllocator
import io.netty.channel.ChannelHandler
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
import java.util.concurrent.TimeUnit

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
