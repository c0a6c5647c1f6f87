package dev.lazyz.world.light

import kotlin.math.abs

/** A picture of all directions, see [EnvironmentMap]. Interpolates bilinearly. Immutable and thread safe. */
internal class Panorama(val width: Int, val height: Int, private val rgb: FloatArray) {
    /** Stores the light in the direction of the unit vector (x, y, z). */
    fun read(x: Double, y: Double, z: Double, out: DoubleArray) {
        val turn = StrictMath.atan2(-x, z) / (2.0 * StrictMath.PI)
        readAt(0.5 + turn, StrictMath.acos(y.coerceIn(-1.0, 1.0)) / StrictMath.PI, out)
    }

    /** Stores the light at (u, v) in 0..1: u from left to right, v from the zenith down. */
    fun readAt(u: Double, v: Double, out: DoubleArray) {
        val x = u * width - 0.5
        val y = (v * height - 0.5).coerceIn(0.0, height - 1.0)
        val column = StrictMath.floor(x).toInt()
        val row = minOf(y.toInt(), maxOf(height - 2, 0))
        val right = x - column
        val below = y - row
        val left = Math.floorMod(column, width)
        val next = Math.floorMod(column + 1, width)
        val lower = minOf(row + 1, height - 1)
        for (channel in 0 until 3) {
            out[channel] = (texel(left, row, channel) * (1.0 - right) + texel(next, row, channel) * right) *
                (1.0 - below) + (texel(left, lower, channel) * (1.0 - right) + texel(next, lower, channel) * right) *
                below
        }
    }

    private fun texel(column: Int, row: Int, channel: Int) = rgb[3 * (row * width + column) + channel].toDouble()
}

/**
 * The light of a [Panorama] as a tree of rectangles of directions, by which its blur is computed without a random
 * sample: what is far from the middle of a lobe is added by large rectangles, what is near by small ones. Each one
 * is a point at the mean of its directions, weighted by their light, so a sun has no other place or strength for being
 * part of a larger one. J. Barnes and P. Hut, "A Hierarchical O(N log N) Force-Calculation Algorithm", Nature 324
 * (1986). Immutable and thread safe.
 */
internal class LightTree(panorama: Panorama) {
    /** Rows of the smallest rectangles, a power of two; there are twice as many columns. */
    val rows: Int = rows(panorama.height)

    /** [STRIDE] numbers for each rectangle, of all levels; the first has a row of two. */
    private val levels: Array<FloatArray> =
        Array(Integer.numberOfTrailingZeros(rows) + 1) { FloatArray(STRIDE * (2 shl 2 * it)) }

    /** The square of half of the diagonal of the rectangles in each row. */
    private val extents: Array<DoubleArray> = Array(levels.size) { level ->
        val count = 1 shl level
        DoubleArray(count) { row ->
            val half = StrictMath.PI / count / 2.0
            val nearest = if (2 * row < count) row + 1 else row
            val widest = if (count == 1) 1.0 else StrictMath.sin(StrictMath.PI * nearest / count)
            half * half * (1.0 + widest * widest)
        }
    }

    init {
        sumUp(panorama)
        for (level in levels.size - 2 downTo 0) merge(level)
        for (level in levels) for (node in level.indices step STRIDE) toUnit(level, node)
    }

    /** Adds the texels of [panorama], or parts of them where they are large, to the smallest rectangles. */
    private fun sumUp(panorama: Panorama) {
        val parts = maxOf(1, (rows + panorama.height - 1) / panorama.height)
        val height = parts * panorama.height
        val width = maxOf(1, (2 * rows + panorama.width - 1) / panorama.width) * panorama.width
        val light = DoubleArray(3)
        val nodes = levels.last()
        val columns = DoubleArray(2 * width) {
            val angle = 2.0 * StrictMath.PI * ((it / 2 + 0.5) / width - 0.5)
            if (it % 2 == 0) -StrictMath.sin(angle) else StrictMath.cos(angle)
        }
        for (row in 0 until height) {
            val polar = StrictMath.PI * (row + 0.5) / height
            val y = StrictMath.cos(polar)
            val level = StrictMath.sin(polar)
            val solid = 4.0 * StrictMath.PI / width * StrictMath.sin(StrictMath.PI / height / 2.0) * level
            for (column in 0 until width) {
                panorama.readAt((column + 0.5) / width, (row + 0.5) / height, light)
                val cell = (row.toLong() * rows / height * 2 * rows + column.toLong() * 2 * rows / width).toInt()
                val node = STRIDE * cell
                nodes[node] += solid.toFloat()
                for (channel in 0 until 3) nodes[node + LIGHT + channel] += (solid * light[channel]).toFloat()
                val weight = solid * (light[0] + light[1] + light[2] + DARK)
                nodes[node + TOWARD] += (weight * level * columns[2 * column]).toFloat()
                nodes[node + TOWARD + 1] += (weight * y).toFloat()
                nodes[node + TOWARD + 2] += (weight * level * columns[2 * column + 1]).toFloat()
            }
        }
    }

    private fun merge(level: Int) {
        val from = levels[level + 1]
        val to = levels[level]
        val columns = 2 shl level
        for (node in 0 until (columns shl level)) {
            val first = 4 * (node / columns) * columns + 2 * (node % columns)
            for (k in 0 until STRIDE) {
                val upper = from[STRIDE * first + k] + from[STRIDE * (first + 1) + k]
                val second = first + 2 * columns
                to[STRIDE * node + k] = upper + (from[STRIDE * second + k] + from[STRIDE * (second + 1) + k])
            }
        }
    }

    private fun toUnit(nodes: FloatArray, node: Int) {
        val x = nodes[node + TOWARD].toDouble()
        val y = nodes[node + TOWARD + 1].toDouble()
        val z = nodes[node + TOWARD + 2].toDouble()
        val length = StrictMath.sqrt(x * x + y * y + z * z)
        if (length > 0.0) for (axis in TOWARD until STRIDE) nodes[node + axis] = (nodes[node + axis] / length).toFloat()
    }

    /** Returns the light on matt surfaces. */
    fun irradiance(): Irradiance {
        val sums = Irradiance()
        val nodes = levels.last()
        var all = 0.0
        for (node in nodes.indices step STRIDE) {
            val (x, y, z) = List(3) { nodes[node + TOWARD + it].toDouble() }
            sums.add(x, y, z, 1.0) { nodes[node + LIGHT + it].toDouble() }
            all += nodes[node]
        }
        sums.finish(all)
        return sums
    }

    /**
     * The mean light around a direction that microfacets of the width [alpha] reflect, with the weight of its cosine:
     * seen along the normal, as usual for the first factor of the split sum. B. Karis, "Real Shading in Unreal Engine
     * 4", SIGGRAPH 2013. Not thread safe.
     */
    inner class Lobe(alpha: Double) {
        private val square = alpha * alpha
        private var rx = 0.0
        private var ry = 0.0
        private var rz = 0.0
        private var all = 0.0
        private val sums = DoubleArray(3)

        /** Stores the light around the unit vector (x, y, z). */
        fun read(x: Double, y: Double, z: Double, out: DoubleArray) {
            rx = x
            ry = y
            rz = z
            all = 0.0
            sums.fill(0.0)
            for (column in 0 until 2) visit(0, 0, column)
            for (channel in 0 until 3) out[channel] = sums[channel] / all
        }

        private fun visit(level: Int, row: Int, column: Int) {
            val nodes = levels[level]
            val at = STRIDE * ((2 shl level) * row + column)
            if (nodes[at] == 0f) return
            val cosine = rx * nodes[at + TOWARD] + ry * nodes[at + TOWARD + 1] + rz * nodes[at + TOWARD + 2]
            val extent = extents[level][row]
            if (cosine < 0.0 && cosine * cosine > 4.0 * extent) return
            if (level < levels.size - 1 && extent > NEAR * (2.0 - 2.0 * cosine + 2.0 * square)) {
                for (child in 0 until 4) visit(level + 1, 2 * row + child / 2, 2 * column + child % 2)
                return
            }
            if (!(cosine > 0.0)) return

            // The normal is in the middle between the light and the viewer
            val facing = 0.5 + 0.5 * cosine
            val width = square * facing + abs(1.0 - facing)
            val weight = cosine / (width * width)
            all += weight * nodes[at]
            for (channel in 0 until 3) sums[channel] += weight * nodes[at + LIGHT + channel]
        }
    }

    companion object {
        /** Returns the [LightTree.rows] for a picture of so many rows. */
        fun rows(height: Int): Int = Integer.highestOneBit((FINE * height).coerceIn(LEAST_ROWS, MOST_ROWS).toInt())

        /** Returns the bytes of memory of a tree with so many [rows]. */
        fun bytes(rows: Int): Long = 4L * STRIDE * 2 * rows * rows * 4 / 3

        /** Of a rectangle: its solid angle; its light times that; the unit vector of its mean direction. */
        private const val STRIDE = 7
        private const val LIGHT = 1
        private const val TOWARD = 4

        private const val MOST_ROWS = 256L
        private const val LEAST_ROWS = 32L
        private const val FINE = 4L

        /** The light that black directions count as. */
        private const val DARK = 1e-6

        /** A rectangle is a point if the square of its half diagonal is at most this part of that of its distance. */
        private const val NEAR = 0.06
    }
}
