package dev.lazyz.server.render

import dev.lazyz.scenes.SceneFormatException

/**
 * The end of a request that gets no picture.
 *
 * @property status the HTTP status
 * @property message what is wrong, and what to do about it
 * @property retrySeconds when to try again, or null if that is no use
 * @property allowed the methods that are possible, if the one of the request is not
 */
internal class Problem(
    val status: Int,
    override val message: String,
    val retrySeconds: Int? = null,
    val allowed: String? = null,
) : RuntimeException(message, null, false, false) {
    companion object {
        const val BAD_REQUEST = 400
        const val NOT_FOUND = 404
        const val METHOD_NOT_ALLOWED = 405
        const val TIMEOUT = 408
        const val TOO_LARGE = 413
        const val TARGET_TOO_LONG = 414
        const val UNSUPPORTED = 415
        const val EXPECTATION_FAILED = 417
        const val UNPROCESSABLE = 422
        const val TOO_MANY = 429
        const val HEADERS_TOO_LONG = 431

        /** As of nginx, for the log: the client has closed the connection, and gets no answer. */
        const val GONE = 499
        const val BUG = 500
        const val NOT_IMPLEMENTED = 501
        const val UNAVAILABLE = 503
        const val VERSION_UNSUPPORTED = 505

        /** The time after which a place is probably free. */
        const val SOON = 2
    }
}

/** Messages of the library in a form for clients: without advice for those who run the server, and not too long. */
internal object ClientText {
    /** Characters of a warning, at most. */
    const val LONGEST: Int = 300

    private const val GAP = " ... "

    /** What the advice for operators and programmers has in it: settings and programs that a client does not have. */
    private val foreign = listOf("LoadLimits", "LoadOptions", "-Xmx", "zcli")

    /** Returns [text] without clauses that are for others, and with a gap in the middle if it is too long. */
    fun of(text: String): String {
        val clauses = text.split("; ")
        val own = clauses.filterNot { clause -> foreign.any { it in clause } }
        return shortened((own.ifEmpty { clauses.take(1) }).joinToString("; "))
    }

    /** Returns the message of [invalid]. Where it exceeds a limit, the client learns that the server has it. */
    fun of(invalid: SceneFormatException): String {
        val text = of(invalid.message.orEmpty())
        val isLimit = foreign.any { it in invalid.remedy.orEmpty() }
        return if (isLimit) "$text; that is a limit of this server: send a simpler model" else text
    }

    private fun shortened(text: String): String {
        if (text.length <= LONGEST) return text
        val end = LONGEST / 3
        return text.take(LONGEST - end - GAP.length) + GAP + text.takeLast(end)
    }
}
