package dev.lazyz.server

import dev.lazyz.server.render.Problem
import io.netty.handler.codec.TooLongFrameException
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpHeaderValues
import io.netty.handler.codec.http.HttpObjectDecoder
import io.netty.handler.codec.http.HttpRequest
import io.netty.handler.codec.http.HttpUtil
import io.netty.handler.codec.http.HttpVersion
import io.netty.handler.codec.http.TooLongHttpHeaderException
import io.netty.handler.codec.http.TooLongHttpLineException
import java.time.Instant
import java.time.temporal.ChronoUnit

/** The first line and the headers of a request, as RFC 9110 and RFC 9112 define them. */
internal object RequestHead {
    private val schemes = listOf("http://", "https://")

    /** The characters of names and numbers of hosts besides letters and digits. */
    private const val HOST_SIGNS = "_.~!$&'()*+,;=%-"

    /** The colon and the space after the name of a header, and the end of its line. */
    private const val HEADER_EXTRA = 4

    /** Returns [target] without scheme and host, which clients put in front of it if they think of a proxy. */
    fun originForm(target: String): String {
        val scheme = schemes.firstOrNull { target.startsWith(it, ignoreCase = true) } ?: return target
        val behind = target.substring(scheme.length).dropWhile { it !in "/?#" }
        if (behind.length == target.length - scheme.length) return target
        return if (behind.startsWith("/")) behind else "/$behind"
    }

    /** Whether [text] is a name, which can be empty, or a number in brackets, and perhaps a port. */
    private fun isHost(text: String): Boolean {
        val number = text.substringBefore(']', "")
        val host = if (number.isEmpty()) text.substringBefore(':') else "$number]"
        val isValid = if (number.isEmpty()) {
            host.all { isLetterOrDigit(it) || it in HOST_SIGNS }
        } else {
            number.length > 1 && number[0] == '[' && number.drop(1).all { isLetterOrDigit(it) || it in "_.:" }
        }
        val port = text.substring(host.length)
        return isValid && (port.isEmpty() || (port[0] == ':' && port.drop(1).all { it in '0'..'9' }))
    }

    private fun isLetterOrDigit(character: Char): Boolean = character < '\u0080' && character.isLetterOrDigit()

    /** Returns whether a body follows the head. */
    fun hasBody(request: HttpRequest): Boolean =
        HttpUtil.isTransferEncodingChunked(request) || HttpUtil.getContentLength(request, 0L) > 0

    /**
     * Returns what is wrong with [request] if it is not valid HTTP, or expects what the server cannot do, otherwise
     * null. After that it is uncertain where the next request begins.
     */
    fun problem(request: HttpRequest): Problem? {
        val cause = request.decoderResult().cause()
        return if (cause != null) invalid(cause) else version(request) ?: headers(request) ?: expectation(request)
    }

    private fun invalid(cause: Throwable): Problem = when (cause) {
        is TooLongHttpLineException -> Problem(Problem.TARGET_TOO_LONG, "the address is too long")
        is TooLongHttpHeaderException, is TooLongFrameException -> tooLong()
        else -> Problem(Problem.BAD_REQUEST, "the first line or a header is not valid HTTP")
    }

    private fun tooLong() = Problem(Problem.HEADERS_TOO_LONG, "the headers are too long")

    private fun version(request: HttpRequest): Problem? {
        val version = request.protocolVersion()
        if (version.majorVersion() == 1) return null
        return Problem(Problem.VERSION_UNSUPPORTED, "$version is not supported; use HTTP/1.1")
    }

    private fun headers(request: HttpRequest): Problem? {
        val headers = request.headers()

        // The decoder does not count the ends of lines
        val size = headers.sumOf { it.key.length + it.value.length + HEADER_EXTRA }
        if (size > HttpObjectDecoder.DEFAULT_MAX_HEADER_SIZE) return tooLong()

        val hosts = headers.getAll(HttpHeaderNames.HOST)
        val least = if (request.protocolVersion() == HttpVersion.HTTP_1_0) 0 else 1
        if (hosts.size !in least..1 || !hosts.all(::isHost)) {
            return Problem(Problem.BAD_REQUEST, "a request has one header Host, with a name or a number")
        }

        // The decoder reads chunks, and requires that they are the last coding
        val coding = headers.getAll(HttpHeaderNames.TRANSFER_ENCODING).joinToString()
        if (coding.isEmpty() || HttpHeaderValues.CHUNKED.contentEqualsIgnoreCase(coding)) return null
        return Problem(
            Problem.NOT_IMPLEMENTED,
            "transfer coding '$coding' is not supported; send the model as it is, or chunked",
        )
    }

    private fun expectation(request: HttpRequest): Problem? {
        val expectation = request.headers().get(HttpHeaderNames.EXPECT)
        if (expectation == null || HttpHeaderValues.CONTINUE.contentEqualsIgnoreCase(expectation)) return null
        return Problem(Problem.EXPECTATION_FAILED, "the expectation '$expectation' is not supported")
    }
}

/** What the log says about a request, and when it began. */
internal class RequestLine(private val method: String, private val target: String) {
    private val time = Instant.now().truncatedTo(ChronoUnit.MILLIS)
    private val start = System.nanoTime()

    /** The time since the request began. */
    val seconds: Double get() = (System.nanoTime() - start) / 1e9

    /** Returns the line of the log. */
    fun entry(client: String, status: Int, size: Int, detail: String): String {
        val words = listOf(
            "$time", client, method, target.take(LONGEST), "$status", "${size}B", "${(seconds * 1000).toLong()}ms",
            detail.take(LONGEST),
        )
        return words.filter { it.isNotEmpty() }.joinToString(" ")
    }

    private companion object {
        const val LONGEST = 300
    }
}
