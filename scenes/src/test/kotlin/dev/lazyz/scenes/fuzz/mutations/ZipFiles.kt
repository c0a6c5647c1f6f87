package dev.lazyz.scenes.fuzz.mutations

import java.io.ByteArrayOutputStream
import java.time.LocalDateTime
import java.util.zip.CRC32
import java.util.zip.ZipEntry
import java.util.zip.ZipException
import java.util.zip.ZipOutputStream

/** Packs archives, the same bytes each time. */
internal object ZipFiles {
    /** Packs files in their order, every other one as it is; one whose name is there already is left out. */
    fun of(entries: List<Pair<String, ByteArray>>): ByteArray {
        val out = ByteArrayOutputStream()
        ZipOutputStream(out).use { zip ->
            for ((i, entry) in entries.withIndex()) {
                try {
                    zip.putNextEntry(header(entry.first, entry.second, i % 2 == 1))
                } catch (_: ZipException) {
                    continue
                }
                zip.write(entry.second)
                zip.closeEntry()
            }
        }
        return out.toByteArray()
    }

    private fun header(name: String, bytes: ByteArray, isStored: Boolean) = ZipEntry(name.take(MOST_NAME)).apply {
        timeLocal = LocalDateTime.of(2000, 1, 1, 0, 0)
        if (isStored) {
            method = ZipEntry.STORED
            size = bytes.size.toLong()
            crc = CRC32().also { it.update(bytes) }.value
        }
    }

    /** Names are longer in UTF-8, and have 65535 bytes at most. */
    private const val MOST_NAME = 10_000
}
