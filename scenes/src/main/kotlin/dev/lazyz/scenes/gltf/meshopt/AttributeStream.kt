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
