package dev.lazyz.scenes.text

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

class EditDistanceTest {
    @ParameterizedTest
    @CsvSource(
        "'', '', 0", "'', city, 4", "city, city, 0", "city, cty, 1", "city, cityy, 1", "city, cite, 1", "city, ctiy, 1",
        "lights, lihgts, 1", "abcd, badc, 2", "kitten, sitting, 3", "city, CITY, 4", "teapot, bunny, 6",
        // No letter is edited twice: without that rule, 2
        "ca, abc, 3",
    )
    fun editsAreCounted(a: String, b: String, edits: Int) {
        assertEquals(edits, EditDistance.between(a, b))
        assertEquals(edits, EditDistance.between(b, a))
    }
}
