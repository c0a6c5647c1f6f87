package dev.lazyz.scenes.gltf.meshopt

/** Reports an error in a compressed buffer view. The caller adds the place in the file. */
internal class MeshoptException(message: String) : RuntimeException(message)

/** Reads [bytes] in order from [position] to [end] (exclusive), where the tail of the stream begins. */
internal class CompressedBytes(private val bytes: ByteArray, private var position: Int, private val end: Int) {
    init {
        if (end < position || end > bytes.size) throw MeshoptException("the ${bytes.size} compressed bytes are too few")
    }

    /** Returns the next byte, 0..255. */
    fun next(): Int {
        if (position == end) throw MeshoptException("the compressed data ends too early, at byte $position of it")
        return bytes[position++].toInt() and 0xFF
    }

    /** Returns a number of 1 to 5 bytes with 7 bits each, lowest bits first. */
    fun variable(): Int {
        var value = 0
        for (shift in 0..28 step 7) {
            val byte = next()
            value = value or (byte and 0x7F shl shift)
            if (byte < 0x80) return value
        }
        throw MeshoptException("a number before byte $position of the compressed data has more than 5 bytes")
    }

    /** Fails if bytes are left over. */
    fun expectEnd() {
        if (position != end) throw MeshoptException("${end - position} bytes of the compressed data are left over")
    }
}

/** Decodes a difference: even codes stand for 0, 1, 2 and so on, odd codes for -1, -2, -3 and so on. */
internal fun signed(code: Int): Int = (code ushr 1) xor -(code and 1)
