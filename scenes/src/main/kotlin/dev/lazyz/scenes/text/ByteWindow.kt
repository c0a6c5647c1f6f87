package dev.lazyz.scenes.text

import java.io.IOException
import java.io.InputStream

/**
 * The bytes of a file from a position on, either all of them or as many as are looked at. Not thread safe.
 *
 * @param bytes the file, or nothing if [rest] has it
 * @property position index in [bytes] of the next byte
 * @param rest what follows [bytes], or null if nothing does. Then [bytes] holds only a part of the file, and changes
 *   with each call of [more]
 * @param dropped number of bytes of the file that stand before [bytes]
 */
internal class ByteWindow(
    bytes: ByteArray,
    var position: Int = 0,
    private val rest: InputStream? = null,
    private var dropped: Long = 0,
) {
    /** The bytes around [position]. */
    var bytes: ByteArray = bytes
        private set

    /** Number of [bytes] that belong to the file. */
    var size: Int = bytes.size
        private set

    /** Whether the file ends at [size]. */
    var isAtEnd: Boolean = rest == null
        private set

    /** The position in the file of the next byte. */
    val offset: Long get() = dropped + position

    /**
     * Moves the bytes from [position] on to the front of [bytes], and reads what follows them.
     *
     * @throws IOException if the rest cannot be read, or 256 MiB were not enough
     */
    fun more() {
        val kept = size - position
        if (kept > LONGEST) throw IOException("what begins at byte $offset is longer than $LONGEST bytes")
        val from = bytes
        if (kept >= bytes.size / 2) bytes = ByteArray(maxOf(PIECE, 2 * bytes.size))
        System.arraycopy(from, position, bytes, 0, kept)
        dropped += position
        position = 0
        val count = checkNotNull(rest).readNBytes(bytes, kept, bytes.size - kept)
        size = kept + count
        isAtEnd = size < bytes.size
    }

    /** Whether the file has [count] more bytes. If so, they are in [bytes]. Throws like [more]. */
    fun has(count: Long): Boolean {
        while (size - position < count) {
            if (isAtEnd) return false
            more()
        }
        return true
    }

    /** Moves to the end of the file. */
    fun end() {
        position = size
        isAtEnd = true
    }

    companion object {
        /** Bytes that are in memory at a time, unless a line or a list is longer. */
        private const val PIECE = 1 shl 20

        /** The longest line or list of a file that is not in memory. */
        const val LONGEST: Int = 1 shl 28
    }
}
