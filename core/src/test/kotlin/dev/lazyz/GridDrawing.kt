package dev.lazyz

import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Shader
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import net.jqwik.api.Tuple

/** A position on the 1/256 pixel grid. */
data class GridPoint(val x: Int, val y: Int) {
    val pixelX: Double get() = x / 256.0
    val pixelY: Double get() = y / 256.0

    /**
     * Side of the line from [a] to [b] on which this point is: positive to the right on the screen, 0 on the line.
     * Exact.
     */
    fun side(a: GridPoint, b: GridPoint): Long = Math.subtractExact(
        Math.multiplyExact((b.x - a.x).toLong(), (y - a.y).toLong()),
        Math.multiplyExact((b.y - a.y).toLong(), (x - a.x).toLong()),
    )
}

/** Contours on a small raster, and their coverage as defined by the contract: the oracle of the coverage tests. */
data class GridDrawing(val width: Int, val height: Int, val contours: List<List<GridPoint>>) {
    val raster: Raster get() = Raster(width, height)

    /** Sum of the windings at or left of a sample (contract rules 2.1 to 2.4), for each edge, in exact integers. */
    fun windings(x: Int, y: Int): Int {
        val sample = GridPoint(256 * x + 128, 256 * y + 128)
        var sum = 0
        for (contour in contours) {
            for ((i, to) in contour.withIndex()) {
                val from = contour[(i + contour.size - 1) % contour.size]
                if (from.y <= sample.y && sample.y < to.y && sample.side(from, to) <= 0) sum++
                if (to.y <= sample.y && sample.y < from.y && sample.side(to, from) <= 0) sum--
            }
        }
        return sum
    }

    fun expected(rule: FillRule): SampleSet = SampleSet.where(width, height) { x, y ->
        if (rule == FillRule.EVEN_ODD) windings(x, y) % 2 != 0 else windings(x, y) != 0
    }

    fun primitive(rule: FillRule): Primitive {
        val triples = contours.map { contour ->
            contour.flatMap { listOf(it.pixelX, it.pixelY, 0.5) }.toDoubleArray()
        }
        val shader = Shader { it.setColor(1f, 0f, 0f) }
        return FrameBuilder(raster).polygon(shader, rule, *triples.toTypedArray()).build().primitives.single()
    }

    fun samples(rule: FillRule): SampleSet = primitive(rule).samples(raster)

    fun moved(columns: Int, rows: Int): GridDrawing =
        copy(contours = contours.map { it.map { p -> GridPoint(p.x + 256 * columns, p.y + 256 * rows) } })

    companion object {
        private const val LIMIT = 1 shl 27

        /**
         * Edge cases: on samples, on pixel corners, one step beside them, outside the raster, and at the limits of the
         * guard band.
         */
        fun coordinates(size: Int): Arbitrary<Int> {
            val pixels = Arbitraries.integers().between(-1, size)
            return Arbitraries.frequencyOf(
                Tuple.of(4, pixels.map { 256 * it + 128 }),
                Tuple.of(3, pixels.map { 256 * it }),
                Tuple.of(1, pixels.map { 256 * it + 127 }),
                Tuple.of(1, pixels.map { 256 * it + 129 }),
                Tuple.of(6, Arbitraries.integers().between(-300, 256 * size + 300)),
                Tuple.of(1, Arbitraries.integers().between(-LIMIT, LIMIT)),
                Tuple.of(1, Arbitraries.of(-LIMIT, LIMIT, LIMIT - 1)),
            )
        }

        fun points(width: Int, height: Int): Arbitrary<GridPoint> =
            Combinators.combine(coordinates(width), coordinates(height)).`as`(::GridPoint)

        /** Rasters of 1 x 1, one row, one column, and several samples on each side. */
        fun sizes(): Arbitrary<Pair<Int, Int>> = Combinators.combine(
            Arbitraries.of(1, 2, 5, 9, 16),
            Arbitraries.of(1, 2, 5, 9, 16),
        ).`as` { width, height -> Pair(width, height) }

        /** One to three contours of up to [vertices] vertices each, which can overlap and self-intersect. */
        fun any(vertices: Int = 7): Arbitrary<GridDrawing> = sizes().flatMap { (width, height) ->
            points(width, height).list().ofMinSize(1).ofMaxSize(vertices)
                .list().ofMinSize(1).ofMaxSize(3)
                .map { GridDrawing(width, height, it) }
        }

        /** Three vertices at arbitrary positions. */
        fun triangles(): Arbitrary<GridDrawing> = sizes().flatMap { (width, height) ->
            points(width, height).list().ofSize(3).map { GridDrawing(width, height, listOf(it)) }
        }
    }
}
