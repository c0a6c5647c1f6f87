package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.zbuffer.ZBuffer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EffortTest {
    private val rule = "rule_2_8_primitivesOfOnesOwnCoverWhatTheySay"

    @Test
    fun propertyMultipliesTheFrames() {
        assertEquals(200, frames(1.0).size)
        assertEquals(10, frames(0.05).size)
        assertEquals(500, frames(2.5).size)
        assertEquals(1, frames(0.0001).size)
    }

    @Test
    fun framesAreTheSameAtEveryRunUnlessTheSeedIsAnother() {
        val usual = frames(0.1)
        assertEquals(usual, frames(0.1))
        SuiteRun.withProperty(RendererConformance.SEED, "7") { assertNotEquals(usual, frames(0.1)) }
    }

    @Test
    fun effortThatIsNoPositiveNumberIsRefused() {
        for (factor in listOf(-1.0, 0.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { SuiteRun.ofRule(rule, factor) { ZBuffer() } }
        }
        SuiteRun.withProperty(RendererConformance.TRIES, "-1.0") {
            val refusal = assertThrows(IllegalArgumentException::class.java) { Conformance { ZBuffer() }.run() }
            val message = refusal.message.orEmpty()
            assertTrue("lazyz.conformance.tries must be a positive number: -1.0" in message, message)
        }
    }

    private fun frames(tries: Double): List<String> {
        val seen = ArrayList<String>()
        SuiteRun.ofRule(rule, tries) {
            BrokenRenderer("witness") { frame: Frame, sink ->
                seen.add("${frame.raster} ${frame.primitives}")
                ZBuffer().render(frame, sink)
            }
        }
        return seen
    }
}
