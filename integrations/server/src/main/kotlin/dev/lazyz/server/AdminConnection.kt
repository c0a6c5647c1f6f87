package dev.lazyz.server

import dev.lazyz.server.render.Problem
import io.netty.channel.ChannelFutureListener
import io.netty.channel.ChannelHandlerContext
import io.netty.channel.SimpleChannelInboundHandler
import io.netty.handler.codec.http.HttpMethod
import io.netty.handler.codec.http.HttpObject
import io.netty.handler.codec.http.HttpRequest
import java.time.Duration

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
