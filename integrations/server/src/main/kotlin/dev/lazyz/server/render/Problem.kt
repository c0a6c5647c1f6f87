package dev.lazyz.server.render

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
