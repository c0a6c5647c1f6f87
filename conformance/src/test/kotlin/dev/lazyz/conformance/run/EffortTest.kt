package dev.lazyz.conformance.run

import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.RendererConformance
import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EffortTest {
    private val rule = "rule_2_8_customPrimitivesCoverTheirSpans"

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
    fun eachRuleHasFramesOfItsOwn() {
        val seeds = SuiteRule.all.map { it.seed(1995) }
        assertEquals(SuiteRule.all.size, seeds.toSet().size)
        assertTrue(SuiteRule.all.indices.none { seeds[it] == SuiteRule.all[it].seed(1996) })

        // Two rules with frames of the same generator
        val (nearest, index) = listOf(RuleNames.nearest, RuleNames.index).map { frames(0.2, it).toSet() }
        assertTrue((nearest intersect index).size < index.size / 2)
    }

    @Test
    fun seedOfARuleIsTheSameForEver() = assertEquals(SEED, SuiteRule.find(rule)!!.seed(1995))

    @Test
    fun effortThatIsNoPositiveNumberIsRefused() {
        for (factor in listOf(-1.0, 0.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { SuiteRun.ofRule(rule, factor) { ZBufferRenderer() } }
        }
        SuiteRun.withProperty(RendererConformance.TRIES, "-1.0") {
            val refusal = assertThrows(IllegalArgumentException::class.java) { Conformance { ZBufferRenderer() }.run() }
            val message = refusal.message.orEmpty()
            assertTrue("lazyz.conformance.tries must be a positive number: -1.0" in message, message)
        }
    }

    /** Overrides a rule. */
    internal class Lenient : RendererConformance() {
        override fun renderer(): Renderer = ZBufferRenderer()

        override fun rule_2_8_customPrimitivesCoverTheirSpans(case: FrameCase): Unit = Unit
    }

    @Test
    fun rulesAreNotToBeOverridden() {
        val refusal = assertThrows(IllegalStateException::class.java) { SuiteRun.of(Lenient::class, 0.01, rule) }
        assertTrue("Lenient overrides $rule" in refusal.message.orEmpty(), refusal.message)
    }

    private fun frames(tries: Double, rule: String = this.rule): List<String> {
        val seen = ArrayList<String>()
        SuiteRun.ofRule(rule, tries) {
            BrokenRenderer("witness") { frame: Frame, sink ->
                val image = ZBufferRenderer().render(frame)
                seen.add("${frame.raster} ${image.argb.contentHashCode()}")
                emit(image, sink)
            }
        }
        return seen
    }

    private companion object {
        /** Computed by hand, outside of the JVM. */
        const val SEED = -21259105296089987L
    }
}
