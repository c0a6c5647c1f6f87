package dev.lazyz.conformance

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.Region
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Pictures are compared bit for bit, and differences are reported. */
class PictureAssertionsTest {
    private fun image(region: Region, counters: Counters = Counters.NONE, depth: (Int) -> Int = { 7 }): Image {
        val size = region.size.toInt()
        return Image(region, IntArray(size) { -1 }, IntArray(size, depth), IntArray(size) { 0 }, counters)
    }

    private fun message(expected: Image, actual: Image) =
        assertThrows(AssertionError::class.java) { assertSamePicture(expected, actual) }.message

    @Test
    fun equalPicturesPassWhateverTheyCost() {
        val counters = Counters.Builder().apply { shadingCalls = 9 }.build()
        assertSamePicture(image(Region(1, 2, 4, 4)), image(Region(1, 2, 4, 4), counters))
    }

    @Test
    fun firstSampleThatDiffersIsNamedWithBothAnswers() {
        val region = Region(1, 2, 4, 4)
        assertEquals(
            "the pictures differ: sample (3, 2) is the first of 2 that differ\n" +
                "    expected #ffffffff, depth 7, primitive 0\n" +
                "    but was  #ffffffff, depth 8, primitive 0",
            message(image(region), image(region) { if (it == 2 || it == 4) 8 else 7 }),
        )
    }

    @Test
    fun otherRegionsAreReported() {
        assertEquals(
            "the pictures differ: expected 3 x 2 samples from column 1, row 2 on, " +
                "but was 2 x 3 samples from column 0, row 0 on",
            message(image(Region(1, 2, 4, 4)), image(Region(0, 0, 2, 3))),
        )
    }
}
