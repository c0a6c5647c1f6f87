package dev.lazyz.setup

import dev.lazyz.Fraction
import dev.lazyz.GridPoint
import java.util.Random

/** Triangles at arbitrary positions in the guard band around a sample of a large raster; many are slivers. */
object GuardBandTriangles {
    private const val LIMIT = 1 shl 27

    /** Returns three vertices whose triangle contains the sample of [column] and [row], edges included; or null. */
    fun around(random: Random, column: Int, row: Int): List<GridPoint>? {
        val sample = GridPoint(256 * column + 128, 256 * row + 128)
        val triangle = if (random.nextBoolean()) sliver(random, sample) else fat(random, sample)
        if (triangle.any { Math.abs(it.x) > LIMIT || Math.abs(it.y) > LIMIT }) return null
        val (a, b, c) = triangle
        val coordinates = Fraction.barycentric(a, b, c, sample) ?: return null
        return if (coordinates.all { it.signum() >= 0 }) triangle else null
    }

    private fun fat(random: Random, sample: GridPoint): List<GridPoint> {
        val reach = 1 shl random.nextInt(28)
        return List(3) { GridPoint(sample.x + spread(random, reach), sample.y + spread(random, reach)) }
    }

    /** All three vertices within a few steps of one line through the sample. */
    private fun sliver(random: Random, sample: GridPoint): List<GridPoint> {
        val reach = 1 shl random.nextInt(28)
        val width = 1 shl random.nextInt(10)
        val dx = spread(random, reach)
        val dy = if (random.nextInt(4) == 0) 0 else spread(random, reach)
        return List(3) {
            val along = random.nextDouble() * 2.0 - 1.0
            GridPoint(
                sample.x + Math.rint(along * dx).toInt() + spread(random, width),
                sample.y + Math.rint(along * dy).toInt() + spread(random, width),
            )
        }
    }

    private fun spread(random: Random, reach: Int): Int = (random.nextDouble() * 2.0 * reach - reach).toInt()
}
