package dev.lazyz.server

import dev.lazyz.server.render.Picture
import dev.lazyz.server.render.Problem
import io.netty.handler.codec.DateFormatter
import io.netty.handler.codec.http.DefaultHttpHeaders
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpHeaders
import io.netty.handler.codec.http.HttpResponseStatus
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
    val picture: Picture?,
    val detail: String,
) {
    val headers: HttpHeaders = DefaultHttpHeaders()
        .set(HttpHeaderNames.DATE, DateFormatter.format(Date()))
        .set("x-content-type-options", "nosniff")

    companion object {
        private const val MOST_WARNINGS = 5
        private const val LONGEST_WARNING = 300

        /** A page. */
        fun text(text: String, type: String = "text/plain; charset=utf-8", status: Int = 200): Answer =
            Answer(HttpResponseStatus.valueOf(status), text, null, "").apply {
                headers.set(HttpHeaderNames.CONTENT_TYPE, type)
                headers.set(HttpHeaderNames.CACHE_CONTROL, "no-store")
            }

        /** A picture, or only its name if the client has it, because [known] names it. */
        fun picture(picture: Picture, known: String?): Answer {
            val tag = "\"${picture.tag}\""
            val isKnown = known != null && known.split(',').any { it.trim().removePrefix("W/") in listOf(tag, "*") }
            val status = if (isKnown) HttpResponseStatus.NOT_MODIFIED else HttpResponseStatus.OK
            val warnings = picture.warnings.size
            val detail = if (warnings == 0) "" else "$warnings warnings"
            return Answer(status, "", picture.takeUnless { isKnown }, detail).apply {
                headers.set(HttpHeaderNames.ETAG, tag)
                if (!isKnown) headers.set(HttpHeaderNames.CONTENT_TYPE, "image/png")
                for (warning in picture.warnings.take(MOST_WARNINGS)) {
                    headers.add("lazyz-warning", ascii(warning).take(LONGEST_WARNING))
                }
            }
        }

        /** A problem as JSON (RFC 9457). */
        fun problem(problem: Problem): Answer {
            val status = HttpResponseStatus.valueOf(problem.status)
            val json = buildJsonObject {
                put("title", status.reasonPhrase())
                put("status", problem.status)
                put("detail", problem.message)
            }
            return Answer(status, "$json\n", null, problem.message).apply {
                headers.set(HttpHeaderNames.CONTENT_TYPE, "application/problem+json")
                problem.retrySeconds?.let { headers.set(HttpHeaderNames.RETRY_AFTER, it) }
            }
        }

        private fun ascii(text: String): String = text.map { if (it in ' '..'~') it else '?' }.joinToString("")
    }
}
