package dev.lazyz.scenes.writers

/**
 * Turns rows of colours into filtered rows of bytes, choosing for each row the filter that should compress best.
 *
 * Source: PNG specification, sections 9 (filters) and 12.8 (how to choose).
 */
internal class PngFilter(private val width: Int, private val channels: Int) {
    private val size = width * channels
    private var current = ByteArray(size)
    private var above = ByteArray(size)
    private var candidate = ByteArray(size + 1)
    private var least = ByteArray(size + 1)

    /** Takes the next row; the one before becomes the row above. */
    fun load(argb: IntArray) {
        val spare = above
        above = current
        current = spare
        var i = 0
        for (x in 0 until width) {
            val color = argb[x]
            current[i++] = (color ushr 16).toByte()
            current[i++] = (color ushr 8).toByte()
            current[i++] = color.toByte()
            if (channels == 4) current[i++] = (color ushr 24).toByte()
        }
    }

    /** Returns the row with the filter's number in front; valid until the next call. */
    fun best(): ByteArray {
        var leastSum = Long.MAX_VALUE
        for (type in NONE..PAETH) {
            val sum = apply(type, leastSum)
            if (sum < leastSum) {
                leastSum = sum
                val spare = least
                least = candidate
                candidate = spare
            }
        }
        return least
    }

    /** Fills the candidate and returns the sum of its bytes' absolute values, taken as signed; gives up at [limit]. */
    private fun apply(type: Int, limit: Long): Long {
        candidate[0] = type.toByte()
        var sum = 0L
        for (i in 0 until size) {
            val a = if (i >= channels) current[i - channels].toInt() and 0xFF else 0
            val b = above[i].toInt() and 0xFF
            val predicted = when (type) {
                NONE -> 0
                SUB -> a
                UP -> b
                AVERAGE -> a + b shr 1
                else -> paeth(a, b, if (i >= channels) above[i - channels].toInt() and 0xFF else 0)
            }
            val difference = (current[i] - predicted).toByte()
            candidate[i + 1] = difference
            sum += if (difference < 0) -difference else difference.toInt()
            if (sum >= limit) break
        }
        return sum
    }

    /** The neighbour (left, above, above left) that is nearest to left + above - above left. */
    private fun paeth(left: Int, above: Int, aboveLeft: Int): Int {
        val estimate = left + above - aboveLeft
        val toLeft = StrictMath.abs(estimate - left)
        val toAbove = StrictMath.abs(estimate - above)
        val toAboveLeft = StrictMath.abs(estimate - aboveLeft)
        return when {
            toLeft <= toAbove && toLeft <= toAboveLeft -> left
            toAbove <= toAboveLeft -> above
            else -> aboveLeft
        }
    }

    private companion object {
        const val NONE = 0
        const val SUB = 1
        const val UP = 2
        const val AVERAGE = 3
        const val PAETH = 4
    }
}
