package dev.lazyz.scenes.formats

import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.CRC32
import java.util.zip.Deflater

/** Writes ZIP archives as no usual program does. */
internal class RawZip {
    private val content = ByteArrayOutputStream()
    private val directory = ByteArrayOutputStream()
    private var count = 0L

    /**
     * Adds a file.
     *
     * @param place where its bytes are; by default, they are added
     * @param mode the type and the rights of the file on Unix
     */
    fun add(
        name: String,
        bytes: ByteArray = ByteArray(0),
        isPacked: Boolean = false,
        flags: Int = 0,
        mode: Int = 0,
        place: Int? = null,
    ): RawZip = apply {
        val packed = if (isPacked) packed(bytes) else bytes
        val at = place ?: content.size()
        val text = name.toByteArray()
        val method = if (isPacked) 8 else 0
        val checksum = CRC32().also { it.update(bytes) }.value.toInt()
        if (place == null) {
            content.write(
                numbers(30) {
                    putInt(0x04034B50).putShort(20).putShort(flags.toShort()).putShort(method.toShort())
                    position(26).putShort(text.size.toShort())
                },
            )
            content.write(text)
            content.write(packed)
        }
        directory.write(
            numbers(46) {
                putInt(0x02014B50).putShort((3 shl 8 or 20).toShort()).putShort(20).putShort(flags.toShort())
                putShort(method.toShort())
                position(16).putInt(checksum).putInt(packed.size).putInt(bytes.size).putShort(text.size.toShort())
                position(38).putInt(mode shl 16).putInt(at)
            },
        )
        directory.write(text)
        count++
    }

    /** Returns the archive. [claimed] is the number of files that it says it has. */
    fun bytes(claimed: Long = count): ByteArray {
        val start = content.size()
        val all = ByteArrayOutputStream()
        content.writeTo(all)
        directory.writeTo(all)
        if (claimed !in 0..0xFFFF) {
            val large = all.size().toLong()
            all.write(
                numbers(56) {
                    putInt(0x06064B50)
                    position(24).putLong(claimed).putLong(claimed)
                    position(48).putLong(start.toLong())
                },
            )
            all.write(
                numbers(20) {
                    putInt(0x07064B50)
                    position(8).putLong(large)
                },
            )
        }
        all.write(
            numbers(22) {
                putInt(0x06054B50)
                position(8).putShort(claimed.toShort()).putShort(claimed.toShort())
                position(16).putInt(start)
            },
        )
        return all.toByteArray()
    }

    private fun numbers(size: Int, put: ByteBuffer.() -> Unit): ByteArray =
        ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN).apply(put).array()

    private fun packed(bytes: ByteArray): ByteArray {
        val deflater = Deflater(9, true).apply {
            setInput(bytes)
            finish()
        }
        val out = ByteArrayOutputStream()
        val part = ByteArray(1 shl 16)
        while (!deflater.finished()) out.write(part, 0, deflater.deflate(part))
        return out.toByteArray().also { deflater.end() }
    }
}
