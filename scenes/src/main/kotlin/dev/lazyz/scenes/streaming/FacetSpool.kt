package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.writers.TemporaryFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * A temporary file of triangles that were read from text, 36 bytes each, so that they can be read again in parts. Not
 * thread safe while it is written.
 *
 * @param folder where to create the file
 */
internal class FacetSpool(
    folder: Path,
    private val source: Source,
    private val origin: Vector3dc,
    private val space: SpoolSpace,
) : AutoCloseable {
    private val temporary = TemporaryFile.within(folder)
    private val buffer = ByteBuffer.allocate(FacetFile.PART * STRIDE).order(ByteOrder.LITTLE_ENDIAN)
    private val boxes = ArrayList<Box?>()
    private var box = PartBox()
    private var count = 0L
    private var reader: FileBytes? = null

    /** The smallest box around all vertices so far. */
    val bounds: Box? get() = (boxes + box.toBox()).filterNotNull().reduceOrNull(Box::union)

    /** Adds the next corner; three make a triangle. Fails if there are more triangles than [Loading.limits] allow. */
    fun add(x: Float, y: Float, z: Float) {
        buffer.putFloat(x).putFloat(y).putFloat(z)
        box.add(x, y, z)
        if (!buffer.hasRemaining()) flush()
    }

    private fun flush() {
        buffer.flip()
        val triangles = buffer.remaining() / STRIDE
        if (triangles == 0) return
        count += triangles
        source.loading.streamed(source, triangles.toLong())
        if (count > MOST) source.fail(null, "has more than $MOST triangles", "split it")
        space.take(triangles.toLong() * STRIDE)
        while (buffer.hasRemaining()) temporary.channel.write(buffer)
        buffer.clear()
        boxes += box.toBox()
        box = PartBox()
    }

    /** Returns the triangles. No more can be added. */
    fun finish(): FacetFile {
        flush()
        val file = FileBytes(temporary.path, source.name).also { reader = it }
        return FacetFile(file, 0, STRIDE, 0, count.toInt(), origin, boxes, null)
    }

    /** Deletes the file. */
    override fun close() {
        reader?.close()
        temporary.close()
        space.release(count * STRIDE)
    }

    companion object {
        private const val STRIDE = 36

        /** Most triangles of a frame. */
        const val MOST: Int = Int.MAX_VALUE - 1
    }
}
