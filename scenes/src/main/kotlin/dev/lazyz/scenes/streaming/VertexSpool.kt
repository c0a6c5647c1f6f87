package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.scenes.meshes.VertexPositions
import dev.lazyz.scenes.writers.TemporaryFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.MappedByteBuffer
import java.nio.channels.FileChannel
import org.joml.Vector3dc

/**
 * Temporary files of the positions and colours of vertices, so that faces can refer to them. Not thread safe.
 *
 * @param space where to create the files, and the room that they may take
 * @property origin what positions are relative to
 */
internal class VertexSpool(private val space: SpoolSpace, private val source: Source, val origin: Vector3dc) :
    VertexPositions,
    AutoCloseable {
    private val positions = FloatSpool(space, 3)
    private var colors: FloatSpool? = null
    private val box = PartBox()
    private var counted = 0

    /** The smallest box around all vertices so far. */
    val bounds: Box? get() = box.toBox()

    /** Number of vertices so far. */
    val size: Int get() = positions.size

    /** Whether a vertex has a colour. */
    val hasColors: Boolean get() = colors != null

    /** Adds the first [count] vertices of [block]. */
    fun add(block: VertexArrays, count: Int) {
        for (vertex in 0 until count) {
            val at = 3 * vertex
            add(block.positions[at], block.positions[at + 1], block.positions[at + 2])
            val from = block.colors ?: continue
            color(from[4 * vertex], from[4 * vertex + 1], from[4 * vertex + 2], from[4 * vertex + 3])
        }
    }

    /** Adds a vertex. Fails if there are more vertices than the limits allow. */
    fun add(x: Float, y: Float, z: Float) {
        positions.add(x)
        positions.add(y)
        positions.add(z)
        box.add(x, y, z)
        if (size - counted == COUNTED) count()
    }

    private fun count() {
        source.loading.streamedVertices(source, (size - counted).toLong())
        counted = size
    }

    /** Sets the colour of the vertex that was added last. Vertices without one are white. */
    fun color(red: Float, green: Float, blue: Float, alpha: Float) {
        val to = colors ?: FloatSpool(space, 4).also { colors = it }
        to.fill(size - 1)
        to.add(red)
        to.add(green)
        to.add(blue)
        to.add(alpha)
    }

    private fun FloatSpool.fill(count: Int) {
        while (this.size < count) repeat(4) { add(1f) }
    }

    /** Ends writing: from now on, vertices can be read. */
    fun finish() {
        count()
        positions.finish()
        colors?.fill(size)
        colors?.finish()
    }

    override fun get(vertex: Int, axis: Int): Float = positions.get(vertex, axis)

    /** Adds the three corners of a triangle to [facets], and the colours of its vertices if they have any. */
    fun addTo(facets: FacetSpool, a: Int, b: Int, c: Int) {
        corner(facets, a)
        corner(facets, b)
        corner(facets, c)
        val colors = colors ?: return
        color(facets, colors, a)
        color(facets, colors, b)
        color(facets, colors, c)
    }

    private fun corner(facets: FacetSpool, vertex: Int) =
        facets.add(positions.get(vertex, 0), positions.get(vertex, 1), positions.get(vertex, 2))

    private fun color(facets: FacetSpool, colors: FloatSpool, vertex: Int) =
        facets.color(colors.get(vertex, 0), colors.get(vertex, 1), colors.get(vertex, 2), colors.get(vertex, 3))

    /** Deletes the files. */
    override fun close() {
        colors?.close()
        positions.close()
    }

    private companion object {
        /** Vertices after which the limits are checked. */
        const val COUNTED = 1 shl 14
    }
}

/**
 * A temporary file of records of [width] numbers, which are read in any order after all have been written. The file is
 * mapped into memory in pieces: the operating system keeps what fits, and none of it is in the heap. Not thread safe.
 *
 * @param space where to create the file, and the room that it may take
 * @param width numbers of a record, 1..4
 * @param pieceBits logarithm of the records of a mapping, 2^30 bytes at most
 */
internal class FloatSpool(private val space: SpoolSpace, private val width: Int, private val pieceBits: Int = 26) :
    AutoCloseable {
    private val temporary = TemporaryFile.within(space.folder)
    private val buffer = ByteBuffer.allocate(BLOCK * width * Float.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN)
    private val mask = (1 shl pieceBits) - 1
    private var written = 0L
    private var pieces: Array<MappedByteBuffer> = emptyArray()

    /** Number of records. */
    val size: Int get() = ((written + buffer.position()) / (width * Float.SIZE_BYTES)).toInt()

    /** Adds the next number. */
    fun add(number: Float) {
        buffer.putFloat(number)
        if (!buffer.hasRemaining()) flush()
    }

    private fun flush() {
        buffer.flip()
        space.take(buffer.remaining().toLong())
        written += buffer.remaining()
        while (buffer.hasRemaining()) temporary.channel.write(buffer)
        buffer.clear()
    }

    /** Ends writing: from now on [get] works. */
    fun finish() {
        flush()
        val piece = (1L shl pieceBits) * width * Float.SIZE_BYTES
        pieces = Array(((written + piece - 1) / piece).toInt()) { number ->
            val start = number * piece
            temporary.channel.map(FileChannel.MapMode.READ_ONLY, start, minOf(piece, written - start)).also {
                it.order(ByteOrder.LITTLE_ENDIAN)
            }
        }
    }

    /** Returns number [place] of [record]. */
    fun get(record: Int, place: Int): Float =
        pieces[record ushr pieceBits].getFloat(((record and mask) * width + place) * Float.SIZE_BYTES)

    /**
     * Deletes the file. Its space on the disk becomes free when the garbage collector has found that it is unused. Some
     * systems delete no file that is mapped; then it is deleted when the process exits, or by the next one.
     */
    override fun close() {
        pieces = emptyArray()
        temporary.close()
        space.release(written)
    }

    private companion object {
        /** Records that are written at a time. */
        const val BLOCK = 1 shl 14
    }
}
