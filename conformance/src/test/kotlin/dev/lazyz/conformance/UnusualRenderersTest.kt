package dev.lazyz.conformance

import dev.lazyz.conformance.strangers.StrangersGallery
import dev.lazyz.conformance.strangers2.SecondGallery
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/**
 * Right renderers pass, however they work. `-Dlazyz.seeds=20` tries as many seeds, at the usual effort, on all of them and on the
 * right renderers of strangers; the build tries a few, on one seed and a tenth of the frames.
 */
class UnusualRenderersTest {
    private val seeds = System.getProperty("lazyz.seeds")?.toLong()

    @TestFactory
    fun passes(): List<DynamicTest> {
        val all = UnusualRenderers.all + StrangersGallery.correct + SecondGallery.correct
        val chosen = if (seeds == null) UnusualRenderers.quick else all
        return chosen.flatMap { make ->
            (1..(seeds ?: 1)).map { seed ->
                dynamicTest("${make().id}, seed $seed") {
                    val tries = if (seeds == null) 0.1 else 1.0
                    val report = Conformance { make() }.seed(seed).tries(tries).run()
                    assertTrue(report.isConformant) { report.toText() }
                }
            }
        }
    }
}
