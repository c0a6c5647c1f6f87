package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import java.io.EOFException
import java.io.IOException
import java.io.InputStream
import java.io.RandomAccessFile
import java.io.UncheckedIOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * Triangles in a file of equally long records, each with three corners of three 32-bit numbers. The parts have
 * [PART] triangles, the last one what remains. Memory: a box for each part.
 *
 * @param start position of the first record
 * @param stride bytes of a record
 * @param corners position of the first corner in a record
 * @param boxes the boxes of the parts
 * @param colors the colours of the triangles, or null if they have none
 */
internal class FacetFile(
    private val file: FileBytes,
    private val start: Long,
    private val stride: Int,
    private val corners: Int,
    override val triangleCount: Int,
    override val origin: Vector3dc,
    private val boxes: List<Box?>,
    private val colors: FacetColors?,
) : MeshSource {
    override val hasColors: Boolean get() = colors != null

    override val partCount: Int get() = boxes.size

    override fun triangleCount(number: Int): Int = minOf(PART, triangleCount - number * PART)

    override fun bounds(number: Int): Box? = boxes[number]

    override fun read(first: Int, count: Int): Mesh {
        val facets = minOf(count * PART, triangleCount - first * PART)
        val records = try {
            file.read(start + first.toLong() * PART * stride, facets * stride)
        } catch (e: SceneReadException) {
            throw UncheckedIOException(e.message, e)
        }
        val positions = FloatArray(9 * facets)
        for (facet in 0 until facets) {
            val at = facet * stride + corners

            // Adding 0 turns -0 into 0, as in meshes whose vertices are merged
            for (i in 0 until 9) positions[9 * facet + i] = records.getFloat(at + 4 * i) + 0f
        }
        val numbers = IntArray(3 * facets) { it }
        return Mesh(positions, numbers, colors = colors?.of(records, stride, facets), origin = origin)
    }

    companion object {
        /** Triangles of a part. */
        const val PART: Int = 1 shl 10
    }
}

/** Finds the colours of triangles in their records. Thread safe. */
internal fun interface FacetColors {
    /** Returns red, green, blue and alpha, in linear light, of each corner of the first [count] of [records]. */
    fun of(records: ByteBuffer, stride: Int, count: Int): FloatArray
}

/**
 * Reads parts of a file, in any order. Thread safe. Unlike a channel, it stays open when a thread that reads is
 * interrupted.
 */
internal class FileBytes(path: Path, private val name: String) : AutoCloseable {
    private val file = RandomAccessFile(path.toFile(), "r")

    /** Number of bytes when the file was opened. */
    val size: Long = file.length()

    /**
     * Returns [count] bytes from [position] on, little endian.
     *
     * @throws SceneReadException if the file cannot be read, or has become shorter
     */
    fun read(position: Long, count: Int): ByteBuffer {
        val bytes = ByteArray(count)
        try {
            synchronized(file) {
                file.seek(position)
                file.readFully(bytes)
            }
        } catch (e: EOFException) {
            throw SceneReadException(name, "has become shorter while it was read", "render it again", e)
        } catch (e: IOException) {
            throw SceneReadException(name, "cannot be read: ${e.message ?: e}", cause = e)
        }
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
    }

    /** Returns the bytes from [position] on. The stream can be used until the file is closed. */
    fun stream(position: Long): InputStream = object : InputStream() {
        private var next = position

        override fun read(): Int {
            val byte = ByteArray(1)
            return if (read(byte, 0, 1) < 0) -1 else byte[0].toInt() and 0xFF
        }

        override fun read(bytes: ByteArray, offset: Int, length: Int): Int {
            val count = synchronized(file) {
                file.seek(next)
                file.read(bytes, offset, length)
            }
            if (count > 0) next += count
            return count
        }
    }

    override fun close() = file.close()
}
