package dev.lazyz.scenes.loading

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneMemoryException
import dev.lazyz.scenes.SceneReadException
import java.io.IOException
import java.io.InputStream
import java.nio.channels.ClosedByInterruptException
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.Path

/** The bytes of a whole file or stream. */
internal object FileBytes {
    /** Maximum number of bytes per read call. */
    private const val PIECE = 1 shl 20

    /** Returns the bytes of the file [path], which is called [name] in messages. */
    fun of(path: Path, name: String, format: SceneFormat?, loading: Loading): ByteArray {
        requireFile(path, name)
        return readable(name) {
            val size = Files.size(path)
            requireFits(size, name, format, loading.limits)
            Files.newInputStream(path).use { bytes(it, size.toInt(), name, format, loading) }
        }
    }

    /** Returns all bytes of [input], which is called [name] in messages. */
    fun of(input: InputStream, name: String, format: SceneFormat?, loading: Loading): ByteArray =
        readable(name) { bytes(input, 0, name, format, loading) }

    /** Returns what [read] returns. Whatever else stops it becomes an exception that names the file or stream. */
    inline fun <T> readable(name: String, read: () -> T): T = try {
        read()
    } catch (e: SceneFormatException) {
        throw e
    } catch (e: IOException) {
        throw unreadable(name, e)
    }

    /** Fails unless [path] is a regular file. */
    fun requireFile(path: Path, name: String) {
        if (!Files.exists(path)) throw SceneReadException(name, "there is no such file", "check the name")
        if (Files.isDirectory(path)) throw SceneReadException(name, "is a folder", "name a file in it")
        if (!Files.isRegularFile(path)) {
            throw SceneReadException(name, "is a pipe or a device, not a file", "send its bytes as a stream")
        }
    }

    /** Returns the exception for a file that cannot be read. An interrupt closes channels. */
    private fun unreadable(name: String, e: IOException): SceneReadException = when (e) {
        is ClosedByInterruptException -> SceneReadException(name, Loading.INTERRUPTED, cause = e)
        is AccessDeniedException ->
            SceneReadException(name, "cannot be read: permission denied", "ask for permission", e)
        else -> SceneReadException(name, "cannot be read: ${e.message ?: e}", cause = e)
    }

    /**
     * Reads all of [input]: first the [expected] bytes, directly into their array, then any further bytes of the
     * stream.
     */
    private fun bytes(
        input: InputStream,
        expected: Int,
        name: String,
        format: SceneFormat?,
        loading: Loading,
    ): ByteArray {
        val bytes = ByteArray(expected)
        val first = fill(bytes, input, name, loading)
        if (first < expected) return bytes.copyOf(first)

        // Further bytes, if there are any
        val pieces = ArrayList<ByteArray>()
        var size = expected.toLong()
        do {
            val piece = ByteArray(PIECE)
            val count = fill(piece, input, name, loading)
            size += count
            requireFits(size, name, format, loading.limits)
            if (count > 0) pieces.add(if (count < PIECE) piece.copyOf(count) else piece)
        } while (count == PIECE)
        if (pieces.isEmpty()) return bytes
        val all = bytes.copyOf(size.toInt())
        for ((i, piece) in pieces.withIndex()) piece.copyInto(all, expected + i * PIECE)
        return all
    }

    /** Reads bytes until [into] is full or [input] ends, and returns their number. */
    private fun fill(into: ByteArray, input: InputStream, name: String, loading: Loading): Int {
        var count = 0
        while (count < into.size) {
            loading.look(name)
            val read = input.read(into, count, minOf(PIECE, into.size - count))
            if (read < 0) break
            count += read
        }
        return count
    }

    /** Fails if a file of [size] bytes is too large: it must fit into an array, and what is in it into the heap. */
    fun requireFits(size: Long, name: String, format: SceneFormat?, limits: LoadLimits) {
        val most = minOf(Int.MAX_VALUE - 16L, limits.usableMemory / SceneFormat.memoryPerByte(format))
        if (size <= most) return
        throw SceneMemoryException(name, "is too large: $size bytes, at most $most fit", "raise -Xmx, or split it")
    }
}
