package dev.lazyz.scenes.text

import dev.lazyz.scenes.loading.Source
import java.io.IOException
import java.io.InputStream

/**
 * The part of a file that is in memory while the file is read from its beginning to its end. Not thread safe.
 *
 * @property source the file, whose steps of work are counted
 * @param bytes the file, or its beginning
 * @param rest the rest of the file, or null if [bytes] is all of it
 * @param passed number of bytes of the file before [bytes]
 */
internal class ByteWindow(
    val source: Source,
    bytes: ByteArray = source.bytes,
    private val rest: InputStream? = null,
    passed: Long = 0,
) {
    /** The rest of a file of which nothing is in memory yet. The [rest] begins after [passed] bytes. */
    constructor(source: Source, rest: InputStream, passed: Long = 0) : this(source, ByteArray(0), rest, passed)

    /** The bytes in memory. Indices refer to it. It changes in [readMore]. */
    var bytes: ByteArray = bytes
        private set

    /** Number of [bytes] that are of the file. */
    var size: Int = bytes.size
        private set

    /** Whether the file ends at [size]. */
    var isAtEnd: Boolean = rest == null
        private set

    /** Number of bytes of the file before index 0. */
    var passed: Long = passed
        private set

    /** Whether only a part of the file is in memory. */
    val isPart: Boolean get() = rest != null

    /**
     * Moves the bytes from index [from] on to the front, and reads what follows them, until there are [least] bytes or
     * the file ends. Call it only if the file does not end at [size].
     *
     * @throws IOException if the file cannot be read
     */
    fun readMore(from: Int, least: Int = 0) {
        val kept = size - from
        val old = bytes
        val isFull = kept >= old.size / 2
        if (isFull || old.size < least) bytes = ByteArray(maxOf(PIECE, least, if (isFull) 2 * old.size else 0))
        System.arraycopy(old, from, bytes, 0, kept)
        passed += from
        source.loading.look(source.name)
        val count = checkNotNull(rest).readNBytes(bytes, kept, bytes.size - kept)
        size = kept + count
        isAtEnd = size < bytes.size
    }

    private companion object {
        /** Bytes that are in memory at a time, unless more are needed. */
        const val PIECE = 1 shl 20
    }
}
