package dev.lazyz.cli.output

/**
 * Shows how much of a long work is done and, as soon as enough is known, how fast, and how long the rest will take.
 * Thread safe.
 *
 * The speed counts from the end of the first part, because that one includes the time of what all parts share. Nothing
 * is said about it until [ENOUGH_SECONDS] have passed since then, and [ENOUGH_PERCENT] of the parts or
 * [LONG_SECONDS]: the first parts are often not like the others.
 *
 * @param total the number of parts
 * @param parts what they are called, such as `rows`
 * @param work what they are parts of, if that has to be said
 */
internal class Progress(
    private val streams: Streams,
    private val total: Int,
    private val parts: String,
    private val work: String? = null,
) {
    private var shown = streams.now()
    private var first = shown
    private var done = 0

    /** Counts another part. Shows the state at most every [INTERVAL] nanoseconds. */
    fun advance() {
        synchronized(streams) {
            val time = streams.now()
            if (done++ == 0) first = time
            if (time - shown < INTERVAL) return
            shown = time
            streams.progress(text((time - first) / NANOSECONDS))
        }
    }

    /** Returns the state, [seconds] after the first part. */
    private fun text(seconds: Double): String {
        val lead = if (work == null) "" else "$work: "
        val share = "$lead%,d of %,d %s (%d %%)".format(null, done, total, parts, PERCENT * done / total)
        val later = done - 1
        val isEnough = PERCENT * later >= ENOUGH_PERCENT * total || seconds >= LONG_SECONDS
        if (later == 0 || seconds < ENOUGH_SECONDS || !isEnough) return share
        val rate = later / seconds
        val speed = (if (rate < 10) "%.1f" else "%,.0f").format(null, rate)
        val left = if (done == total) "" else ", ${duration(((total - done) / rate).toLong())} left"
        return "$share, $speed $parts/s$left"
    }

    companion object {
        private const val INTERVAL = 200_000_000L
        private const val NANOSECONDS = 1e9
        private const val PERCENT = 100L
        private const val ENOUGH_SECONDS = 2
        private const val ENOUGH_PERCENT = 2
        private const val LONG_SECONDS = 30

        /** Returns a time in words. */
        fun duration(seconds: Long): String = when {
            seconds < 60 -> "$seconds s"
            seconds < 3600 -> "${seconds / 60} min ${seconds % 60} s"
            else -> "${seconds / 3600} h ${seconds % 3600 / 60} min"
        }
    }
}

/**
 * Prints what is done at the moment, a line every [PERIOD] seconds, if no terminal shows it: so that a log tells a long
 * work from one that hangs. Ends with the process.
 *
 * @param pause waits for so many seconds
 */
internal class Heartbeat(
    private val streams: Streams,
    private val pause: (Long) -> Unit = { Thread.sleep(it * MILLISECONDS) },
) : Thread("zcli-heartbeat") {
    init {
        isDaemon = true
    }

    override fun run() {
        while (true) {
            pause(PERIOD)
            streams.beat()
        }
    }

    private companion object {
        const val PERIOD = 10L
        const val MILLISECONDS = 1000
    }
}
