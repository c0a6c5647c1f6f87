package dev.lazyz.cli.output

/**
 * Shows how much of a long work is done, how fast, and how long the rest will take, on the terminal if there is one.
 * Thread safe.
 *
 * @param total the number of parts
 * @param parts what they are called, such as `rows`
 * @param now a clock, nanoseconds
 */
internal class Progress(
    private val streams: Streams,
    private val total: Int,
    private val parts: String,
    private val now: () -> Long = System::nanoTime,
) {
    private val start = now()
    private var shown = start
    private var done = 0

    /** Counts another part. Shows the state at most every [INTERVAL] nanoseconds. */
    fun advance() {
        synchronized(streams) {
            done++
            val time = now()
            if (!streams.isProgressShown || time - shown < INTERVAL) return
            shown = time
            streams.progress(text(time))
        }
    }

    private fun text(time: Long): String {
        val seconds = (time - start) / 1e9
        val rate = done / seconds
        val left = duration(((total - done) / rate).toLong())
        val speed = (if (rate < 10) "%.1f" else "%,.0f").format(null, rate)
        val share = "%,d of %,d %s (%d %%)".format(null, done, total, parts, 100L * done / total)
        return "$share, $speed $parts/s, $left left"
    }

    private fun duration(seconds: Long): String = when {
        seconds < 60 -> "$seconds s"
        seconds < 3600 -> "${seconds / 60} min ${seconds % 60} s"
        else -> "${seconds / 3600} h ${seconds % 3600 / 60} min"
    }

    private companion object {
        const val INTERVAL = 200_000_000L
    }
}
