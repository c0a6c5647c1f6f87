package dev.lazyz.spark.pictures

import dev.lazyz.Counters
import dev.lazyz.Region
import dev.lazyz.RowSink
import java.io.ByteArrayOutputStream
import java.io.DataInputStream
import java.io.DataOutputStream
import java.io.EOFException
import java.io.IOException
import java.io.Serializable
import java.nio.ByteBuffer
import org.apache.spark.SparkEnv
import org.apache.spark.io.CompressionCodec
import org.apache.spark.io.LZ4CompressionCodec

/**
 * Rows of a rectangle of a picture, compressed, on their way between tasks. Immutable.
 *
 * @property work the counters
 * @param planes numbers for each pixel: 1 for colours; 3 for colours, depths and primitives, row by row
 */
internal class PixelBlock private constructor(
    private val columnStart: Int,
    val rowStart: Int,
    private val columnEnd: Int,
    val rowEnd: Int,
    private val planes: Int,
    private val bytes: ByteArray,
    val work: LongArray,
) : Serializable {
    val region: Region get() = Region(columnStart, rowStart, columnEnd, rowEnd)

    /** Bytes of the compressed rows. */
    val size: Int get() = bytes.size

    /** The work of rendering these rows. */
    val counters: Counters get() = counters(work)

    /** Passes each row to [take]: its number, and its planes one after the other. The array is used again. */
    fun forEachRow(take: (y: Int, row: IntArray) -> Unit) {
        val reader = reader()
        for (y in rowStart until rowEnd) take(y, reader.next())
    }

    /** Passes all rows to [sink], in arrays that are used again. Depths and primitives are 0 if it has only colours. */
    fun sendTo(sink: RowSink) {
        val width = columnEnd - columnStart
        val (argb, depth, primitive) = List(3) { IntArray(width) }
        forEachRow { y, row ->
            row.copyInto(argb, 0, 0, width)
            if (planes > 1) {
                row.copyInto(depth, 0, width, 2 * width)
                row.copyInto(primitive, 0, 2 * width, 3 * width)
            }
            sink.row(y, argb, depth, primitive)
        }
    }

    /** Returns a reader of the rows from the top. */
    fun reader(): Reader = Reader(DataInputStream(codec().compressedInputStream(bytes.inputStream())))

    /** Reads rows one by one. Not thread safe. */
    inner class Reader(private val input: DataInputStream) {
        private val row = IntArray(planes * (columnEnd - columnStart))
        private val buffer = ByteBuffer.allocate(Int.SIZE_BYTES * row.size)

        /** Returns the next row: its planes one after the other. The array is used again. */
        fun next(): IntArray {
            input.readFully(buffer.array())
            buffer.asIntBuffer().get(row)
            return row
        }
    }

    /** Writes what [read] reads. */
    fun write(output: DataOutputStream) {
        for (number in work) output.writeLong(number)
        output.writeInt(bytes.size)
        output.write(bytes)
    }

    override fun toString(): String = "PixelBlock($region, $size bytes)"

    /** Collects rows. Not thread safe. */
    class Builder(private val region: Region, private val planes: Int) {
        private val bytes = ByteArrayOutputStream()
        private val output = DataOutputStream(codec().compressedOutputStream(bytes))
        private val buffer = ByteBuffer.allocate(Int.SIZE_BYTES * region.width)

        /** Adds the first columns of an array: a row of colours, or the next plane of a row. */
        fun add(plane: IntArray, from: Int = 0) {
            buffer.asIntBuffer().put(plane, from, region.width)
            output.write(buffer.array())
        }

        /** Returns the block. */
        fun build(counters: Counters): PixelBlock {
            output.close()
            return with(region) {
                PixelBlock(columnStart, rowStart, columnEnd, rowEnd, planes, bytes.toByteArray(), work(counters))
            }
        }
    }

    companion object {
        /**
         * Reads the block of [region].
         *
         * @throws IOException if [input] is not what [write] has written
         */
        fun read(input: DataInputStream, region: Region, planes: Int): PixelBlock {
            val work = LongArray(WORK) { input.readLong() }
            val size = input.readInt()
            val bytes = if (size < 0) ByteArray(0) else input.readNBytes(size)
            if (bytes.size != size) throw EOFException("the block is cut off")
            return with(region) { PixelBlock(columnStart, rowStart, columnEnd, rowEnd, planes, bytes, work) }
        }

        /** How many counters there are. */
        private const val WORK = 6

        /** Returns the numbers of [counters] that tasks report, see [counters]. */
        fun work(counters: Counters): LongArray = with(counters) {
            longArrayOf(primitives, fragments, depthEvaluations, depthPasses, shadingCalls, peakBytes)
        }

        /** Returns counters of the numbers in a block. */
        fun counters(work: LongArray): Counters = Counters.Builder().apply {
            primitives = work[0]
            fragments = work[1]
            depthEvaluations = work[2]
            depthPasses = work[3]
            shadingCalls = work[4]
            peakBytes = work[5]
        }.build()

        /** Spark's own fast compression. */
        private fun codec(): CompressionCodec = LZ4CompressionCodec(SparkEnv.get().conf())
    }
}
