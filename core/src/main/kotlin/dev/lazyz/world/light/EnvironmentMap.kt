package dev.lazyz.world.light

import dev.lazyz.Checkpoint
import dev.lazyz.RenderOptions
import kotlin.math.abs

/**
 * A picture of the surroundings of a scene, as an [Environment] needs it: the light of each direction, and the same
 * blurred for surfaces of each roughness (contract rule 6.17).
 *
 * The picture has the whole turn from left to right, and all heights from the zenith above to the nadir below. Its
 * middle is the direction z, toward the viewer who looks at the front of a model; what is right of it in the picture is
 * at its right when one looks there. `Scenes.environment` reads one from a file.
 *
 * Immutable and thread safe. The same bits for every number of threads and on every machine.
 *
 * @property width columns of the picture
 * @property height rows of the picture
 */
public class EnvironmentMap private constructor(
    public val width: Int,
    public val height: Int,
    private val levels: Array<Octahedron>,
    private val irradiance: Irradiance,
) {
    /** The light of the picture; the middle of the picture is the direction z. */
    internal val light: Surroundings = object : Surroundings {
        override fun radiance(x: Float, y: Float, z: Float, roughness: Float, out: FloatArray, at: Int) {
            out.fill(0f, at, at + 3)
            val sum = abs(x) + abs(y) + abs(z)
            var p = x / sum
            var q = z / sum
            if (y < 0f) {
                val folded = if (p < 0f) abs(q) - 1f else 1f - abs(q)
                q = if (q < 0f) abs(p) - 1f else 1f - abs(p)
                p = folded
            }
            val place = place(roughness)
            val level = minOf(place.toInt(), levels.size - 2)
            val part = place - level
            levels[level].add(p, q, 1f - part, out, at)
            if (part > 0f) levels[level + 1].add(p, q, part, out, at)
        }

        override fun irradiance(x: Float, y: Float, z: Float, out: FloatArray, at: Int) =
            irradiance.at(x, y, z, out, at)
    }

    override fun toString(): String = "EnvironmentMap($width x $height)"

    public companion object {
        /** The most light of a texel. */
        public const val MOST: Float = 1e9f

        /** Sides of the levels after the first, see [roughness]. */
        private val SIDES = intArrayOf(256, 256, 160, 128, 128, 96, 64, 32, 32)
        private const val MOST_SIDE = 2048
        private const val LEAST_SIDE = 16

        /** Returns how many bytes of memory [of] takes for a picture of [width] x [height] texels, besides these. */
        @JvmStatic
        public fun memory(width: Int, height: Int): Long {
            val rows = LightTree.rows(height)
            return LightTree.bytes(rows) + (SIDES.map { minOf(it, rows) } + side(width)).sumOf(Octahedron::bytes)
        }

        /**
         * Returns the perceptual roughness of a [level] from 1 on, 0.089 to 1. A lobe is narrow and bright by the
         * fourth power of the roughness, so narrow lobes are closer together: a small sun between two levels is at most
         * 1.22 times too bright.
         */
        private fun roughness(level: Int): Double = (level + 2.5) / (43.0 - 3.5 * level)

        /** The roughness of the first level that is blurred. */
        private const val FINEST = 3.5f / 39.5f

        /** Returns the level of a perceptual [roughness], with the part of the way to the next. */
        private fun place(roughness: Float): Float =
            if (roughness < FINEST) roughness / FINEST else (43f * roughness - 2.5f) / (1f + 3.5f * roughness)

        /** The first level has as many texels a radian as the picture, where they are the fewest. */
        private fun side(width: Int) = (0.75 * width).toInt().coerceIn(LEAST_SIDE, MOST_SIDE)

        /**
         * Computes the map of a picture. Cost: [memory]; two or three seconds of processor time.
         *
         * @param width columns of the picture, at least 1
         * @param height rows of the picture, at least 1
         * @param rgb red, green and blue of each texel, linear light from 0 to [MOST], row by row from the zenith down
         * @param options [RenderOptions.threads] and [RenderOptions.executor] are used, the others are not
         * @throws IllegalArgumentException if a side is below 1, or [rgb] has another size or other numbers
         */
        @JvmStatic
        @JvmOverloads
        @Throws(InterruptedException::class)
        public fun of(
            width: Int,
            height: Int,
            rgb: FloatArray,
            options: RenderOptions = RenderOptions(),
        ): EnvironmentMap {
            require(width >= 1 && height >= 1) { "sides must be at least 1: $width x $height" }
            require(rgb.size.toLong() == 3L * width * height) {
                "$width x $height texels need three numbers each: ${rgb.size}"
            }
            val wrong = rgb.indexOfFirst { !(it >= 0f && it <= MOST) }
            require(wrong < 0) { "light must be from 0 to $MOST: ${rgb[wrong]}, of texel ${wrong / 3}" }
            val panorama = Panorama(width, height, rgb)
            val tree = LightTree(panorama)
            val sharp = filled(side(width), options) { panorama::read }
            val blurred = SIDES.mapIndexed { i, most ->
                val roughness = roughness(i + 1)
                filled(minOf(most, tree.rows), options) { tree.Lobe(roughness * roughness)::read }
            }
            return EnvironmentMap(width, height, (listOf(sharp) + blurred).toTypedArray(), tree.irradiance())
        }

        /** Returns a level with the light that [reader] makes a function for: each row is read by one of its own. */
        private fun filled(
            side: Int,
            options: RenderOptions,
            reader: () -> (x: Double, y: Double, z: Double, out: DoubleArray) -> Unit,
        ): Octahedron {
            val level = Octahedron(side)
            options.workers.forEach(side, Checkpoint.CALLER) { row, _ -> level.fill(row, reader()) }
            return level.also { it.close() }
        }
    }
}

/**
 * Light by direction on a square: an octahedron around the centre, unfolded so that its upper half is the inner square
 * and its corners are the lowest point. Three numbers for each texel, with a border of one texel, which continues
 * across the edges. T. Engelhardt and C. Dachsbacher, "Octahedron Environment Maps", VMV 2008.
 */
internal class Octahedron(private val side: Int) {
    private val stride = side + 2

    /** Row by row, with the border. */
    val numbers: FloatArray = FloatArray(3 * stride * stride)

    /** Sets the texels of a row to what [read] stores for their directions. */
    fun fill(row: Int, read: (x: Double, y: Double, z: Double, out: DoubleArray) -> Unit) {
        val light = DoubleArray(3)
        val q = (2.0 * row + 1.0) / side - 1.0
        for (column in 0 until side) {
            val p = (2.0 * column + 1.0) / side - 1.0
            val y = 1.0 - abs(p) - abs(q)
            val x = if (y < 0.0) StrictMath.copySign(1.0 - abs(q), p) else p
            val z = if (y < 0.0) StrictMath.copySign(1.0 - abs(p), q) else q
            val length = StrictMath.sqrt(x * x + y * y + z * z)
            read(x / length, y / length, z / length, light)
            for (channel in 0 until 3) numbers[at(column, row) + channel] = light[channel].toFloat()
        }
    }

    /** Sets the border, after all rows: beyond an edge is the same edge, mirrored at its middle. */
    fun close() {
        for (i in 0 until side) {
            copy(side - 1 - i, 0, i, -1)
            copy(side - 1 - i, side - 1, i, side)
            copy(0, side - 1 - i, -1, i)
            copy(side - 1, side - 1 - i, side, i)
        }
        val ends = listOf(-1 to side - 1, side to 0)
        for ((column, fromColumn) in ends) {
            for ((row, fromRow) in ends) copy(fromColumn, fromRow, column, row)
        }
    }

    private fun copy(fromColumn: Int, fromRow: Int, column: Int, row: Int) {
        val from = at(fromColumn, fromRow)
        numbers.copyInto(numbers, at(column, row), from, from + 3)
    }

    private fun at(column: Int, row: Int) = 3 * ((row + 1) * stride + column + 1)

    /** Adds [weight] times the light at ([p], [q]) on the square, each in -1..1, interpolated bilinearly, to [out]. */
    fun add(p: Float, q: Float, weight: Float, out: FloatArray, at: Int) {
        val u = (p + 1f) * (0.5f * side) + 0.5f
        val v = (q + 1f) * (0.5f * side) + 0.5f
        val column = u.toInt()
        val row = v.toInt()
        val right = u - column
        val below = v - row
        val upper = 3 * (row * stride + column)
        val lower = upper + 3 * stride
        for (channel in 0 until 3) {
            val first = numbers[upper + channel] * (1f - right) + numbers[upper + 3 + channel] * right
            val second = numbers[lower + channel] * (1f - right) + numbers[lower + 3 + channel] * right
            out[at + channel] += weight * (first * (1f - below) + second * below)
        }
    }

    companion object {
        /** Returns the bytes of memory of one with so many texels a side. */
        fun bytes(side: Int): Long = 4L * 3 * (side + 2) * (side + 2)
    }
}
