package dev.lazyz.conformance

import dev.lazyz.Renderers
import dev.lazyz.tiled.Tiled
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/**
 * The suite on built-in renderers with other frames: `-Dlazyz.seeds=20` tries all of them on as many seeds, the build `tiled` on
 * one, and a tenth of the frames.
 */
class OtherSeedsTest {
    @TestFactory
    fun passes(): List<DynamicTest> {
        val seeds = Integer.getInteger("lazyz.seeds", 0)
        val tries = if (seeds == 0) 0.1 else 1.0
        val renderers = if (seeds == 0) listOf(Tiled()) else Renderers.builtIn + ReferenceRenderer()
        return (1..maxOf(seeds, 1)).flatMap { seed ->
            renderers.map { renderer ->
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
