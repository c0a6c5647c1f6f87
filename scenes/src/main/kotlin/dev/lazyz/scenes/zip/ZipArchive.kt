package dev.lazyz.scenes.zip

import dev.lazyz.scenes.loading.Source
import java.io.ByteArrayInputStream
import java.io.IOException
import java.io.InputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.CRC32
import java.util.zip.Inflater
import java.util.zip.InflaterInputStream

/**
 * The files in a ZIP archive, found through its directory (PKWARE, ".ZIP File Format Specification", version 6.3.10,
 * including the directory's 64-bit numbers). Names are compared without regard to case, as the Open Packaging
 * Conventions require (ECMA-376, part 2, 6.2.2.3). Not thread safe.
 */
internal class ZipArchive(private val source: Source) {
    private class Entry(
        val name: String,
        val method: Int,
        val isEncrypted: Boolean,
        val isLink: Boolean,
        val checksum: Long,
        val size: Long,
        val position: Long,
    )

    private val buffer = ByteBuffer.wrap(source.bytes).order(ByteOrder.LITTLE_ENDIAN)
    private val entries = LinkedHashMap<String, Entry>()

    init {
        readDirectory()
    }

    /** The names of all files, in the directory's order. */
    val names: List<String> get() = entries.values.map { it.name }

    /** A name that is there twice, or null. */
    var repeated: String? = null
        private set

    /** Returns whether the file called [name] is a symbolic link. */
    fun isLink(name: String): Boolean = entries[key(name)]?.isLink == true

    /** Fails if the file called [name] is encrypted. */
    fun requirePlain(name: String) {
        val entry = entries[key(name)] ?: return
        if (entry.isEncrypted) source.fail(entry.name, "is encrypted", "save the model without a password")
    }

    /**
     * Returns the decompressed bytes of the file called [name], or null if there is none. Bytes of compressed files
     * count towards the limits as they are read.
     *
     * @param isStrict whether the bytes of others count, too, as files may share them, and what cannot be decompressed,
     *   or has another checksum, is a [dev.lazyz.scenes.SceneFormatException]
     */
    fun open(name: String, isStrict: Boolean = false): InputStream? {
        val entry = entries[key(name)] ?: return null
        requirePlain(name)
        val start = entry.position
        if (start < 0 || start > buffer.limit() - LOCAL_HEADER || buffer.getInt(start.toInt()) != LOCAL_MARK) damaged()
        val at = start.toInt()
        val content = start + LOCAL_HEADER + short(at + 26) + short(at + 28)
        if (entry.size < 0 || entry.size > buffer.limit() - content) damaged()
        val packed = ByteArrayInputStream(source.bytes, content.toInt(), entry.size.toInt())
        return when (entry.method) {
            STORED -> if (isStrict) Limited(source, packed, entry) else packed
            DEFLATED -> Limited(source, Inflated(packed), entry.takeIf { isStrict })
            else -> source.fail(entry.name, "is packed by method ${entry.method}", "pack it by method 8, deflate")
        }
    }

    private fun readDirectory() {
        val end = (buffer.limit() - END_RECORD downTo maxOf(0, buffer.limit() - END_RECORD - MOST_COMMENT))
            .firstOrNull { buffer.getInt(it) == END_MARK } ?: source.fail(
            null,
            "the file is no ZIP archive, or is cut short",
            "export or copy the model again",
        )
        var count = short(end + 10).toLong()
        var position = buffer.getInt(end + 16).toLong() and MOST_INT
        val locator = end - LOCATOR
        if (locator >= 0 && buffer.getInt(locator) == LOCATOR_MARK) {
            val large = buffer.getLong(locator + 8)
            if (large < 0 || large > buffer.limit() - LARGE_END_RECORD) damaged()
            count = buffer.getLong(large.toInt() + 32)
            position = buffer.getLong(large.toInt() + 48)
        }
        while (count-- > 0) {
            if (position < 0 || position > buffer.limit() - DIRECTORY_HEADER) damaged()
            source.loading.items(source, 1)
            position = readEntry(position.toInt())
        }
    }

    /** Reads the directory entry at [at], and returns the position of the next one. */
    private fun readEntry(at: Int): Long {
        if (buffer.getInt(at) != DIRECTORY_MARK) damaged()
        val nameLength = short(at + 28)
        val extraLength = short(at + 30)
        val next = at.toLong() + DIRECTORY_HEADER + nameLength + extraLength + short(at + 32)
        if (next > buffer.limit()) damaged()
        val name = String(source.bytes, at + DIRECTORY_HEADER, nameLength, Charsets.UTF_8)

        // Numbers that do not fit into 32 bits are in an extra field, in this order and only where needed: both sizes,
        // the position
        val length = buffer.getInt(at + 24).toLong() and MOST_INT
        val checksum = buffer.getInt(at + 16).toLong() and MOST_INT
        var size = buffer.getInt(at + 20).toLong() and MOST_INT
        var position = buffer.getInt(at + 42).toLong() and MOST_INT
        var large = largeNumbers(at + DIRECTORY_HEADER + nameLength, extraLength) + (if (length == MOST_INT) 8 else 0)
        if (size == MOST_INT) {
            size = long(large)
            large += 8
        }
        if (position == MOST_INT) position = long(large)
        val isEncrypted = short(at + 8) and 1 != 0
        val isLink = short(at + 4) shr 8 == UNIX && short(at + 40) and FILE_TYPE == LINK
        val entry = Entry(name, short(at + 10), isEncrypted, isLink, checksum, size, position)
        if (entries.putIfAbsent(key(name), entry) != null) repeated = name
        return next
    }

    /**
     * Returns the position of the 64-bit numbers in the extra fields at [start], or the end of the file if there are
     * none.
     */
    private fun largeNumbers(start: Int, length: Int): Int {
        var at = start
        while (at + 4 <= start + length) {
            if (short(at) == 1) return at + 4
            at += 4 + short(at + 2)
        }
        return buffer.limit()
    }

    private fun short(at: Int): Int = buffer.getShort(at).toInt() and 0xFFFF

    private fun long(at: Int): Long = if (at <= buffer.limit() - 8) buffer.getLong(at) else damaged()

    private fun damaged(): Nothing =
        source.fail(null, "the ZIP archive's directory is damaged", "export or copy the model again")

    /** Decompressed bytes. Closing it frees the memory of the decompressor, too, which is outside the heap. */
    private class Inflated(packed: InputStream) : InflaterInputStream(packed, Inflater(true), CHUNK) {
        override fun close() {
            super.close()
            inf.end()
        }
    }

    /** Decompressed bytes, of [strict] if they are checked. They are counted towards the limits as they are read. */
    private class Limited(private val source: Source, private val decoded: InputStream, private val strict: Entry?,) :
        InputStream() {
        private val checksum = CRC32()

        override fun read(): Int = ByteArray(1).let { if (read(it, 0, 1) < 0) -1 else it[0].toInt() and 0xFF }

        override fun read(bytes: ByteArray, offset: Int, length: Int): Int {
            val count = try {
                decoded.read(bytes, offset, minOf(length, CHUNK))
            } catch (damaged: IOException) {
                if (strict == null) throw damaged
                source.fail(strict.name, "is damaged: ${damaged.message}", "pack it again", damaged)
            }
            if (count > 0) {
                source.loading.decode(source, count.toLong())
                if (strict != null) checksum.update(bytes, offset, count)
            } else if (count < 0 && strict != null && checksum.value != strict.checksum) {
                source.fail(strict.name, "is damaged: its checksum is another", "pack it again")
            }
            return count
        }

        override fun close() = decoded.close()
    }

    companion object {
        private const val MOST_INT = 0xFFFFFFFFL
        private const val END_MARK = 0x06054B50
        private const val END_RECORD = 22
        private const val MOST_COMMENT = 0xFFFF
        private const val LOCATOR_MARK = 0x07064B50
        private const val LOCATOR = 20
        private const val LARGE_END_RECORD = 56
        private const val DIRECTORY_MARK = 0x02014B50
        private const val DIRECTORY_HEADER = 46
        private const val LOCAL_MARK = 0x04034B50
        private const val LOCAL_HEADER = 30
        private const val STORED = 0
        private const val DEFLATED = 8
        private const val CHUNK = 1 shl 16

        /** The system whose attributes a file has, the bits of its type, and that of a link. */
        private const val UNIX = 3
        private const val FILE_TYPE = 0xF000
        private const val LINK = 0xA000

        private fun key(name: String): String = name.removePrefix("/").lowercase()
    }
}
