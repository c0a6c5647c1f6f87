package dev.lazyz.server

import dev.lazyz.server.render.Problem
import dev.lazyz.server.render.QueuedJob
import io.netty.channel.ChannelHandlerContext
import io.netty.channel.SimpleChannelInboundHandler
import io.netty.channel.socket.SocketChannel
import io.netty.handler.codec.DecoderException
import io.netty.handler.codec.http.DefaultFullHttpResponse
import io.netty.handler.codec.http.HttpContent
import io.netty.handler.codec.http.HttpMethod
import io.netty.handler.codec.http.HttpObject
import io.netty.handler.codec.http.HttpRequest
import io.netty.handler.codec.http.HttpResponseStatus
import io.netty.handler.codec.http.HttpUtil
import io.netty.handler.codec.http.HttpVersion
import io.netty.handler.codec.http.LastHttpContent
import io.netty.handler.codec.http.QueryStringDecoder
import io.netty.util.concurrent.EventExecutor
import java.io.IOException
import java.net.InetSocketAddress
import java.time.Duration
import java.util.concurrent.Future
import java.util.concurrent.RejectedExecutionException
import java.util.concurrent.TimeUnit

/**
 * One connection: takes requests one after the other, and answers each. Everything happens on the event loop of the
 * connection, which never waits; a slow client takes no thread.
 *
 * The connection is read even while a picture is rendered, so the end of a client is noticed at once. Each state has a
 * time limit.
 */
internal class Connection(private val service: Service) : SimpleChannelInboundHandler<HttpObject>() {
    private enum class State { IDLE, UPLOAD, WORK, ANSWER, LINGER, CLOSED }

    private val config = service.config
    private lateinit var context: ChannelHandlerContext
    private lateinit var clock: Clock
    private var state = State.IDLE

    // The request in work
    private var line: RequestLine? = null
    private var render: RenderExchange? = null
    private var job: QueuedJob? = null
    private var isLastRequest = false
    private var isReceived = true
    private var hasBody = false
    private var isHead = false

    /** Whether a request is in work. */
    val isBusy: Boolean get() = line != null

    override fun channelActive(context: ChannelHandlerContext) {
        this.context = context
        clock = Clock(context.executor())
        val open = service.connections.incrementAndGet()
        if (open <= config.connections) return clock.after(config.idleTime) { context.close() }

        // Those few that get an answer stay open for a moment; with many of them, there would be no limit
        begin("-", "-")
        isLastRequest = true
        isReceived = open > 2L * config.connections
        fail(Problem(Problem.UNAVAILABLE, "too many connections are open; try again later", Problem.SOON))
    }

    override fun channelRead0(context: ChannelHandlerContext, message: HttpObject) {
        if (message is HttpRequest) {
            if (state == State.IDLE) head(message) else isLastRequest = true
        }
        if (message is HttpContent) {
            isReceived = isReceived || message is LastHttpContent
            if (state == State.UPLOAD) body(message)
            if (state == State.LINGER && isReceived) context.close()
        }
    }

    override fun channelInactive(context: ChannelHandlerContext) {
        state = State.CLOSED
        clock.end()
        service.connections.decrementAndGet()
        job?.let { service.queue.cancel(it, Problem(Problem.GONE, "the client is gone")) }
        end(Problem.GONE, 0, "the client is gone")
    }

    override fun exceptionCaught(context: ChannelHandlerContext, cause: Throwable) {
        // A client that resets the connection, or sends what is not HTTP or too many requests at a time, is not worth a
        // line; its request is in the log
        if (cause !is IOException && cause !is DecoderException) service.report(cause)
        context.close()
    }

    /** Ends this connection after the request in work, or at once if there is none. */
    fun drain() {
        isLastRequest = true
        if (!isBusy && state == State.IDLE) context.close()
    }

    private fun head(request: HttpRequest) {
        begin(request.method().name(), request.uri())
        isReceived = false
        isHead = request.method() == HttpMethod.HEAD
        val problem = RequestHead.problem(request)
        isLastRequest = service.isDraining || !HttpUtil.isKeepAlive(request) || problem != null
        if (problem != null) return fail(problem)
        hasBody = RequestHead.hasBody(request)
        try {
            val target = QueryStringDecoder(RequestHead.originForm(request.uri()))
            if (target.path() != "/render") return send(Pages.help(request.method(), target.path()))
            val render = RenderExchange(service, request, target.parameters())
            this.render = render
            state = State.UPLOAD
            clock.after(config.uploadTime) {
                fail(tooSlow("the model was not sent within ${config.uploadTime.seconds} s"))
            }
            clock.each(RATE_PERIOD) { checkRate(render) }
            if (HttpUtil.is100ContinueExpected(request)) {
                context.writeAndFlush(DefaultFullHttpResponse(HttpVersion.HTTP_1_1, HttpResponseStatus.CONTINUE))
            }
        } catch (problem: Problem) {
            fail(problem)
        } catch (_: IllegalArgumentException) {
            fail(Problem(Problem.BAD_REQUEST, "the address cannot be read: after a % stand two digits"))
        }
    }

    private fun body(content: HttpContent) {
        val render = checkNotNull(render)
        try {
            if (content.decoderResult().isFailure) {
                isLastRequest = true
                throw Problem(Problem.BAD_REQUEST, "the body is not valid HTTP: its chunks cannot be read")
            }
            val bytes = content.content()
            val count = bytes.readableBytes()
            render.upload.add(count) { array, at, length -> bytes.readBytes(array, at, length) }
            if (content is LastHttpContent) enqueue(render)
        } catch (problem: Problem) {
            fail(problem)
        }
    }

    private fun checkRate(render: RenderExchange) {
        if (state != State.UPLOAD) return
        val seconds = checkNotNull(line).seconds
        if (seconds > RATE_GRACE && render.upload.size < config.uploadRate * seconds) {
            fail(tooSlow("the model must be sent with ${config.uploadRate} bytes a second"))
        }
    }

    private fun tooSlow(message: String) = Problem(Problem.TIMEOUT, message)

    private fun enqueue(render: RenderExchange) {
        clock.endEach()
        val job = render.enqueue(
            started = { later { started() } },
            ended = { outcome -> if (!later { ended(outcome) }) giveBack(outcome) },
        )
        this.job = job
        state = State.WORK
        clock.after(config.queueTime) {
            service.queue.cancelIfWaiting(
                job,
                Problem(Problem.UNAVAILABLE, "the model has waited for ${config.queueTime.seconds} s", Problem.SOON),
            )
        }
    }

    private fun started() {
        val job = job ?: return
        clock.after(config.renderTime) {
            val problem = Problem(Problem.UNAVAILABLE, "the picture took longer than ${config.renderTime.seconds} s")
            service.queue.cancel(job, problem)
        }
    }

    private fun ended(outcome: QueuedJob.Outcome) {
        outcome.bug?.let(service::report)
        if (state != State.WORK) return giveBack(outcome)
        if (outcome.problem != null) return fail(outcome.problem)
        val picture = checkNotNull(outcome.picture)
        send(Answer.picture(picture, checkNotNull(render).known)) { giveBack(outcome) }
    }

    private fun giveBack(outcome: QueuedJob.Outcome) {
        outcome.picture?.let { service.queue.giveBack(it.memory) }
    }

    private fun fail(problem: Problem) = send(Answer.problem(problem))

    private fun send(answer: Answer, sent: () -> Unit = {}) {
        state = State.ANSWER

        // What is still to come of a body is not awaited, and perhaps never comes
        if (!isReceived && hasBody) isLastRequest = true
        clock.endEach()
        releaseUpload()
        clock.after(config.downloadTime) { context.close() }
        answer.write(context, isHead, isLastRequest).addListener { future ->
            sent()
            if (future.isSuccess && state == State.ANSWER) {
                if (answer.picture != null) service.sent.add(answer.size.toLong())
                end(answer.status.code(), answer.size, answer.detail)
                next()
            }
        }
    }

    /** Waits for the next request, or closes the connection. */
    private fun next() {
        if (!isLastRequest) {
            state = State.IDLE
            clock.after(config.idleTime) { context.close() }
            return
        }
        if (isReceived) {
            context.close()
            return
        }
        // A close while data arrives would destroy the answer before the client has read it
        state = State.LINGER
        (context.channel() as SocketChannel).shutdownOutput()
        clock.after(LINGER) { context.close() }
    }

    private fun begin(method: String, target: String) {
        line = RequestLine(method, target)
        service.requests.incrementAndGet()
    }

    /** Counts and logs the request, which has ended. */
    private fun end(status: Int, size: Int, detail: String) {
        val line = line ?: return
        this.line = null
        clock.endEach()
        releaseUpload()
        render = null
        job = null
        service.count(status)
        service.requests.decrementAndGet()
        val client = (context.channel().remoteAddress() as? InetSocketAddress)?.address?.hostAddress
        service.log.add(line.entry(client ?: "-", status, size, detail))
    }

    /** Releases an upload without a job; a job releases its own when it ends. */
    private fun releaseUpload() {
        if (job == null) render?.upload?.release()
    }

    /** Runs [act] on the event loop, or returns false if that has ended. */
    private fun later(act: () -> Unit): Boolean = try {
        context.executor().execute(act)
        true
    } catch (_: RejectedExecutionException) {
        false
    }

    private companion object {
        const val RATE_GRACE = 5.0
        val RATE_PERIOD: Duration = Duration.ofSeconds(1)
        val LINGER: Duration = Duration.ofSeconds(2)
    }
}

/** The time limit of a connection, and what it checks from time to time. Used on its event loop, [executor]. */
internal class Clock(private val executor: EventExecutor) {
    private var limit: Future<*>? = null
    private var repetition: Future<*>? = null

    /** Calls [act] after [time], in place of the limit before. */
    fun after(time: Duration, act: () -> Unit) {
        end()
        limit = executor.schedule(act, time.toMillis(), TimeUnit.MILLISECONDS)
    }

    /** Ends the limit. */
    fun end() {
        limit?.cancel(false)
    }

    /** Calls [act] once each [time], in place of the repetition before. */
    fun each(time: Duration, act: () -> Unit) {
        endEach()
        repetition = executor.scheduleAtFixedRate(act, time.toMillis(), time.toMillis(), TimeUnit.MILLISECONDS)
    }

    /** Ends the repetition. */
    fun endEach() {
        repetition?.cancel(false)
    }
}
