package dev.lazyz.scenes.writers

/**
 * Converts rows of colours to filtered rows of bytes, and back. For each row it chooses the filter that is likely to
 * compress best.
 *
 * It tries three of the five filters and takes the one with the smallest sum of absolute differences, as the
 * specification recommends. The sum of the Paeth filter is multiplied by 1.5: its differences are small but less
 * regular, so they compress worse than their sum suggests. The other two filters were best for so few rows of
 * rendered images that they are not worth their time.
 *
 * Source: PNG specification, sections 9 (filters) and 12.8 (filter selection).
 *
 * @param width number of columns
 * @param channels bytes of a pixel: 3 without alpha, 4 with
 */
internal class PngFilter(private val width: Int, private val channels: Int) {
    /** Number of bytes of a row, without the filter type. */
    private val size = width * channels

    // Each row is preceded by one pixel of zeros
    private var current = ByteArray(channels + size)
    private var above = ByteArray(channels + size)
    private val candidates = Array(FILTERS.size) { ByteArray(size) }

    /** Loads the next row, which begins at [offset] of [argb]. The previous row becomes the row above. */
    fun load(argb: IntArray, offset: Int) {
        advance()
        var i = channels
        for (x in offset until offset + width) {
            val color = argb[x]
            current[i++] = (color ushr 16).toByte()
            current[i++] = (color ushr 8).toByte()
            current[i++] = color.toByte()
            if (channels == 4) current[i++] = (color ushr 24).toByte()
        }
    }

    /** Writes the loaded row to [output] at [offset]: the filter type, then the differences. */
    fun writeBest(output: ByteArray, offset: Int) {
        var best = 0
        var least = Long.MAX_VALUE
        for (i in FILTERS.indices) {
            val differences = candidates[i]
            when (FILTERS[i]) {
                SUB -> sub(differences)
                UP -> up(differences)
                else -> paeth(differences)
            }
            val sum = magnitude(differences) * (if (FILTERS[i] == PAETH) 3 else 2)
            if (sum < least) {
                least = sum
                best = i
            }
        }
        output[offset] = FILTERS[best]
        System.arraycopy(candidates[best], 0, output, offset + 1, size)
    }

    private fun sub(differences: ByteArray) {
        for (i in 0 until size) differences[i] = (current[i + channels] - current[i]).toByte()
    }

    private fun up(differences: ByteArray) {
        for (i in 0 until size) differences[i] = (current[i + channels] - above[i + channels]).toByte()
    }

    private fun paeth(differences: ByteArray) {
        for (i in 0 until size) differences[i] = (current[i + channels] - nearest(i)).toByte()
    }

    /** Returns the neighbour of byte [i] (left, above, above left) that is closest to left + above - above left. */
    private fun nearest(i: Int): Int {
        val left = current[i].toInt() and 0xFF
        val up = above[i + channels].toInt() and 0xFF
        val corner = above[i].toInt() and 0xFF
        val toLeft = StrictMath.abs(up - corner)
        val toUp = StrictMath.abs(left - corner)
        val toCorner = StrictMath.abs(left + up - 2 * corner)
        return if (toLeft <= toUp && toLeft <= toCorner) {
            left
        } else if (toUp <= toCorner) {
            up
        } else {
            corner
        }
    }

    /**
     * Restores the next row from [filtered], as [writeBest] has written it, and unpacks it to [argb]. Returns false if
     * this is not possible, because the type of the filter is another one.
     */
    fun restore(filtered: ByteArray, argb: IntArray): Boolean {
        advance()
        val type = filtered[0]
        if (type !in FILTERS) return false
        for (i in 0 until size) {
            val predicted = when (type) {
                SUB -> current[i].toInt()
                UP -> above[i + channels].toInt()
                else -> nearest(i)
            }
            current[i + channels] = (filtered[i + 1] + predicted).toByte()
        }
        var i = channels
        for (x in 0 until width) {
            val rgb = byteAt(i) shl 16 or (byteAt(i + 1) shl 8) or byteAt(i + 2)
            argb[x] = rgb or ((if (channels == 4) byteAt(i + 3) else 0xFF) shl 24)
            i += channels
        }
        return true
    }

    private fun byteAt(i: Int): Int = current[i].toInt() and 0xFF

    /** The current row becomes the row above. */
    private fun advance() {
        val spare = above
        above = current
        current = spare
    }

    /** Sum of the absolute values of bytes, taken as signed. */
    private fun magnitude(differences: ByteArray): Long {
        var sum = 0L
        for (difference in differences) sum += StrictMath.abs(difference.toInt())
        return sum
    }

    private companion object {
        const val SUB: Byte = 1
        const val UP: Byte = 2
        const val PAETH: Byte = 4
        val FILTERS = byteArrayOf(SUB, UP, PAETH)
    }
}
