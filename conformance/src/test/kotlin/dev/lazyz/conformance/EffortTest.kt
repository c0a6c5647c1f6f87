package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.zbuffer.ZBuffer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
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
        val failure = SuiteRun.ofRule(rule, tries = -1.0) { ZBuffer() }.failures.getValue(rule)
        assertTrue(failure.message.orEmpty().contains("lazyz.conformance.tries must be a positive number: -1.0"))
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
