package dev.lazyz.server.render

import java.util.concurrent.atomic.AtomicLong

/**
 * The bytes of a model as they arrive. Takes their memory from [budget] as they arrive, so that a client that announces
 * much and sends little holds little. Not thread safe.
 *
 * @param announced the number of bytes that the client has announced, or null
 * @param most the maximum number of bytes
 */
internal class Upload(private val announced: Long?, private val most: Long, private val budget: MemoryBudget) {
    /** The bytes in parts: an event loop has no time to copy a large array whenever it must grow. */
    private val parts = ArrayList<ByteArray>()
    private var room = 0

    /** The number of bytes so far. */
    var size = 0
        private set

    init {
        if (announced != null && announced > most) throw tooLarge()
    }

    /**
     * Makes room for [count] more bytes, and lets [read] fill it: it gets an array, the place, and the number of bytes.
     *
     * @throws Problem if the model becomes too large, or the memory is in use
     */
    fun add(count: Int, read: (ByteArray, Int, Int) -> Unit) {
        if (size.toLong() + count > most) throw tooLarge()
        var left = count
        while (left > 0) {
            if (size == room) grow()
            val last = parts.last()
            val at = last.size - (room - size)
            val now = minOf(left, last.size - at)
            read(last, at, now)
            size += now
            left -= now
        }
    }

    /** The first bytes: all, or enough to recognize a format. */
    fun start(): ByteArray = parts.firstOrNull()?.let { it.copyOf(minOf(it.size, size)) } ?: ByteArray(0)

    /** Returns a new array with all bytes. */
    fun joined(): ByteArray {
        val bytes = ByteArray(size)
        var at = 0
        for (part in parts) {
            part.copyInto(bytes, at, 0, minOf(part.size, size - at))
            at += part.size
        }
        return bytes
    }

    /** Gives the memory back. Calling it again does nothing. */
    fun release() {
        budget.giveBack(room.toLong())
        parts.clear()
        room = 0
    }

    private fun grow() {
        val rest = (announced ?: most) - room
        val length = minOf(room.coerceIn(LEAST, LARGEST).toLong(), maxOf(rest, 1)).toInt()
        if (!budget.tryTake(length.toLong())) throw inUse()
        room += length
        try {
            parts.add(ByteArray(length))
        } catch (_: OutOfMemoryError) {
            room -= length
            budget.giveBack(length.toLong())
            throw inUse()
        }
    }

    private fun inUse() = Problem(
        Problem.UNAVAILABLE,
        "the memory for uploads is in use by other requests; try again later",
        Problem.SOON,
    )

    private fun tooLarge() = Problem(Problem.TOO_LARGE, "a model has at most $most bytes")

    private companion object {
        /** Bytes of the first part; more than a look at the format needs. */
        const val LEAST = 1 shl 14

        /** Bytes of a part, at most. */
        const val LARGEST = 1 shl 20
    }
}

/** An amount of memory that is given out in parts. Thread safe. */
internal class MemoryBudget(val total: Long) {
    private val taken = AtomicLong()

    /** The bytes that are given out. */
    val used: Long get() = taken.get()

    /** Takes [bytes], or returns false if there are fewer. */
    fun tryTake(bytes: Long): Boolean {
        while (true) {
            val now = taken.get()
            if (bytes > total - now) return false
            if (taken.compareAndSet(now, now + bytes)) return true
        }
    }

    /** Gives back [bytes]. */
    fun giveBack(bytes: Long) {
        check(taken.addAndGet(-bytes) >= 0) { "more was given back than was taken" }
    }
}
