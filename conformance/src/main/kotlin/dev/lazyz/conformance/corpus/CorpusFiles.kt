package dev.lazyz.conformance.corpus

import dev.lazyz.Image
import dev.lazyz.conformance.results.SuiteRule
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.security.MessageDigest
import java.util.HexFormat
import java.util.zip.Adler32
import java.util.zip.CRC32
import net.jqwik.api.sessions.JqwikSession

/**
 * The corpus: scenes that a program in any language can draw, with the pictures that are right, for renderers that do
 * not run on the JVM. `docs/corpus.md` describes the files. Thread safe.
 */
public object CorpusFiles {
    /** The version of the corpus. Each version has the same files for everybody, bit for bit. */
    public const val VERSION: Int = 1

    /** The list of all other files with their SHA-256, as `sha256sum -c` reads it. */
    public const val SUMS: String = "SHA256SUMS"

    /** The scenes of all groups, or of those of [rules], in the order of difficulty. */
    internal fun cases(
        rules: Set<SuiteRule> = emptySet(),
        seed: Long = SuiteRule.fixedSeed,
        tries: Double = 1.0,
    ): List<CorpusCase> {
        val cases = ArrayList<CorpusCase>()
        JqwikSession.run {
            for (group in CorpusGroup.all) {
                if (rules.isEmpty() || group.rule in rules) cases += group.cases(seed, tries)
            }
        }
        return cases
    }

    /**
     * Writes the files of this version to [folder], which is created if it does not exist, and returns how many scenes
     * they are. Takes some seconds.
     *
     * @throws IOException if a file cannot be written
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(folder: Path): Int {
        Files.createDirectories(folder)
        val cases = cases()
        val sums = StringBuilder()
        for ((name, bytes) in cases.flatMap { files(it).entries }) {
            Files.write(folder.resolve(name), bytes)
            sums.append(sha256(bytes)).append("  ").append(name).append('\n')
        }
        Files.writeString(folder.resolve(SUMS), sums)
        return cases.size
    }

    /** Returns the SHA-256 of [bytes] in hexadecimal digits. */
    internal fun sha256(bytes: ByteArray): String =
        HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes))

    private fun files(case: CorpusCase): Map<String, ByteArray> {
        val picture = case.scene.expected
        val open = case.scene.isOpen
        return mapOf(
            "${case.name}.json" to case.json().toByteArray(),
            "${case.name}.png" to png(picture),
            "${case.name}-depth.npy" to Npy.write("<i4", picture.height, picture.width, bytes(picture.depth)),
            "${case.name}-primitive.npy" to Npy.write("<i4", picture.height, picture.width, bytes(picture.primitive)),
            "${case.name}-open.npy" to
                Npy.write("|b1", picture.height, picture.width, ByteArray(open.size) { if (open[it]) 1 else 0 }),
        )
    }

    private fun bytes(numbers: IntArray): ByteArray {
        val buffer = ByteBuffer.allocate(Int.SIZE_BYTES * numbers.size).order(ByteOrder.LITTLE_ENDIAN)
        buffer.asIntBuffer().put(numbers)
        return buffer.array()
    }

    /** Returns a PNG file without compression, because that of zlib is not the same on every machine. */
    private fun png(image: Image): ByteArray {
        val rows = ByteBuffer.allocate(image.height * (1 + Int.SIZE_BYTES * image.width))
        for (y in 0 until image.height) {
            rows.put(0)
            for (x in 0 until image.width) rows.putInt(Integer.rotateLeft(image.argb(x, y), 8))
        }
        val raw = rows.array()
        check(raw.size <= MOST_STORED) { "a picture of the corpus is too large: ${raw.size} bytes" }
        val zlib = ByteBuffer.allocate(raw.size + ZLIB)
        zlib.putShort(0x7801).put(1).order(ByteOrder.LITTLE_ENDIAN)
        zlib.putShort(raw.size.toShort()).putShort(raw.size.inv().toShort()).put(raw).order(ByteOrder.BIG_ENDIAN)
        zlib.putInt(Adler32().apply { update(raw) }.value.toInt())
        val header = ByteBuffer.allocate(HEADER).putInt(image.width).putInt(image.height)
        header.put(byteArrayOf(8, 6, 0, 0, 0))
        val file = ByteArrayOutputStream()
        DataOutputStream(file).use { output ->
            output.writeLong(SIGNATURE)
            for ((type, data) in listOf("IHDR" to header.array(), "IDAT" to zlib.array(), "IEND" to ByteArray(0))) {
                val chunk = type.toByteArray() + data
                output.writeInt(data.size)
                output.write(chunk)
                output.writeInt(CRC32().apply { update(chunk) }.value.toInt())
            }
        }
        return file.toByteArray()
    }

    private const val SIGNATURE = -0x76afb1b8f2f5e5f6L
    private const val HEADER = 13
    private const val MOST_STORED = 0xFFFF

    /** Bytes of a zlib stream besides those of its only block. */
    private const val ZLIB = 11
}

/** NumPy's files of arrays, version 1.0, of whole numbers. */
internal object Npy {
    private val MAGIC = byteArrayOf(0x93.toByte()) + "NUMPY".toByteArray(Charsets.US_ASCII)
    private const val START = 10
    private const val ALIGNMENT = 64

    fun write(type: String, rows: Int, columns: Int, bytes: ByteArray): ByteArray {
        val text = "{'descr': '$type', 'fortran_order': False, 'shape': ($rows, $columns), }"
        val length = (START + text.length + ALIGNMENT) / ALIGNMENT * ALIGNMENT - START
        val header = MAGIC + byteArrayOf(1, 0, length.toByte(), (length ushr 8).toByte())
        return header + (text.padEnd(length - 1) + "\n").toByteArray(Charsets.US_ASCII) + bytes
    }

    fun isNpy(bytes: ByteArray): Boolean = bytes.size > START && MAGIC.indices.all { bytes[it] == MAGIC[it] }

    /**
     * Returns the numbers of a file with this [shape], of bytes or of 32 bits in little-endian order.
     *
     * @throws IOException if the file is another one; the message continues a sentence about the file
     */
    fun read(bytes: ByteArray, shape: List<Int>): IntArray {
        if (!isNpy(bytes)) throw IOException("is not an NPY file")
        val start = START + (bytes[8].toInt() and 0xFF) + (bytes[9].toInt() and 0xFF shl 8)
        val header = String(bytes, START, minOf(start, bytes.size) - START, Charsets.US_ASCII)
        val found = header.substringAfter("'shape': (", "").substringBefore(')').split(',').filter { it.isNotBlank() }
        if (found.map { it.trim() } != shape.map { "$it" }) {
            throw IOException("has the shape (${found.joinToString().take(40)}), not (${shape.joinToString()})")
        }
        val type = header.substringAfter("'descr': '", "").substringBefore('\'')
        val size = mapOf("|u1" to 1, "<i4" to Int.SIZE_BYTES)[type]
        if (size == null || "'fortran_order': False" !in header) {
            throw IOException("must have the type |u1 or <i4, in C order")
        }
        val count = shape.fold(1) { product, it -> product * it }
        if (bytes.size < start + size * count) throw IOException("is too short")
        val data = ByteBuffer.wrap(bytes, start, size * count).slice().order(ByteOrder.LITTLE_ENDIAN)
        return if (size == 1) {
            IntArray(count) { data.get(it).toInt() and 0xFF }
        } else {
            IntArray(count).also { data.asIntBuffer().get(it) }
        }
    }
}
