package dev.lazyz.server

import java.time.Instant
import java.time.temporal.ChronoUnit

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
