package dev.lazyz.scenes.images

import dev.lazyz.RenderOptions
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.light.EnvironmentMap
import java.lang.ref.SoftReference
import java.nio.ByteBuffer
import java.nio.file.Path
import java.security.MessageDigest

/**
 * Pictures of surroundings: Radiance files (`.hdr`, RGBE), as Greg Ward describes them in "Real Pixels", Graphics Gems
 * II, 1991, and in the file formats of Radiance; with either run-length encoding, or without. `EXPOSURE` and the like
 * have no effect.
 *
 * Sides above 2048 columns are reduced by a whole factor while they are read: no more is seen of surroundings.
 */
internal class RadianceImage private constructor(private val source: Source) {
    private val bytes = source.bytes
    private var at = 0
    private var tooBright = 0L

    private fun map(options: RenderOptions): EnvironmentMap {
        readHeader()
        val (height, width) = sides()
        val least = (width + MOST_COLUMNS - 1) / MOST_COLUMNS
        val part = (least..MOST_PART).firstOrNull { width % it == 0 && height % it == 0 } ?: 1
        val columns = width / part
        val rows = height / part
        source.loading.texels(source, width.toLong() * height, 12L * columns * rows)
        source.loading.decode(source, EnvironmentMap.memory(columns, rows))
        val rgb = FloatArray(3 * columns * rows)
        val row = IntArray(width)
        for (y in 0 until height) {
            source.step(width)
            readRow(row)
            for (x in 0 until width) add(row[x], rgb, 3 * ((y / part) * columns + x / part))
        }
        if (tooBright >
            0
        ) {
            source.warn("$tooBright pixels are brighter than ${EnvironmentMap.MOST}, and shown like that")
        }
        val weight = 1f / (part * part)
        if (part > 1) for (i in rgb.indices) rgb[i] = minOf(weight * rgb[i], EnvironmentMap.MOST)
        source.release()
        return try {
            EnvironmentMap.of(columns, rows, rgb, options)
        } catch (e: InterruptedException) {
            Thread.currentThread().interrupt()
            source.fail(null, Loading.INTERRUPTED, cause = e)
        }
    }

    private fun readHeader() {
        if (MARK.indices.any { bytes.getOrNull(it) != MARK[it] }) refuse()
        line()
        while (true) {
            val start = at
            val line = line()
            if (line.isEmpty()) return
            if (line.startsWith("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
                fail(start, "has '$line' and not 32-bit_rle_rgbe", "save it as Radiance RGBE")
            }
        }
    }

    private fun refuse(): Nothing {
        val isExr = EXR.indices.all { bytes.getOrNull(it) == EXR[it] }
        val what = if (isExr) "is an OpenEXR picture" else "is no Radiance picture: it does not begin with #?"
        fail(0, what, "save it as Radiance (.hdr), such as with ImageMagick: magick picture.exr picture.hdr")
    }

    /** Reads the height and the width. */
    private fun sides(): List<Int> {
        val start = at
        val words = line().split(' ')
        if (words.size != 4 || words[0] != "-Y" || words[2] != "+X") {
            fail(start, "has no size such as -Y 512 +X 1024", "save it with rows from the top")
        }
        return listOf(words[1], words[3]).map { word ->
            word.toIntOrNull()?.takeIf { it in 1..MOST_SIDE }
                ?: fail(start, "has a side of $word, at most $MOST_SIDE is possible", "scale it down")
        }
    }

    private fun line(): String {
        val start = at
        while (at < bytes.size && bytes[at] != LINE_END) {
            if (at - start == LONGEST) fail(start, "has a line of more than $LONGEST bytes", "save it again")
            at++
        }
        if (at == bytes.size) cutShort()
        return String(bytes, start, at++ - start, Charsets.ISO_8859_1).trimEnd('\r')
    }

    /** Reads a row of pixels, each the codes of red, green, blue and the exponent, from the highest byte down. */
    private fun readRow(row: IntArray) {
        val isPacked = row.size in LEAST_PACKED..MOST_PACKED && at + 4 <= bytes.size && byte(at) == 2 &&
            byte(at + 1) == 2 && byte(at + 2) < 128
        if (!isPacked) return readOldRow(row)
        if (byte(at + 2) shl 8 or byte(at + 3) != row.size) damaged()
        at += 4
        row.fill(0)
        for (shift in 24 downTo 0 step 8) readChannel(row, shift)
    }

    private fun readChannel(row: IntArray, shift: Int) {
        var x = 0
        while (x < row.size) {
            val code = next()
            val count = if (code > 128) code - 128 else code
            if (count == 0 || count > row.size - x) damaged()
            val repeated = if (code > 128) next() else -1
            repeat(count) { row[x++] += (if (repeated < 0) next() else repeated) shl shift }
        }
    }

    /** Reads pixels one by one; those with the mantissas 1, 1, 1 say how often the last one is repeated. */
    private fun readOldRow(row: IntArray) {
        var x = 0
        var shift = 0
        while (x < row.size) {
            val pixel = next() shl 24 or (next() shl 16) or (next() shl 8) or next()
            if (pixel ushr 8 != REPEATED) {
                row[x++] = pixel
                shift = 0
                continue
            }
            val count = if (shift > 24) 0L else (pixel and 0xFF).toLong() shl shift
            if (x == 0 || count > row.size - x) damaged()
            row.fill(row[x - 1], x, x + count.toInt())
            x += count.toInt()
            shift += 8
        }
    }

    /** Adds the light of a pixel. */
    private fun add(pixel: Int, rgb: FloatArray, to: Int) {
        val exponent = pixel and 0xFF
        if (exponent == 0) return
        val unit = Math.scalb(1f, exponent - BIAS)
        var isTooBright = false
        for (channel in 0 until 3) {
            val light = unit * (pixel ushr 24 - 8 * channel and 0xFF)
            isTooBright = isTooBright || light > EnvironmentMap.MOST
            rgb[to + channel] += minOf(light, EnvironmentMap.MOST)
        }
        if (isTooBright) tooBright++
    }

    private fun next(): Int = if (at < bytes.size) byte(at++) else cutShort()

    private fun byte(index: Int) = bytes[index].toInt() and 0xFF

    private fun cutShort(): Nothing = fail(bytes.size, "ends too early", "copy it again")

    private fun damaged(): Nothing = fail(at, "is damaged: no such number of pixels can follow", "copy it again")

    private fun fail(at: Int, problem: String, remedy: String): Nothing = source.fail("byte $at", problem, remedy)

    companion object {
        private val MARK = "#?".toByteArray()
        private val EXR = byteArrayOf(0x76, 0x2F, 0x31, 0x01)
        private const val LINE_END = '\n'.code.toByte()
        private const val LONGEST = 2048
        private const val MOST_SIDE = 1 shl 16
        private const val MOST_COLUMNS = 2048
        private const val MOST_PART = 64
        private const val LEAST_PACKED = 8
        private const val MOST_PACKED = 0x7FFF
        private const val REPEATED = 0x010101

        /** Of the exponent, with the 8 bits of the mantissa. */
        private const val BIAS = 136

        /** Maps that were computed last, by the SHA-256 of what their files have in them. */
        private val kept = LinkedHashMap<ByteBuffer, SoftReference<EnvironmentMap>>()
        private const val MOST_KEPT = 4

        /** Returns the map of the picture in the file [path], and passes warnings to [warn]. */
        fun read(path: Path, limits: LoadLimits, options: RenderOptions, warn: (String) -> Unit): EnvironmentMap {
            val source = Source.ofFile(path, limits)
            source.requireContent()
            return read(source, options).also { source.warnings.forEach(warn) }
        }

        /** Returns the map of the picture in [source]. Another file with the same bytes gives the same map. */
        fun read(source: Source, options: RenderOptions): EnvironmentMap {
            val key = ByteBuffer.wrap(MessageDigest.getInstance("SHA-256").digest(source.bytes))
            synchronized(kept) { kept[key]?.get() }?.let { return it }
            val map = RadianceImage(source).map(options)
            synchronized(kept) {
                if (source.warnings.isEmpty()) kept[key] = SoftReference(map)
                if (kept.size > MOST_KEPT) kept.remove(kept.keys.first())
            }
            return map
        }
    }
}
