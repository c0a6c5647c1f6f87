package dev.lazyz.server

import dev.lazyz.server.render.Problem
import dev.lazyz.server.render.RenderedPicture
import io.netty.buffer.Unpooled
import io.netty.channel.ChannelFuture
import io.netty.channel.ChannelHandlerContext
import io.netty.handler.codec.DateFormatter
import io.netty.handler.codec.http.DefaultFullHttpResponse
import io.netty.handler.codec.http.DefaultHttpHeaders
import io.netty.handler.codec.http.DefaultHttpResponse
import io.netty.handler.codec.http.HttpChunkedInput
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpHeaderValues
import io.netty.handler.codec.http.HttpHeaders
import io.netty.handler.codec.http.HttpResponseStatus
import io.netty.handler.codec.http.HttpVersion
import io.netty.handler.stream.ChunkedStream
import java.util.Date
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/**
 * An answer: its status, its headers, and a text or a picture.
 *
 * @property detail what the log says about it
 */
internal class Answer private constructor(
    val status: HttpResponseStatus,
    val text: String,
    val picture: RenderedPicture?,
    val detail: String,
) {
    val headers: HttpHeaders = DefaultHttpHeaders()
        .set(HttpHeaderNames.DATE, DateFormatter.format(Date()))
        .set("x-content-type-options", "nosniff")

    /** The bytes of the body. */
    val size: Int get() = picture?.size ?: text.toByteArray().size

    /**
     * Writes this answer. The result is there when the last byte is sent.
     *
     * @param isHead whether the client wants the headers only
     * @param isLast whether the connection is closed afterwards
     */
    fun write(context: ChannelHandlerContext, isHead: Boolean, isLast: Boolean): ChannelFuture {
        if (status != HttpResponseStatus.NOT_MODIFIED) headers.set(HttpHeaderNames.CONTENT_LENGTH, size)
        headers.set(HttpHeaderNames.CONNECTION, if (isLast) HttpHeaderValues.CLOSE else HttpHeaderValues.KEEP_ALIVE)
        if (picture != null) {
            context.write(DefaultHttpResponse(HttpVersion.HTTP_1_1, status, headers))
            return context.writeAndFlush(HttpChunkedInput(ChunkedStream(picture.open(), CHUNK)))
        }
        val body = if (isHead) Unpooled.EMPTY_BUFFER else Unpooled.wrappedBuffer(text.toByteArray())
        val response = DefaultFullHttpResponse(HttpVersion.HTTP_1_1, status, body)
        response.headers().set(headers)
        return context.writeAndFlush(response)
    }

    companion object {
        private const val CHUNK = 1 shl 16

        /** Characters of a problem, at most: five warnings, and what it is. */
        private const val LONGEST_PROBLEM = 2000

        /** A page. */
        fun text(text: String, type: String = "text/plain; charset=utf-8"): Answer =
            Answer(HttpResponseStatus.OK, text, null, "").apply {
                headers.set(HttpHeaderNames.CONTENT_TYPE, type)
                headers.set(HttpHeaderNames.CACHE_CONTROL, "no-store")
            }

        /** A picture, or only its name if the client has it, because [known] names it. */
        fun picture(picture: RenderedPicture, known: String?): Answer {
            val tag = "\"${picture.tag}\""
            val isKnown = known != null && known.split(',').any { it.trim().removePrefix("W/") in listOf(tag, "*") }
            val status = if (isKnown) HttpResponseStatus.NOT_MODIFIED else HttpResponseStatus.OK
            val warnings = picture.warningCount
            val detail = if (warnings == 0) "" else "$warnings warnings"
            return Answer(status, "", picture.takeUnless { isKnown }, detail).apply {
                headers.set(HttpHeaderNames.ETAG, tag)
                if (!isKnown) headers.set(HttpHeaderNames.CONTENT_TYPE, picture.type)
                picture.blank?.let { headers.add("lazyz-blank", it.name.lowercase()) }
                if (picture.isCropped) headers.add("lazyz-cropped", "true")
                for (warning in picture.warnings) headers.add("lazyz-warning", ascii(warning))
            }
        }

        /** A problem as JSON (RFC 9457). */
        fun problem(problem: Problem): Answer {
            val status = HttpResponseStatus.valueOf(problem.status)
            val detail = problem.message.take(LONGEST_PROBLEM)
            val json = buildJsonObject {
                put("title", status.reasonPhrase())
                put("status", problem.status)
                put("detail", detail)
            }
            return Answer(status, "$json\n", null, detail).apply {
                headers.set(HttpHeaderNames.CONTENT_TYPE, "application/problem+json")
                problem.retrySeconds?.let { headers.set(HttpHeaderNames.RETRY_AFTER, it) }
                problem.allowed?.let { headers.set(HttpHeaderNames.ALLOW, it) }
            }
        }

        private fun ascii(text: String): String = text.map { if (it in ' '..'~') it else '?' }.joinToString("")
    }
}
