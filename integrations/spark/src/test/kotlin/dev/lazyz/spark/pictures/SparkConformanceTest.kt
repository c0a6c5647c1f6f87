package dev.lazyz.spark.pictures

import dev.lazyz.conformance.Conformance
import dev.lazyz.spark.TestSpark
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The conformance suite on bands that are tasks; a rendering takes some 20 ms, so the default build tries few frames. */
class SparkConformanceTest {
    @Test
    fun sparkConforms() {
        val tries = if (System.getProperty("lazyz.effort") == null) 0.01 else 0.2
        val report = Conformance { SparkRenderer(TestSpark.session) }.tries(tries).run()
        assertTrue(report.isConformant) { report.toText() }
    }
}
