package dev.lazyz.server

import dev.lazyz.server.render.Problem
import dev.lazyz.server.render.RenderJob
import io.netty.buffer.Unpooled
import io.netty.channel.ChannelFuture
import io.netty.channel.ChannelHandlerContext
import io.netty.channel.SimpleChannelInboundHandler
import io.netty.channel.socket.SocketChannel
import io.netty.handler.codec.TooLongFrameException
import io.netty.handler.codec.http.DefaultFullHttpResponse
import io.netty.handler.codec.http.DefaultHttpResponse
import io.netty.handler.codec.http.HttpChunkedInput
import io.netty.handler.codec.http.HttpContent
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpHeaderValues
import io.netty.handler.codec.http.HttpMethod
import io.netty.handler.codec.http.HttpObject
import io.netty.handler.codec.http.HttpRequest
import io.netty.handler.codec.http.HttpResponseStatus
import io.netty.handler.codec.http.HttpUtil
import io.netty.handler.codec.http.HttpVersion
import io.netty.handler.codec.http.LastHttpContent
import io.netty.handler.codec.http.QueryStringDecoder
import io.netty.handler.codec.http.TooLongHttpHeaderException
import io.netty.handler.codec.http.TooLongHttpLineException
import io.netty.handler.stream.ChunkedStream
import java.io.IOException
import java.net.InetSocketAddress
import java.time.Duration
import java.util.concurrent.Future as Timer
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
    private val pages = Pages(service)
    private lateinit var context: ChannelHandlerContext
    private var state = State.IDLE
    private var timer: Timer<*>? = null
    private var rateTimer: Timer<*>? = null

    // The request in work
    private var line: RequestLine? = null
    private var render: RenderRequest? = null
    private var job: RenderJob? = null
    private var isLastRequest = false
    private var isReceived = true
    private var isHead = false

    /** Whether a request is in work. */
    val isBusy: Boolean get() = line != null

    override fun channelActive(context: ChannelHandlerContext) {
        this.context = context
        val open = service.connections.incrementAndGet()
        if (open <= config.connections) return after(config.idleTime) { context.close() }

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
        timer?.cancel(false)
        service.connections.decrementAndGet()
        job?.let { service.queue.cancel(it, Problem(Problem.GONE, "the client is gone")) }
        end(Problem.GONE, 0, "the client is gone")
    }

    override fun exceptionCaught(context: ChannelHandlerContext, cause: Throwable) {
        // A connection that is reset by the client is not worth a line; its request is in the log
        if (cause !is IOException) service.report(cause)
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
        isLastRequest = service.isDraining || !HttpUtil.isKeepAlive(request)
        try {
            requireValid(request)
            val target = QueryStringDecoder(request.uri())
            if (target.path() != "/render") return page(request, target.path())
            val render = RenderRequest(service, request, target.parameters())
            this.render = render
            state = State.UPLOAD
            after(config.uploadTime) { fail(tooSlow("the model was not sent within ${config.uploadTime.seconds} s")) }
            rateTimer = each(RATE_PERIOD) { checkRate(render) }
            if (HttpUtil.is100ContinueExpected(request)) {
                context.writeAndFlush(DefaultFullHttpResponse(HttpVersion.HTTP_1_1, HttpResponseStatus.CONTINUE))
            }
        } catch (problem: Problem) {
            fail(problem)
        } catch (e: IllegalArgumentException) {
            fail(Problem(Problem.BAD_REQUEST, "the address cannot be read: ${e.message}"))
        }
    }

    private fun requireValid(request: HttpRequest) {
        val cause = request.decoderResult().cause()
        if (cause != null) {
            isLastRequest = true
            throw when (cause) {
                is TooLongHttpLineException -> Problem(414, "the address is too long")
                is TooLongHttpHeaderException -> Problem(431, "the headers are too long")
                is TooLongFrameException -> Problem(431, "the headers are too long")
                else -> Problem(Problem.BAD_REQUEST, "this is not HTTP: ${cause.message}")
            }
        }
        val expectation = request.headers().get(HttpHeaderNames.EXPECT)
        if (expectation != null && !expectation.equals("100-continue", ignoreCase = true)) {
            throw Problem(Problem.EXPECTATION_FAILED, "the expectation '$expectation' is not supported")
        }
    }

    private fun page(request: HttpRequest, path: String) {
        val answer = pages.answer(path) ?: throw Problem(Problem.NOT_FOUND, "there is nothing at $path; see /")
        if (request.method() != HttpMethod.GET && request.method() != HttpMethod.HEAD) {
            throw Problem(Problem.METHOD_NOT_ALLOWED, "$path is read with GET")
        }
        send(answer)
    }

    private fun body(content: HttpContent) {
        val render = checkNotNull(render)
        try {
            if (content.decoderResult().isFailure) {
                isLastRequest = true
                val cause = content.decoderResult().cause()
                throw Problem(Problem.BAD_REQUEST, "the body is not valid HTTP: ${cause.message}")
            }
            val bytes = content.content()
            val count = bytes.readableBytes()
            if (count > 0) render.upload.add(count) { array, at -> bytes.readBytes(array, at, count) }
            if (content is LastHttpContent) enqueue(render)
        } catch (problem: Problem) {
            fail(problem)
        }
    }

    private fun checkRate(render: RenderRequest) {
        if (state != State.UPLOAD) return
        val seconds = checkNotNull(line).seconds
        if (seconds > RATE_GRACE && render.upload.size < config.uploadRate * seconds) {
            fail(tooSlow("the model must be sent with ${config.uploadRate} bytes a second"))
        }
    }

    private fun tooSlow(message: String) = Problem(Problem.TIMEOUT, message)

    private fun enqueue(render: RenderRequest) {
        rateTimer?.cancel(false)
        val job = render.enqueue(
            started = { later { started() } },
            ended = { outcome -> if (!later { ended(outcome) }) giveBack(outcome) },
        )
        this.job = job
        state = State.WORK
        after(config.queueTime) {
            service.queue.cancelIfWaiting(
                job,
                Problem(Problem.UNAVAILABLE, "the model has waited for ${config.queueTime.seconds} s", Problem.SOON),
            )
        }
    }

    private fun started() {
        val job = job ?: return
        after(config.renderTime) {
            val problem = Problem(Problem.UNAVAILABLE, "the picture took longer than ${config.renderTime.seconds} s")
            service.queue.cancel(job, problem)
        }
    }

    private fun ended(outcome: RenderJob.Outcome) {
        outcome.bug?.let(service::report)
        if (state != State.WORK) return giveBack(outcome)
        if (outcome.problem != null) return fail(outcome.problem)
        val picture = checkNotNull(outcome.picture)
        send(Answer.picture(picture, checkNotNull(render).known)) { giveBack(outcome) }
    }

    private fun giveBack(outcome: RenderJob.Outcome) {
        outcome.picture?.let { service.queue.giveBack(it.size.toLong()) }
    }

    private fun fail(problem: Problem) {
        // What of the model is still to come is not awaited
        if (!isReceived && line?.mayHaveBody == true) isLastRequest = true
        val answer = Answer.problem(problem)
        if (problem.status == Problem.METHOD_NOT_ALLOWED) {
            answer.headers.set(HttpHeaderNames.ALLOW, if (line?.isRender == true) "POST" else "GET, HEAD")
        }
        send(answer)
    }

    private fun send(answer: Answer, sent: () -> Unit = {}) {
        state = State.ANSWER
        rateTimer?.cancel(false)
        releaseUpload()
        after(config.downloadTime) { context.close() }
        val size = answer.picture?.size ?: answer.text.toByteArray().size
        val headers = answer.headers
        if (answer.status != HttpResponseStatus.NOT_MODIFIED) headers.set(HttpHeaderNames.CONTENT_LENGTH, size)
        val connection = if (isLastRequest) HttpHeaderValues.CLOSE else HttpHeaderValues.KEEP_ALIVE
        headers.set(HttpHeaderNames.CONNECTION, connection)
        val written = if (answer.picture != null) {
            context.write(DefaultHttpResponse(HttpVersion.HTTP_1_1, answer.status, headers))
            context.writeAndFlush(HttpChunkedInput(ChunkedStream(answer.picture.open(), CHUNK)))
        } else {
            val text = if (isHead) Unpooled.EMPTY_BUFFER else Unpooled.wrappedBuffer(answer.text.toByteArray())
            val response = DefaultFullHttpResponse(HttpVersion.HTTP_1_1, answer.status, text)
            response.headers().set(headers)
            context.writeAndFlush(response)
        }
        written.addListener { future ->
            sent()
            if (future.isSuccess && state == State.ANSWER) {
                if (answer.picture != null) service.sent.add(size.toLong())
                end(answer.status.code(), size, answer.detail)
                next()
            }
        }
    }

    /** Waits for the next request, or closes the connection. */
    private fun next() {
        if (!isLastRequest) {
            state = State.IDLE
            after(config.idleTime) { context.close() }
            return
        }
        if (isReceived) {
            context.close()
            return
        }
        // A close while data arrives would destroy the answer before the client has read it
        state = State.LINGER
        (context.channel() as SocketChannel).shutdownOutput()
        after(LINGER) { context.close() }
    }

    private fun begin(method: String, target: String) {
        line = RequestLine(method, target)
        service.requests.incrementAndGet()
    }

    /** Counts and logs the request, which has ended. */
    private fun end(status: Int, size: Int, detail: String) {
        val line = line ?: return
        this.line = null
        rateTimer?.cancel(false)
        releaseUpload()
        render = null
        job = null
        service.count(status)
        service.requests.decrementAndGet()
        val client = (context.channel().remoteAddress() as? InetSocketAddress)?.address?.hostAddress
        service.log(line.entry(client ?: "-", status, size, detail))
    }

    /** Releases an upload without a job; a job releases its own when it ends. */
    private fun releaseUpload() {
        if (job == null) render?.upload?.release()
    }

    /** Sets the time limit of the state. */
    private fun after(time: Duration, act: () -> Unit) {
        timer?.cancel(false)
        timer = context.executor().schedule(act, time.toMillis(), TimeUnit.MILLISECONDS)
    }

    private fun each(time: Duration, act: () -> Unit): Timer<*> =
        context.executor().scheduleAtFixedRate(act, time.toMillis(), time.toMillis(), TimeUnit.MILLISECONDS)

    /** Runs [act] on the event loop, or returns false if that has ended. */
    private fun later(act: () -> Unit): Boolean = try {
        context.executor().execute(act)
        true
    } catch (_: RejectedExecutionException) {
        false
    }

    private companion object {
        const val CHUNK = 1 shl 16
        const val RATE_GRACE = 5.0
        val RATE_PERIOD: Duration = Duration.ofSeconds(1)
        val LINGER: Duration = Duration.ofSeconds(2)
    }
}
