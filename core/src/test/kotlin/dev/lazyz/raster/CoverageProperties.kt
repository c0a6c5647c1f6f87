package dev.lazyz.raster

import dev.lazyz.GridDrawing
import dev.lazyz.GridPoint
import dev.lazyz.SampleSet
import dev.lazyz.geometry.FillRule
import dev.lazyz.samples
import dev.lazyz.samplesByCursor
import java.util.Random
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals

/** Contract rules 1.3 and 2.1 to 2.5: coverage of polygons. */
class CoverageProperties {
    @Provide
    fun drawings(): Arbitrary<GridDrawing> = GridDrawing.any()

    @Provide
    fun triangles(): Arbitrary<GridDrawing> = GridDrawing.triangles()

    @Provide
    fun rules(): Arbitrary<FillRule> = Arbitraries.of(FillRule::class.java)

    @Property(seed = "1995", tries = 500, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_2_trianglesFollowTheTopLeftRule(@ForAll("triangles") drawing: GridDrawing) {
        val (a, b, c) = drawing.contours.single()
        val area = c.side(a, b)
        val corners = if (area < 0) listOf(a, c, b) else listOf(a, b, c)
        val expected = SampleSet.where(drawing.width, drawing.height) { x, y ->
            val sample = GridPoint(256 * x + 128, 256 * y + 128)
            area != 0L && (0 until 3).all { owns(corners[it], corners[(it + 1) % 3], sample) }
        }
        assertEquals(expected, drawing.samples(FillRule.NON_ZERO))
        assertEquals(expected, drawing.samples(FillRule.EVEN_ODD))
    }

    /** Edge function with the classic tie rule: a clockwise triangle owns its top edges and its left edges. */
    private fun owns(from: GridPoint, to: GridPoint, sample: GridPoint): Boolean {
        val side = sample.side(from, to)
        val isTop = from.y == to.y && to.x > from.x
        val isLeft = to.y < from.y
        return side > 0 || (side == 0L && (isTop || isLeft))
    }

    @Property(seed = "1995", tries = 300, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_2_sharedEdgesCoverEachSampleOnce(
        @ForAll random: Random,
        @ForAll @IntRange(min = 1, max = 5) cells: Int,
        @ForAll @IntRange(min = 0, max = 400) jitter: Int,
    ) {
        // A mesh of the whole raster whose inner vertices are moved at random, so that triangles can be folded over
        val size = 12
        val columns = IntArray(cells + 1) { -256 + it * (256 * size + 512) / cells }
        val points = List(cells + 1) { row ->
            List(cells + 1) { column ->
                val isInner = row in 1 until cells && column in 1 until cells
                val around = if (isInner) jitter else 0
                GridPoint(moved(columns[column], around, random), moved(columns[row], around, random))
            }
        }
        val counts = IntArray(size * size)
        for (row in 0 until cells) {
            for (column in 0 until cells) {
                val a = points[row][column]
                val b = points[row][column + 1]
                val c = points[row + 1][column + 1]
                val d = points[row + 1][column]
                val flip = random.nextBoolean()
                addSigned(counts, size, if (flip) listOf(a, b, c) else listOf(a, b, d))
                addSigned(counts, size, if (flip) listOf(a, c, d) else listOf(b, c, d))
            }
        }
        for (y in 0 until size) for (x in 0 until size) assertEquals(1, counts[y * size + x]) { "sample $x, $y" }
    }

    /** Moves a vertex by up to [around] grid steps, sometimes onto a sample or a corner. */
    private fun moved(position: Int, around: Int, random: Random): Int {
        val moved = position + random.nextInt(2 * around + 1) - around
        return when {
            around == 0 -> moved
            random.nextInt(3) == 0 -> Math.floorDiv(moved, 256) * 256 + 128
            random.nextInt(3) == 0 -> Math.floorDiv(moved, 256) * 256
            else -> moved
        }
    }

    /** Adds the samples of a triangle; negatively if it is folded over. */
    private fun addSigned(counts: IntArray, size: Int, triangle: List<GridPoint>) {
        val sign = java.lang.Long.signum(triangle[2].side(triangle[0], triangle[1]))
        val samples = GridDrawing(size, size, listOf(triangle)).samples(FillRule.NON_ZERO)
        for (y in 0 until size) for (x in 0 until size) if (samples[x, y]) counts[y * size + x] += sign
    }

    @Property(seed = "1995", tries = 1500, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_3_cursorEqualsDirectEvaluation(
        @ForAll("drawings") drawing: GridDrawing,
        @ForAll("rules") rule: FillRule,
        @ForAll @IntRange(min = 0, max = 15) firstRow: Int,
    ) {
        val primitive = drawing.primitive(rule)
        val start = firstRow % drawing.height
        val direct = primitive.samples(drawing.raster)
        val expected = SampleSet.where(drawing.width, drawing.height) { x, y -> y >= start && direct[x, y] }
        assertEquals(expected, primitive.samplesByCursor(drawing.raster, start))
    }

    @Property(seed = "1995", tries = 500, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_4_windingsDecide(@ForAll("drawings") drawing: GridDrawing, @ForAll("rules") rule: FillRule) {
        assertEquals(drawing.expected(rule), drawing.samples(rule))
    }

    @Property(seed = "1995", tries = 300, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_5_aPolygonCoversWhatItsTrianglesCover(@ForAll random: Random, @ForAll isUpright: Boolean) {
        // Two chains of vertices, one above the other, with the same columns: concave, without crossings
        val size = 12
        val columns = IntArray(2 + random.nextInt(8)) { random.nextInt(256 * size + 512) - 256 }.distinct().sorted()
        if (columns.size < 2) return
        val upper = columns.map { GridPoint(it, moved(128 * size, 128 * size, random)) }
        val lower = upper.map { GridPoint(it.x, it.y + 1 + random.nextInt(256 * 6)) }
        val turn = { p: GridPoint -> if (isUpright) GridPoint(p.y, p.x) else p }
        val polygon = GridDrawing(size, size, listOf((upper + lower.reversed()).map(turn)))
        val counts = SampleSet(size, size)
        for (i in 0 until columns.size - 1) {
            val flip = random.nextBoolean()
            val first = listOf(upper[i], upper[i + 1], if (flip) lower[i] else lower[i + 1])
            val second = listOf(if (flip) upper[i + 1] else upper[i], lower[i + 1], lower[i])
            for (triangle in listOf(first, second)) {
                val samples = GridDrawing(size, size, listOf(triangle.map(turn))).samples(FillRule.NON_ZERO)
                for (y in 0 until size) {
                    for (x in 0 until size) {
                        if (!samples[x, y]) continue
                        assertEquals(false, counts[x, y]) { "sample $x, $y is covered twice" }
                        counts[x, y] = true
                    }
                }
            }
        }
        assertEquals(counts, polygon.samples(FillRule.EVEN_ODD))
        assertEquals(counts, polygon.samples(FillRule.NON_ZERO))
    }
}
