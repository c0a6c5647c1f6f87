package dev.lazyz.strategies.hybrid

import dev.lazyz.Depth
import dev.lazyz.Image.PixelHash
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.render
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.io.File
import java.util.concurrent.TimeUnit
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/**
 * Checks the budget with a heap that has little more room than the budget, in a separate virtual machine with 24
 * megabytes.
 */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class HybridHeapTest {
    @Test
    fun aBudgetKeepsAStreamOfLargePrimitivesWithinASmallHeap() {
        val result = HeapProbe.run("${4 shl 20}")
        assertEquals(0, result.exitCode, result.output)
        assertEquals(HeapProbe.render("zbuffer").substringBefore(' '), result.output.substringBefore(' '))
    }

    @Test
    fun withoutABudgetTheSameStreamDoesNotFit() {
        val result = HeapProbe.run("unlimited")
        assertTrue(result.exitCode != 0 && "OutOfMemoryError" in result.output) { result.output }
    }
}

/** Renders a stream of blocks that hold 16 kilobytes each: 64 megabytes a layer, 192 in total. */
internal object HeapProbe {
    private const val SIDE = 128
    private val raster = Raster(SIDE, SIDE)

    class Result(val exitCode: Int, val output: String)

    @JvmStatic
    fun main(args: Array<String>) {
        println(render(args[0]))
    }

    /**
     * Renders with a budget in bytes, `unlimited`, or with the `zbuffer`; returns the picture's hash and the counters.
     */
    fun render(mode: String): String = runBlocking {
        val hash = PixelHash()
        val counters = when (mode) {
            "zbuffer" -> ZBufferRenderer().render(raster, blocks()) { _, argb, _, _ -> hash.add(argb, SIDE) }
            else -> HybridRenderer(RenderOptions(memoryBudget = mode.toLongOrNull()))
                .render(raster, blocks()) { _, argb, _, _ -> hash.add(argb, SIDE) }
        }
        "${hash.digest()} $counters"
    }

    /** Runs [main] in a separate JVM with a heap of 24 megabytes. */
    fun run(mode: String): Result {
        val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
        val java = File(System.getProperty("java.home"), "bin/java").path
        val process = ProcessBuilder(
            java, "-Xmx24m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp", classPath,
            HeapProbe::class.java.name, mode,
        ).redirectErrorStream(true).start()
        val output = process.inputStream.bufferedReader().readText()
        check(process.waitFor(10, TimeUnit.MINUTES)) { "the child did not end: $output" }
        return Result(process.exitValue(), output)
    }

    private fun blocks(): Flow<Primitive> = flow {
        for (layer in 0 until 3) for (block in 0 until SIDE * SIDE / 4) emit(Block(layer, block))
    }

    private class Block(private val layer: Int, private val block: Int) : Primitive {
        private val payload = ByteArray(16 shl 10) { (it * 31 + block).toByte() }
        override val columnStart: Int = block % (SIDE / 2) * 2
        override val rowStart: Int = block / (SIDE / 2) * 2
        override val columnEnd: Int get() = columnStart + 2
        override val rowEnd: Int get() = rowStart + 2
        override val heldBytes: Long get() = payload.size + 64L
        override val depthForm: LinearForm get() = LinearForm.constant(Depth.FAR - layer)

        override fun spans(y: Int, spans: Spans) {
            if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
        }

        override fun depth(x: Int, y: Int): Int = Depth.FAR - layer

        override fun shade(fragment: Fragment) {
            fragment.setColor((payload[block] + 128) / 255f, layer / 3f, (payload[fragment.x] + 128) / 255f)
        }
    }
}
