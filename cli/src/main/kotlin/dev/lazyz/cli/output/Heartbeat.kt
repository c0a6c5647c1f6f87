package dev.lazyz.cli.output

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
