package dev.lazyz.scenes.writers

/**
 * Converts rows of colours to filtered rows of bytes, and back. For each row it chooses the filter that is likely to
 * compress better.
 *
 * It tries two of the five filters, the differences to the pixel on the left and to the one above, and takes the one
 * with the smaller sum of absolute differences, as the specification recommends. With the Paeth filter as well, files
 * of rendered images were larger: its differences are small but less regular.
 *
 * Source: PNG specification, sections 9 (filters) and 12.8 (filter selection).
 *
 * @param width number of columns
 * @param channels bytes of a pixel: 3 without alpha, 4 with
 */
internal class PngFilter(private val width: Int, private val channels: Int) {
    /** Number of bytes of a row, without the filter type. */
    private val size = width * channels

    /** Differences of the bytes of a row to those on the left, and to those above. */
    private val sub = ByteArray(size)
    private val up = ByteArray(size)

    /**
     * Writes the row that begins at [row] of [argb], after the row above it: the filter type, then the differences, to
     * [output] from [at] on, where it has zeros.
     */
    fun write(argb: IntArray, row: Int, output: ByteArray, at: Int) {
        // Most rows begin and end with the background. Its differences are zeros, except for those of the first pixel
        var from = 1
        var until = width
        while (from < until && isRepeated(argb, row + from)) from++
        while (until > from && isRepeated(argb, row + until - 1)) until--

        var more = subtract(argb[row], 0, argb[row - width], 0)
        for (x in from until until) {
            val i = row + x
            more += subtract(argb[i], argb[i - 1], argb[i - width], x * channels)
        }
        val isUp = more > 0
        output[at] = if (isUp) UP else SUB
        val differences = if (isUp) up else sub
        System.arraycopy(differences, 0, output, at + 1, channels)
        val begin = from * channels
        System.arraycopy(differences, begin, output, at + 1 + begin, until * channels - begin)
    }

    /** Whether the pixel at [i] has the colour of that on the left and of that above. */
    private fun isRepeated(argb: IntArray, i: Int): Boolean = argb[i] == argb[i - 1] && argb[i] == argb[i - width]

    /**
     * Stores both kinds of differences of a pixel, from number [at] on. Returns by how much those to the [left] are
     * greater.
     */
    private fun subtract(color: Int, left: Int, above: Int, at: Int): Long {
        var more = 0
        for (channel in 0 until channels) {
            val shift = SHIFTS[channel]
            val toLeft = ((color shr shift) - (left shr shift)).toByte()
            val toAbove = ((color shr shift) - (above shr shift)).toByte()
            sub[at + channel] = toLeft
            up[at + channel] = toAbove
            more += StrictMath.abs(toLeft.toInt()) - StrictMath.abs(toAbove.toInt())
        }
        return more.toLong()
    }

    /**
     * Restores the next row from [filtered], as [write] has written it, to [argb], which has the row above, or zeros.
     * Returns false if this is not possible, because the type of the filter is another one.
     */
    fun restore(filtered: ByteArray, argb: IntArray): Boolean {
        val type = filtered[0]
        if (type != SUB && type != UP) return false
        var i = 1
        for (x in 0 until width) {
            val near = when {
                type == UP -> argb[x]
                x > 0 -> argb[x - 1]
                else -> 0
            }
            var color = if (channels == 4) 0 else OPAQUE
            for (channel in 0 until channels) {
                val shift = SHIFTS[channel]
                color = color or (filtered[i++] + (near shr shift) and 0xFF shl shift)
            }
            argb[x] = color
        }
        return true
    }

    private companion object {
        const val SUB: Byte = 1
        const val UP: Byte = 2

        const val OPAQUE = 0xFF shl 24

        /** The places of red, green, blue and alpha in a colour. */
        val SHIFTS = intArrayOf(16, 8, 0, 24)
    }
}
