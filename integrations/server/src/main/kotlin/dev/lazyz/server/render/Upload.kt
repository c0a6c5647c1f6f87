package dev.lazyz.server.render

/**
 * The bytes of a model as they arrive. Takes their memory from [budget] as they arrive, so that a client that announces
 * much and sends little holds little. Not thread safe.
 *
 * @param announced the number of bytes that the client has announced, or null
 * @param most the maximum number of bytes
 */
internal class Upload(private val announced: Long?, private val most: Long, private val budget: MemoryBudget) {
    private var bytes = ByteArray(0)

    /** The number of bytes so far. */
    var size = 0
        private set

    init {
        if (announced != null && announced > most) throw tooLarge()
    }

    /**
     * Makes room for [count] more bytes, and passes the array and the place to [read].
     *
     * @throws Problem if the model becomes too large, or the memory is in use
     */
    fun add(count: Int, read: (ByteArray, Int) -> Unit) {
        if (size.toLong() + count > most) throw tooLarge()
        if (size + count > bytes.size) {
            val room = maxOf(2L * bytes.size, LEAST.toLong()).coerceAtMost(announced ?: most)
            resize(maxOf(room, size.toLong() + count).toInt())
        }
        read(bytes, size)
        size += count
    }

    /** Returns all bytes, in an array of their number. */
    fun complete(): ByteArray {
        if (bytes.size != size) resize(size)
        return bytes
    }

    /** Gives the memory back. Calling it again does nothing. */
    fun release() {
        budget.giveBack(bytes.size.toLong())
        bytes = ByteArray(0)
    }

    /** While the bytes are copied, both arrays count. */
    private fun resize(length: Int) {
        if (!budget.tryTake(length.toLong())) {
            throw Problem(
                Problem.UNAVAILABLE,
                "the memory for uploads is in use by other requests; try again later",
                Problem.SOON,
            )
        }
        val old = bytes.size.toLong()
        bytes = bytes.copyOf(length)
        budget.giveBack(old)
    }

    private fun tooLarge() = Problem(Problem.TOO_LARGE, "a model has at most $most bytes")

    private companion object {
        const val LEAST = 1 shl 14
    }
}
