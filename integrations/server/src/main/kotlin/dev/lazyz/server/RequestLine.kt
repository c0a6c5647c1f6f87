package dev.lazyz.server

import dev.lazyz.server.render.Problem
import io.netty.handler.codec.TooLongFrameException
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpRequest
import io.netty.handler.codec.http.TooLongHttpHeaderException
import io.netty.handler.codec.http.TooLongHttpLineException
import java.time.Instant
import java.time.temporal.ChronoUnit

/** What the log says about a request, and when it began. */
internal class RequestLine(private val method: String, private val target: String) {
    private val time = Instant.now().truncatedTo(ChronoUnit.MILLIS)
    private val start = System.nanoTime()

    /** The time since the request began. */
    val seconds: Double get() = (System.nanoTime() - start) / 1e9

    /** Whether the request is for a picture. */
    val isRender: Boolean get() = target.substringBefore('?') == "/render"

    /** Whether a body that nobody has read can follow. */
    val mayHaveBody: Boolean get() = method != "GET" && method != "HEAD"

    /** Returns the line of the log. */
    fun entry(client: String, status: Int, size: Int, detail: String): String {
        val words = listOf(
            "$time", client, method, target.take(LONGEST), "$status", "${size}B", "${(seconds * 1000).toLong()}ms",
            detail.take(LONGEST),
        )
        return words.filter { it.isNotEmpty() }.joinToString(" ")
    }

    companion object {
        private const val LONGEST = 300

        /** Throws [Problem] if [request] is not valid HTTP, or expects what the server cannot do. */
        fun requireValid(request: HttpRequest) {
            val cause = request.decoderResult().cause()
            if (cause != null) {
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
    }
}
