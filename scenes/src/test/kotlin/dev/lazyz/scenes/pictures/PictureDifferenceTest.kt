package dev.lazyz.scenes.pictures

import dev.lazyz.Region
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Differences are counted, located and shown. */
class PictureDifferenceTest {
    private val grey = 0xFF808080.toInt()

    /** Eight by five grey pixels, but for [changes]: colours by column and row. */
    private fun picture(vararg changes: Pair<Pair<Int, Int>, Int>): Picture {
        val argb = IntArray(40) { grey }
        for ((place, color) in changes) argb[place.second * 8 + place.first] = color
        return Picture.ofArgb(8, 5, argb)
    }

    private fun difference(actual: Picture, threshold: Double = 0.0) =
        PictureDifference.between(picture(), actual, threshold)

    @Test
    fun equalPicturesAreIdentical() {
        val difference = difference(picture())
        assertTrue(difference.isIdentical && difference.isMatch)
        assertEquals("all 40 pixels are the same", difference.summary)
        assertNull(difference.first)
        assertNull(difference.bounds)
        assertTrue(
            difference.toImage().argb.all {
                it == 0xFFDFDFDF.toInt()
            }
        ) { difference.toImage().argb[0].toString(16) }
    }

    @Test
    fun changesAreCountedAndLocated() {
        val actual = picture((5 to 1) to 0xFF808180.toInt(), (2 to 3) to 0xFF808080.toInt() - 0x30)
        val difference = difference(actual)
        assertFalse(difference.isMatch)
        assertEquals(2, difference.differingPixels)
        assertEquals(48.0, difference.largest)
        assertEquals(49.0 / 160, difference.mean)
        assertEquals(Region(2, 1, 6, 4), difference.bounds)
        assertEquals("column 5, row 1: expected #808080ff, but was #808180ff", "${difference.first}")
        assertEquals(
            "2 of 40 pixels differ, within columns 2 to 5, rows 1 to 3\n" +
                "first at column 5, row 1: expected #808080ff, but was #808180ff\n" +
                "largest difference of a channel: 48 of 255; mean: 0.306",
            difference.summary,
        )
    }

    @Test
    fun theThresholdIsTheGreatestDifferenceThatIsAccepted() {
        val actual = picture((5 to 1) to 0xFF828080.toInt(), (2 to 3) to 0xFF808480.toInt())
        assertEquals(2, difference(actual, 1.99).differingPixels)
        val some = difference(actual, 2.0)
        assertEquals(1, some.differingPixels)
        assertEquals(Region(2, 3, 3, 4), some.bounds)
        assertEquals(4.0, some.largest)
        assertTrue(some.summary.startsWith("1 of 40 pixels differ by more than 2, "), some.summary)
        val none = difference(actual, 4.0)
        assertTrue(none.isMatch)
        assertFalse(none.isIdentical)
        assertEquals(
            "no pixel differs by more than 4\nlargest difference of a channel: 4 of 255; mean: 0.0375", none.summary,
        )
        for (wrong in listOf(-1.0, 255.5, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) { difference(actual, wrong) }
        }
    }

    @Test
    fun otherSizesAreDifferent() {
        val actual = Picture.ofArgb(5, 8, IntArray(40) { grey })
        val difference = difference(actual, 255.0)
        assertFalse(difference.isMatch || difference.isIdentical || difference.isSameSize)
        assertEquals("the sizes differ: expected 8x5, but was 5x8", difference.summary)
        val image = difference.toImage()
        assertEquals("8x8", "${image.width}x${image.height}")
        assertEquals(0xFFDFDFDF.toInt(), image.argb(4, 4))
        for ((x, y) in listOf(5 to 4, 4 to 5, 7 to 7)) assertEquals(0xFF4060FF.toInt(), image.argb(x, y))
    }

    @Test
    fun thePictureOfADifferenceMarksIt() {
        val actual = picture((5 to 1) to 0xFF808180.toInt(), (2 to 3) to 0x00808080)
        val image = difference(actual).toImage()
        assertEquals(0xFFFFCF00.toInt(), image.argb(5, 1))
        assertEquals(0xFFFF0000.toInt(), image.argb(2, 3))
        assertEquals(38, image.argb.count { it == 0xFFDFDFDF.toInt() })
        assertEquals(39, difference(actual, 1.0).toImage().argb.count { it == 0xFFDFDFDF.toInt() })
    }
}
