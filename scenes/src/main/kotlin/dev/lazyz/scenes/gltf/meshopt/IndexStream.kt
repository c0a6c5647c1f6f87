package dev.lazyz.scenes.gltf.meshopt

/** Decodes mode `INDICES`: integers stored as differences from one of two earlier values (appendix A, "Mode 2"). */
internal object IndexStream {
    private const val HEADER = 0xD1
    private const val TAIL = 4

    fun decode(bytes: ByteArray, count: Int, stride: Int, work: (Int) -> Unit): ByteArray {
        val input = CompressedBytes(bytes, 0, bytes.size - TAIL)
        val header = input.next()
        if (header != HEADER) throw MeshoptException("the first byte is $header, not $HEADER")
        val result = IndexBytes(count, stride)
        val last = IntArray(2)
        for (i in 0 until count) {
            work(1)
            val code = input.variable()
            val baseline = code and 1
            last[baseline] += signed(code ushr 1)
            result.put(i, last[baseline])
        }
        input.expectEnd()
        return result.bytes
    }
}

/** An array of integers of [stride] bytes, 2 or 4, little endian. Higher bits are dropped. */
internal class IndexBytes(count: Int, private val stride: Int) {
    val bytes = ByteArray(count * stride)

    fun put(place: Int, value: Int) {
        for (byte in 0 until stride) bytes[place * stride + byte] = (value shr 8 * byte).toByte()
    }
}
