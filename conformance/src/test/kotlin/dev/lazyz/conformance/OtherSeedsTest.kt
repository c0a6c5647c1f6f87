package dev.lazyz.conformance

import dev.lazyz.Renderers
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/** The suite on all built-in renderers with other frames; `-Dlazyz.seeds=20` for as many seeds as one likes. */
class OtherSeedsTest {
    @TestFactory
    fun passes(): List<DynamicTest> {
        val seeds = Integer.getInteger("lazyz.seeds", 0)
        val tries = if (seeds == 0) 0.1 else 1.0
        return (1..maxOf(seeds, 1)).flatMap { seed ->
            (Renderers.builtIn + ReferenceRenderer()).map { renderer ->
                dynamicTest("${renderer.id} at seed $seed") {
                    SuiteRun.withProperty(RendererConformance.SEED, "$seed") {
                        val run = SuiteRun.of(tries) { renderer }
                        val excused = if (renderer is ReferenceRenderer) setOf(LEFT_ALONE) else emptySet()
                        assertEquals(emptyMap<String, Throwable>(), run.failures - excused)
                        assertEquals(SuiteRun.rules, run.rules)
                    }
                }
            }
        }
    }

    private companion object {
        /** The oracle asks every primitive at every sample, and so does what it SHOULD not. */
        val LEFT_ALONE = RendererConformance::rule_7_7_whatIsOutsideTheRegionIsLeftAlone.name
    }
}
