package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.writers.TemporaryFile
import java.io.FilterOutputStream
import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * A temporary file of triangles, so that they can be read again in parts: 36 bytes each, and 48 more for the colours of
 * their corners. Not thread safe while it is written.
 *
 * @param space where to create the file, and the room that it may take
 * @param hasColors whether corners have colours
 */
internal class FacetSpool(
    private val space: SpoolSpace,
    private val source: Source,
    private val origin: Vector3dc,
    private val hasColors: Boolean,
) : AutoCloseable {
    private val temporary = TemporaryFile.within(space.folder)
    private val stride = if (hasColors) CORNERS + COLORS else CORNERS
    private val buffer = ByteBuffer.allocate(FacetFile.PART * stride).order(ByteOrder.LITTLE_ENDIAN)
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

    /**
     * Adds the colour of the next corner: red, green, blue and alpha, in linear light. Add the colours of a triangle
     * after its three corners.
     */
    fun color(red: Float, green: Float, blue: Float, alpha: Float) {
        buffer.putFloat(red).putFloat(green).putFloat(blue).putFloat(alpha)
        if (!buffer.hasRemaining()) flush()
    }

    private fun flush() {
        buffer.flip()
        val triangles = buffer.remaining() / stride
        if (triangles == 0) return
        count += triangles
        source.loading.streamed(source, triangles.toLong())
        if (count > MOST) source.fail(null, "has more than $MOST triangles", "split it")
        space.take(triangles.toLong() * stride)
        while (buffer.hasRemaining()) temporary.channel.write(buffer)
        buffer.clear()
        boxes += box.toBox()
        box = PartBox()
    }

    /** Returns the triangles. No more can be added. */
    fun finish(): FacetFile {
        flush()
        val file = FileBytes(temporary.path, source.name).also { reader = it }
        return FacetFile(file, 0, stride, 0, count.toInt(), origin, boxes, if (hasColors) CORNER_COLORS else null)
    }

    /** Deletes the file. */
    override fun close() {
        reader?.close()
        temporary.close()
        space.release(count * stride)
    }

    companion object {
        /** Bytes of the three corners, and of their colours. */
        private const val CORNERS = 36
        private const val COLORS = 48

        /** The colours after the corners. */
        private val CORNER_COLORS = FacetColors { records, stride, count ->
            FloatArray(12 * count) { records.getFloat(it / 12 * stride + CORNERS + it % 12 * Float.SIZE_BYTES) }
        }

        /** Most triangles of a frame. */
        const val MOST: Int = Int.MAX_VALUE - 1
    }
}

/** The smallest box around points that are added one by one. Points that are not finite are ignored. */
internal class PartBox {
    private var minX = Float.POSITIVE_INFINITY
    private var minY = Float.POSITIVE_INFINITY
    private var minZ = Float.POSITIVE_INFINITY
    private var maxX = Float.NEGATIVE_INFINITY
    private var maxY = Float.NEGATIVE_INFINITY
    private var maxZ = Float.NEGATIVE_INFINITY

    fun add(x: Float, y: Float, z: Float) {
        // The sum is finite only if all are; it cannot overflow to a wrong answer in double precision
        if (!(x.toDouble() + y + z).isFinite()) return
        minX = minOf(minX, x)
        minY = minOf(minY, y)
        minZ = minOf(minZ, z)
        maxX = maxOf(maxX, x)
        maxY = maxOf(maxY, y)
        maxZ = maxOf(maxZ, z)
    }

    /** Returns the box, or null if there was no point. */
    fun toBox(): Box? = if (minX > maxX) {
        null
    } else {
        Box(minX.toDouble(), minY.toDouble(), minZ.toDouble(), maxX.toDouble(), maxY.toDouble(), maxZ.toDouble())
    }
}

/**
 * The room that temporary files may take in [folder]: at most [most] bytes together, and never the last
 * [kept] bytes of the disk. Not thread safe.
 *
 * @property folder where temporary files are created
 * @param name name of the model in messages
 * @param most most bytes, or null
 * @param instead what else to do if that is too few
 * @param kept space of the disk that is left to others, bytes
 */
internal class SpoolSpace(
    val folder: Path,
    private val name: String,
    private val most: Long?,
    private val instead: String = ", or use a binary STL file, which needs none",
    private val kept: Long = 64L shl 20,
) {
    private var taken = 0L
    private var checked = 0L

    /**
     * Records that [bytes] are about to be written.
     *
     * @throws SceneFormatException if they are too many; a [SceneReadException] if the disk has no room for them
     */
    fun take(bytes: Long) {
        taken += bytes
        if (most != null && taken > most) {
            throw SceneFormatException(
                name, null, "needs temporary files of more than $most bytes",
                "raise LoadLimits.spoolBytes (zcli: --max-spool)$instead",
            )
        }
        if (taken < checked) return
        val free = Files.getFileStore(folder).usableSpace
        if (free < kept + STEP_BYTES) {
            throw SceneReadException(
                name, "needs temporary files, and only $free bytes are free in $folder",
                "free some space, or choose another folder (zcli: --spool)",
            )
        }
        checked = taken + STEP_BYTES
    }

    /** Gives the room back, after the files were deleted. */
    fun release(bytes: Long) {
        taken -= bytes
    }

    /** Returns a stream that takes the room for what is written to [output]. */
    fun counting(output: OutputStream): OutputStream = object : FilterOutputStream(output) {
        override fun write(byte: Int) {
            take(1)
            out.write(byte)
        }

        override fun write(bytes: ByteArray, offset: Int, length: Int) {
            take(length.toLong())
            out.write(bytes, offset, length)
        }
    }

    companion object {
        /** Bytes that are written before the free space is looked at again. */
        private const val STEP_BYTES = 16L shl 20
    }
}
