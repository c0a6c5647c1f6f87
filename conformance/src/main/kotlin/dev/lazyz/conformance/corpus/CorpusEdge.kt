package dev.lazyz.conformance.corpus

/** A straight part of an outline, downward. */
internal class CorpusEdge private constructor(val x0: Long, val y0: Long, val x1: Long, val y1: Long) {
    val isHorizontal: Boolean get() = y0 == y1

    val isCoarse: Boolean get() = !isFar && listOf(x0, y0, x1, y1).all { it % 16 == 0L }

    /** Whether an end is far from the raster. */
    val isFar: Boolean get() = listOf(x0, y0, x1, y1).any { it !in -FAR_OFF..FAR_OFF }

    /** Whether a point is on the edge, and not an end. */
    fun isThrough(x: Long, y: Long): Boolean =
        if (isHorizontal) y == y0 && x > minOf(x0, x1) && x < maxOf(x0, x1) else y > y0 && y < y1 && side(x, y) == 0

    /** Whether floats of 24 bits find a point on the other side. */
    fun isMissedByFloats(x: Long, y: Long): Boolean {
        val left = (x - x0).toFloat() * (y1 - y0).toFloat()
        val right = (y - y0).toFloat() * (x1 - x0).toFloat()
        return y in y0 until y1 && (left >= right) != (side(x, y) >= 0)
    }

    /** Whether integers of 56 bits, which overflow, find a point on the other side. */
    fun isMissedByIntegers(x: Long, y: Long): Boolean {
        val left = (x - x0) * (y1 - y0) shl 8
        val right = (y - y0) * (x1 - x0) shl 8
        return y in y0 until y1 && (left >= right) != (side(x, y) >= 0)
    }

    private fun side(x: Long, y: Long): Int = ((x - x0) * (y1 - y0)).compareTo((y - y0) * (x1 - x0))

    /** Whether a point is less than a step away. */
    fun isNear(x: Double, y: Double): Boolean {
        val dx = (x1 - x0).toDouble()
        val dy = (y1 - y0).toDouble()
        val square = dx * dx + dy * dy
        val along = (x - x0) * dx + (y - y0) * dy
        val t = if (square > 0.0) (along / square).coerceIn(0.0, 1.0) else 0.0
        val right = x - x0 - t * dx
        val down = y - y0 - t * dy
        return right * right + down * down < 1.0
    }

    companion object {
        /** In grid steps: 64 pixels. */
        private const val FAR_OFF = 64L * 256

        /** Returns the sides of a closed contour through these corners. */
        fun around(corners: List<List<Long>>): List<CorpusEdge> = corners.indices.map {
            val (x0, y0) = corners[it]
            val (x1, y1) = corners[(it + 1) % corners.size]
            if (y0 <= y1) CorpusEdge(x0, y0, x1, y1) else CorpusEdge(x1, y1, x0, y0)
        }

        /** Returns the sides of the square around a point. */
        fun square(x: Long, y: Long, half: Long): List<CorpusEdge> = around(
            listOf(
                listOf(x - half, y - half), listOf(x + half, y - half), listOf(x + half, y + half),
                listOf(x - half, y + half),
            ),
        )
    }
}
