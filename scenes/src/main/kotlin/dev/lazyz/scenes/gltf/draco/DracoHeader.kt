package dev.lazyz.scenes.gltf.draco

/** Reports an error in Draco data. The caller adds the place in the file. */
internal class DracoException(message: String, cause: Throwable? = null) : RuntimeException(message, cause)

/**
 * The numbers of triangles and vertices that Draco data declares. They are read before anything is decoded (Google,
 * "Draco Bitstream Specification", version 2.2, sections 2 to 5).
 *
 * @property faces number of triangles
 * @property vertices minimum number of vertices
 */
internal class DracoHeader private constructor(val faces: Long, val vertices: Long) {
    private class Reader(private val bytes: ByteArray) {
        private var position = 0

        fun byte(): Int {
            if (position >= bytes.size) throw DracoException("the compressed data ends within its header")
            return bytes[position++].toInt() and 0xFF
        }

        fun variable(): Long {
            var value = 0L
            for (shift in 0..28 step 7) {
                val byte = byte()
                value = value or (byte and 0x7F).toLong().shl(shift)
                if (byte < 0x80) return value
            }
            throw DracoException("a number before byte $position of the compressed data is beyond 32 bits")
        }

        fun skip(count: Long) {
            if (count > bytes.size - position) throw DracoException("the compressed data ends within its header")
            position += count.toInt()
        }
    }

    companion object {
        private const val MESH = 1
        private const val SEQUENTIAL = 0
        private const val HAS_METADATA = 0x80
        private const val MAX_DEPTH = 64

        /** Reads the header of a mesh. */
        fun read(bytes: ByteArray): DracoHeader {
            val reader = Reader(bytes)
            if ("DRACO".any { reader.byte() != it.code }) throw DracoException("the compressed data is not Draco's")
            val version = "${reader.byte()}.${reader.byte()}"
            if (version != "2.2") throw DracoException("the compressed data is of version $version, not 2.2")
            if (reader.byte() != MESH) throw DracoException("the compressed data is no mesh")
            val method = reader.byte()
            reader.byte()
            if (reader.byte() and HAS_METADATA != 0) skipMetadata(reader)
            if (method == SEQUENTIAL) {
                val faces = reader.variable()
                return DracoHeader(faces, reader.variable())
            }
            reader.byte()
            val vertices = reader.variable()
            return DracoHeader(reader.variable(), vertices)
        }

        private fun skipMetadata(reader: Reader) {
            repeat(atMost(reader.variable())) {
                reader.variable()
                skipEntries(reader, 0)
            }
            skipEntries(reader, 0)
        }

        private fun skipEntries(reader: Reader, depth: Int) {
            if (depth > MAX_DEPTH) throw DracoException("the metadata is nested more than $MAX_DEPTH deep")
            repeat(atMost(reader.variable())) {
                reader.skip(reader.byte().toLong())
                reader.skip(reader.variable())
            }
            repeat(atMost(reader.variable())) {
                reader.skip(reader.byte().toLong())
                skipEntries(reader, depth + 1)
            }
        }

        /**
         * Returns [count] as an `Int`, clamped. Each item takes at least one byte, so a count that is too large fails
         * at the end of the data.
         */
        private fun atMost(count: Long): Int = minOf(count, Int.MAX_VALUE.toLong()).toInt()
    }
}
