package dev.lazyz.conformance.probes.memory

import dev.lazyz.conformance.ChildJvm
import dev.lazyz.conformance.TestEffort
import java.lang.ref.Reference
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread
import kotlin.reflect.KClass
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** What rules measure of the heap is what live objects take, with each collector. */
class HeapTest {
    @TestFactory
    fun liveObjectsAreCountedExactly(): List<DynamicTest> {
        val collectors = listOf("Serial", "G1", "Parallel", "Z").take(if (TestEffort.isDefault) 1 else 4)
        return collectors.map { dynamicTest(it) { assertEquals("exact", answer(it, AskTheHeap::class)) } }
    }

    /** Threads take memory from the heap in large pieces, which are not objects. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun buffersOfThreadsDoNotCount() {
        assertTrue(Heap.isExact())
        val isEnough = AtomicBoolean()
        val threads = List(4) {
            thread { while (!isEnough.get()) ByteArray(16) }
        }
        try {
            repeat(4) { assertEquals(0.0, Heap.most { it() }.total.toDouble(), 8.0 * 1024) }
        } finally {
            isEnough.set(true)
            threads.forEach { it.join() }
        }
    }

    /** What others release while something is measured must not hide what is held. */
    @Test
    fun releasedMemoryHidesNothing() {
        val released = AtomicReference(blocks())
        val held = Heap.most { measure ->
            released.set(emptyList())
            val kept = List(512) { IntArray(256) }
            measure()
            Reference.reachabilityFence(kept)
        }
        assertTrue(held.total >= 512 * 1024) { "$held" }
        assertTrue("in int[])" in "$held") { "$held" }
    }

    private fun blocks(): List<ByteArray> = List(512) { ByteArray(1024) }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun deadImagesDoNotCount() = assertEquals("1 1 1 1 1 1 1 1", answer("Serial", AskAfterDeadImages::class))

    private fun answer(collector: String, main: KClass<*>): String {
        val process = ChildJvm.start(listOf("-Xmx512m", "-XX:+Use${collector}GC"), main)
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "it hangs")
        val answer = process.inputStream.reader().readText()
        assumeTrue(process.exitValue() == 0, "this JVM has no such collector: $answer")
        return answer.trim()
    }
}

/** Prints how many images each round holds, as measured, while the image of the round before is dead. */
internal object AskAfterDeadImages {
    private const val ROUNDS = 8
    private const val IMAGE = 3 shl 20

    @JvmStatic
    fun main(args: Array<String>) {
        // Most collections leave a few per cent of the heap as it is, so there must be more
        val live = List(60) { ByteArray(1 shl 20) }
        val growth = (1..ROUNDS).map {
            Heap.most { measure ->
                val image = ByteArray(IMAGE)
                val after = ByteArray(1)
                measure()
                Reference.reachabilityFence(image)
                Reference.reachabilityFence(after)
            }
        }
        Reference.reachabilityFence(live)
        println(growth.joinToString(" ") { "${(it.total + IMAGE / 2) / IMAGE}" })
    }
}

/** Prints whether the heap of this process is measured exactly. */
internal object AskTheHeap {
    @JvmStatic
    fun main(args: Array<String>): Unit = println(if (Heap.isExact()) "exact" else "not exact")
}
