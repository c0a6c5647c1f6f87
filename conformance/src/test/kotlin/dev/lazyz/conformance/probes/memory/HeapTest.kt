package dev.lazyz.conformance.probes.memory

import dev.lazyz.conformance.ChildJvm
import java.util.concurrent.TimeUnit
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.TestFactory

/** Rules that measure the heap report when the garbage collector does not permit that. */
class HeapTest {
    @TestFactory
    fun collectorsThatCountRegionsAreNotMeasured(): List<DynamicTest> = mapOf(
        "G1" to "exact",
        "Serial" to "exact",
        "Parallel" to "exact",
        "Z" to "not exact",
        "Shenandoah" to "not exact",
    ).map { (collector, expected) ->
        dynamicTest(collector) {
            val process = ChildJvm.start(listOf("-Xmx512m", "-XX:+Use${collector}GC"), AskTheHeap::class)
            assertTrue(process.waitFor(60, TimeUnit.SECONDS))
            val answer = process.inputStream.reader().readText()
            assumeTrue(process.exitValue() == 0, "this JVM has no such collector: $answer")
            assertEquals(expected, answer.trim())
        }
    }
}

/** Prints whether the heap of this process is measured exactly. */
internal object AskTheHeap {
    @JvmStatic
    fun main(args: Array<String>): Unit = println(if (Heap.isExact()) "exact" else "not exact")
}
