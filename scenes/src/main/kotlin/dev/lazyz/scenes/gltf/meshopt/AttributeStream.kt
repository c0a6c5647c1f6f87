package dev.lazyz.scenes.gltf.meshopt

/**
 * Decodes mode `ATTRIBUTES`: elements of any type, stored as differences of their bytes (appendix A, "Mode 0:
 * attributes").
 */
internal object AttributeStream {
    private const val VERSION_0 = 0xA0
    private const val VERSION_1 = 0xA1
    private const val LEAST_TAIL_0 = 32
    private const val LEAST_TAIL_1 = 24
    private const val BLOCK_BYTES = 8192
    private const val BLOCK_ELEMENTS = 256

    /** Returns [count] elements of [stride] bytes. [stride] is a multiple of 4 up to 256. */
    fun decode(bytes: ByteArray, count: Int, stride: Int, work: (Int) -> Unit): ByteArray {
        val header = if (bytes.isEmpty()) -1 else bytes[0].toInt() and 0xFF
        if (header != VERSION_0 && header != VERSION_1) {
            throw MeshoptException("the first byte is $header, not $VERSION_0 or $VERSION_1")
        }
        val isFirst = header == VERSION_0

        // The tail: the element that precedes the first one, then the kind of differences for each 4 bytes
        val tail = if (isFirst) stride else stride + stride / 4
        val paddedTail = maxOf(tail, if (isFirst) LEAST_TAIL_0 else LEAST_TAIL_1)
        val input = CompressedBytes(bytes, 1, bytes.size - paddedTail)
        val tailStart = bytes.size - tail
        val before = bytes.copyOfRange(tailStart, tailStart + stride)
        val channels = ByteArray(stride / 4)
        if (!isFirst) bytes.copyInto(channels, 0, tailStart + stride, bytes.size)
        val deltas = ElementDeltas(before, channels)

        val result = ByteArray(count * stride)
        val most = minOf(BLOCK_BYTES / stride and 15.inv(), BLOCK_ELEMENTS)
        for (start in 0 until count step most) {
            work(most)
            block(input, isFirst, deltas, result, start * stride, minOf(most, count - start))
        }
        input.expectEnd()
        return result
    }

    private fun block(
        input: CompressedBytes,
        isFirst: Boolean,
        deltas: ElementDeltas,
        result: ByteArray,
        start: Int,
        count: Int,
    ) {
        val channels = deltas.channelCount
        val controls = if (isFirst) null else IntArray(channels) { input.next() }
        val columns = ByteArray(4 * count)
        for (channel in 0 until channels) {
            for (byte in 0 until 4) {
                val control = controls?.let { it[channel] shr 2 * byte and 3 }
                ByteGroups.read(input, control, columns, byte * count, count)
            }
            deltas.resolve(channel, columns, count, result, start)
        }
    }
}

/**
 * Turns differences between elements into the elements (appendix A, "Mode 0: attributes").
 *
 * @param before the element that precedes the next one; it is overwritten
 * @param channels the kind of differences for each 4 bytes of an element
 */
internal class ElementDeltas(private val before: ByteArray, private val channels: ByteArray) {
    private val stride = before.size

    /** Number of groups of 4 bytes in an element. */
    val channelCount: Int get() = channels.size

    init {
        for (channel in channels) {
            val mode = channel.toInt() and 0xFF
            if (mode and 15 > XOR || (mode and 15 != XOR && mode shr 4 != 0)) {
                throw MeshoptException("there is no channel mode $mode")
            }
        }
    }

    /**
     * Writes 4 bytes of each of [count] elements to [result]. The first element begins at [start].
     *
     * @param columns the differences: all of the first byte, then all of the second, and so on
     */
    fun resolve(channel: Int, columns: ByteArray, count: Int, result: ByteArray, start: Int) {
        val mode = channels[channel].toInt() and 0xFF
        val offset = 4 * channel
        var last = word(before, offset)
        for (i in 0 until count) {
            val delta = (columns[i].toInt() and 0xFF) or (columns[count + i].toInt() and 0xFF shl 8) or
                (columns[2 * count + i].toInt() and 0xFF shl 16) or (columns[3 * count + i].toInt() shl 24)
            last = when (mode and 15) {
                BYTES -> parts(last, delta, 8)
                PAIRS -> parts(last, delta, 16)
                else -> last xor Integer.rotateRight(delta, mode shr 4)
            }
            val at = start + i * stride + offset
            for (byte in 0 until 4) result[at + byte] = (last shr 8 * byte).toByte()
        }
        for (byte in 0 until 4) before[offset + byte] = (last shr 8 * byte).toByte()
    }

    /** Adds the differences to the corresponding parts of [bits] bits each, without carry between parts. */
    private fun parts(last: Int, delta: Int, bits: Int): Int {
        val mask = (1 shl bits) - 1
        var sum = 0
        for (shift in 0 until 32 step bits) {
            val part = (last ushr shift) + signed(delta ushr shift and mask)
            sum = sum or (part and mask shl shift)
        }
        return sum
    }

    private fun word(bytes: ByteArray, at: Int): Int = (bytes[at].toInt() and 0xFF) or
        (bytes[at + 1].toInt() and 0xFF shl 8) or (bytes[at + 2].toInt() and 0xFF shl 16) or
        (bytes[at + 3].toInt() shl 24)

    private companion object {
        const val BYTES = 0
        const val PAIRS = 1
        const val XOR = 2
    }
}
