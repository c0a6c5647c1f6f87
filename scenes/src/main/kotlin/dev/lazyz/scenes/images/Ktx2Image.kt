package dev.lazyz.scenes.images

import dev.lazyz.scenes.loading.Loading
import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.io.ByteArrayInputStream
import java.io.EOFException
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.InflaterInputStream

/**
 * A KTX 2.0 file (Khronos Group, "KTX File Format Specification", version 2.0) with one picture of 8 bits a channel,
 * as it is or compressed by zlib or Zstandard. Only its largest level is read.
 *
 * Channels that are missing are 0, and alpha is 255, unless the metadata `KTXswizzle` says otherwise; `KTXorientation`
 * is obeyed.
 */
internal class Ktx2Image private constructor(private val bytes: ByteArray) {
    private val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
    private val format = int(12)
    private val width = int(20)
    private val height = int(24)
    private val scheme = int(44)
    private val channels = CHANNELS[format].orEmpty()
    private val start = buffer.getLong(LEVELS)
    private val length = buffer.getLong(LEVELS + 8)

    /** Number of pixels. */
    val pixels: Long get() = width * height

    /** Bytes that are needed to decode it. */
    val memory: Long get() = pixels * (Loading.DECODING_BYTES + if (scheme == ZSTANDARD) channels.length else 0)

    /** The format and how to convert it, if it is one that is not read; otherwise null. */
    val refusal: String? = when {
        scheme == BASIS_LZ -> "Basis Universal compression (ETC1S)$BASIS_REMEDY"
        format == 0L && colorModel() == UASTC -> "Basis Universal compression (UASTC)$BASIS_REMEDY"
        scheme > ZLIB || channels.isEmpty() -> "texels of the Vulkan format $format; save it as PNG, JPEG or WebP"
        height == 0L || int(28) > 1 || int(32) > 1 || int(36) != 1L -> "several pictures; save one as PNG, JPEG or WebP"
        else -> null
    }?.let { "KTX2 with $it" }

    private fun isValid(): Boolean {
        val mostPacked = length * (MOST_UNPACKED[scheme] ?: 1)
        return width in 1..MOST_SIDE && height in 1..MOST_SIDE && start >= LEVELS && length >= 0 &&
            length <= bytes.size - start && pixels * channels.length <= mostPacked
    }

    /**
     * Returns the picture.
     *
     * @param look called now and then; throws to end the decoding
     * @throws IOException if the data is damaged or cut short
     */
    fun decode(look: () -> Unit): BufferedImage {
        val image = BufferedImage(width.toInt(), height.toInt(), BufferedImage.TYPE_INT_ARGB)
        val argb = (image.raster.dataBuffer as DataBufferInt).data
        val swizzle = metadata("KTXswizzle")?.takeIf { it.length == ARGB.length } ?: "rgba"
        val from = IntArray(ARGB.length) { place(swizzle["rgba".indexOf(ARGB[it])]) }
        val orientation = metadata("KTXorientation").orEmpty()
        val isUpward = orientation.getOrNull(1) == 'u'
        val isLeftward = orientation.getOrNull(0) == 'l'
        val packed = ByteArrayInputStream(bytes, start.toInt(), length.toInt())
        val stream = when (scheme) {
            ZLIB -> InflaterInputStream(packed)
            ZSTANDARD -> ByteArrayInputStream(unpacked(look))
            else -> packed
        }
        val row = ByteArray(image.width * channels.length)
        for (y in 0 until image.height) {
            look()
            if (stream.readNBytes(row, 0, row.size) < row.size) throw EOFException("the file is cut short")
            val to = (if (isUpward) image.height - 1 - y else y) * image.width
            for (x in 0 until image.width) {
                var pixel = 0
                for (place in from) pixel = pixel shl 8 or code(row, x * channels.length, place)
                argb[to + if (isLeftward) image.width - 1 - x else x] = pixel
            }
        }
        return image
    }

    private fun unpacked(look: () -> Unit): ByteArray =
        Zstandard.decode(bytes, start.toInt(), length.toInt(), Math.toIntExact(pixels * channels.length), look)

    /** Returns where in a texel the channel is that [letter] names, or [ZERO] or [ONE] for a constant. */
    private fun place(letter: Char): Int = when {
        letter in channels -> channels.indexOf(letter)
        letter == 'a' || letter == '1' -> ONE
        else -> ZERO
    }

    private fun code(row: ByteArray, texel: Int, place: Int): Int = when (place) {
        ZERO -> 0
        ONE -> 0xFF
        else -> row[texel + place].toInt() and 0xFF
    }

    /** Returns the value of [key], or null. Each entry has its length, its key, a zero and its value. */
    private fun metadata(key: String): String? {
        val end = minOf(int(56) + int(60), bytes.size.toLong())
        var at = int(56)
        while (at + 4 <= end) {
            val from = at + 4
            val length = minOf(int(at.toInt()), end - from)
            val (name, value) = String(bytes, from.toInt(), length.toInt(), Charsets.UTF_8).split('\u0000') + ""
            if (name == key) return value
            at = (from + length + 3) / 4 * 4
        }
        return null
    }

    /** The colour model of the data format descriptor, or -1. */
    private fun colorModel(): Int = bytes.code(minOf(int(48) + 12, bytes.size.toLong()).toInt())

    private fun int(at: Int): Long = Integer.toUnsignedLong(buffer.getInt(at))

    companion object {
        private val SIGNATURE = byteArrayOf(0xAB.toByte(), 'K'.code.toByte(), 'T'.code.toByte(), 'X'.code.toByte()) +
            byteArrayOf(0x20, '2'.code.toByte(), '0'.code.toByte(), 0xBB.toByte(), 0x0D, 0x0A, 0x1A, 0x0A)

        /** Where the levels are listed, and where the list of one level ends. */
        private const val LEVELS = 80
        private const val HEADER = 104

        /** How data is compressed, and the colour model of UASTC. */
        private const val BASIS_LZ = 1L
        private const val ZSTANDARD = 2L
        private const val ZLIB = 3L
        private const val UASTC = 166

        /** Bytes that one byte can become: a block of 4 has 128 KiB at most. */
        private val MOST_UNPACKED = mapOf(ZLIB to 1032L, ZSTANDARD to 32768L)

        /** The longest side, so that products fit into a number. */
        private const val MOST_SIDE = 1L shl 24

        /** The channels of the formats of 8 bits, by their numbers in Vulkan, for linear and for sRGB codes. */
        private val CHANNELS = mapOf(
            9L to "r", 15L to "r", 16L to "rg", 22L to "rg", 23L to "rgb", 29L to "rgb", 30L to "bgr", 36L to "bgr",
            37L to "rgba", 43L to "rgba", 44L to "bgra", 50L to "bgra",
        )
        private const val ARGB = "argb"
        private const val ZERO = -1
        private const val ONE = -2
        private const val BASIS_REMEDY = "; \"ktx extract --transcode rgba8 A.ktx2 A.png\" converts it, " +
            "or \"gltf-transform ktxdecompress A.glb B.glb\" the whole model"

        private fun read(bytes: ByteArray): Ktx2Image? =
            if (bytes.size >= HEADER && SIGNATURE.isAt(bytes, 0)) Ktx2Image(bytes) else null

        /** Returns the picture in [bytes], which is not decoded yet; null if there is none that is read. */
        fun of(bytes: ByteArray): Ktx2Image? = read(bytes)?.takeIf { it.refusal == null && it.isValid() }

        /** Returns [refusal] for the file that begins with [bytes], or null if it is of another format. */
        fun refusal(bytes: ByteArray): String? = read(bytes)?.refusal
    }
}
