package dev.lazyz.filter

import dev.lazyz.Raster
import dev.lazyz.spi.Srgb
import java.math.BigDecimal
import java.math.BigInteger
import java.math.MathContext
import java.util.Random
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows

class BoxPyramidTest {
    @Test
    fun eachPixelIsTheMeanOfThePixelsThatItCovers() {
        for ((width, height) in listOf(1 to 1, 2 to 1, 1 to 3, 5 to 7, 16 to 16, 17 to 33, 100 to 9)) {
            val picture = picture(width, height)
            val levels = levels(width, height) { y -> picture[y] }
            assertEquals(BoxPyramid.levels(width, height), levels.size)
            assertEquals(1, levels.last().single().size)
            for ((level, rows) in levels.withIndex()) {
                assertEquals(BoxPyramid.side(height, level), rows.size)
                for ((y, row) in rows.withIndex()) {
                    val expected = IntArray(BoxPyramid.side(width, level)) { mean(picture, level, it, y) }
                    assertArrayEquals(expected, row, "$width x $height, level $level, row $y")
                }
            }
        }
    }

    @Test
    fun levelsAreNotMadeOfRoundedPixels() {
        // The light of a quarter of the pixels rounds to code 1, and that of a sixteenth to 0
        val lit = 0xFF000003.toInt()
        val black = 0xFF000000.toInt()
        val picture = Array(4) { y -> IntArray(4) { x -> if (x == 0 && y == 0) lit else black } }
        val levels = levels(4, 4) { picture[it] }
        assertEquals(0xFF000001.toInt(), levels[1][0][0])
        assertEquals(black, levels[2][0][0])

        // Three of four pixels of level 1 round up, so the mean of rounded pixels is too bright
        val dim = Array(4) { IntArray(4) { x -> if (x % 2 == 0) 0xFF000001.toInt() else black } }
        val means = levels(4, 4) { dim[it] }
        assertEquals(means[1][0][0], means[2][0][0])
    }

    @Test
    fun theLargestPicturesDoNotOverflow() {
        // Levels 16 to 18 keep fewer bits
        val width = Raster.MAX_SIDE
        val white = IntArray(width) { -1 }
        val grey = IntArray(width) { 0xFF808080.toInt() }
        val height = 3
        for ((level, rows) in levels(width, height) { if (it < 2) white else grey }.withIndex().drop(2)) {
            val expected = listOf(0xFF, 0xFF, 0x80).map { Srgb.decode(it / 255.0) }.average()
            val code = Srgb.encode(expected.toFloat())
            for (row in rows) assertEquals(setOf(0xFF000000.toInt() or code * 0x10101), row.toSet(), "level $level")
        }
    }

    @Test
    fun mistakesAreReported() {
        val pyramid = BoxPyramid(4, 1) { _, _, _ -> }
        assertThrows<IllegalArgumentException> { pyramid.add(IntArray(3)) }
        pyramid.add(IntArray(4))
        assertThrows<IllegalArgumentException> { pyramid.add(IntArray(4)) }
        assertThrows<IllegalArgumentException> { BoxPyramid(0, 1) { _, _, _ -> } }
    }

    private fun picture(width: Int, height: Int): Array<IntArray> {
        val random = Random(1)
        return Array(height) {
            IntArray(width) {
                val color = random.nextInt()
                when (random.nextInt(4)) {
                    0 -> color and 0xFFFFFF
                    1 -> color or (0xFF shl 24)
                    else -> color
                }
            }
        }
    }

    private fun levels(width: Int, height: Int, row: (Int) -> IntArray): List<List<IntArray>> {
        val levels = List(BoxPyramid.levels(width, height)) { ArrayList<IntArray>() }
        val pyramid = BoxPyramid(width, height) { level, y, argb ->
            assertEquals(levels[level].size, y)
            levels[level].add(argb.copyOf(BoxPyramid.side(width, level)))
        }
        repeat(height) { pyramid.add(row(it)) }
        return levels
    }

    /** The mean as a sum of exact numbers over the pixels of the picture. */
    private fun mean(picture: Array<IntArray>, level: Int, x: Int, y: Int): Int {
        val covered = ArrayList<Int>()
        for (row in (y shl level) until minOf((y + 1) shl level, picture.size)) {
            for (column in (x shl level) until minOf((x + 1) shl level, picture[row].size)) {
                covered.add(picture[row][column])
            }
        }
        val alpha = covered.sumOf { it ushr 24 }
        if (alpha == 0) return picture[y shl level][x shl level] and 0xFFFFFF
        val opacity = (2 * alpha + covered.size) / (2 * covered.size)
        return opacity shl 24 or (code(covered, 16, alpha) shl 16) or (code(covered, 8, alpha) shl 8) or
            code(covered, 0, alpha)
    }

    private fun code(covered: List<Int>, shift: Int, alpha: Int): Int {
        var sum = BigInteger.ZERO
        for (color in covered) {
            val light = Math.round(Srgb.decode((color shr shift and 0xFF) / 255.0) * (1 shl 24))
            sum += BigInteger.valueOf(light) * BigInteger.valueOf((color ushr 24).toLong())
        }
        val mean = BigDecimal(sum).divide(BigDecimal(alpha).multiply(BigDecimal(1 shl 24)), MathContext.DECIMAL128)
        return Srgb.encode(mean.toFloat())
    }
}
