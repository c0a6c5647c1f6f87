package dev.lazyz.scenes.gltf.meshopt

/** What is wrong with a compressed buffer view; whoever knows the file says where it is. */
internal class MeshoptException(message: String) : RuntimeException(message)

/** Reads [bytes] one after the other, from [position] to before [end], which is where the tail of the stream begins. */
internal class CompressedBytes(private val bytes: ByteArray, private var position: Int, private val end: Int) {
    init {
        if (end < position || end > bytes.size) throw MeshoptException("the ${bytes.size} compressed bytes are too few")
    }

    /** Returns the next byte, 0..255. */
    fun next(): Int {
        if (position == end) throw MeshoptException("the compressed data ends too early, at byte $position of it")
        return bytes[position++].toInt() and 0xFF
    }

    /** Returns a number of 1 to 5 bytes, 7 bits each, the lowest first. */
    fun variable(): Int {
        var value = 0
        for (shift in 0..28 step 7) {
            val byte = next()
            value = value or (byte and 0x7F shl shift)
            if (byte < 0x80) return value
        }
        throw MeshoptException("a number before byte $position of the compressed data has more than 5 bytes")
    }

    /** Fails unless everything was read. */
    fun expectEnd() {
        if (position != end) throw MeshoptException("${end - position} bytes of the compressed data are left over")
    }
}

/** Returns the difference that [code] stands for: even numbers are 0, 1, 2 and so on, odd ones -1, -2, -3 and so on. */
internal fun signed(code: Int): Int = (code ushr 1) xor -(code and 1)
