package dev.lazyz.scenes.interrupts

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource

/**
 * Whatever a file repeats, reading it ends soon after an interrupt. By default one input is read, with
 * `-Dlazyz.effort=rest` each fifth of all, also part by part, with `full` all.
 */
class InterruptedReadingTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest
    @MethodSource("inputs")
    internal fun readingEndsWithin100MillisecondsOfProcessorTime(input: LongInput) {
        val bytes = input.bytes()
        assertEnds { Scenes.load(bytes, input.format, "a", OPTIONS) }
    }

    @ParameterizedTest
    @MethodSource("streamed")
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    internal fun readingPartByPartEndsWithin100MillisecondsOfProcessorTime(input: LongInput) {
        val bytes = input.bytes()
        assertEnds { Scenes.stream(bytes.inputStream(), input.format, "a", LIMITS, folder).close() }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun computingNormalsEndsWithin100MillisecondsOfProcessorTime() {
        val facets = 200_000
        val bytes = ByteBuffer.allocate(84 + 50 * facets).order(ByteOrder.LITTLE_ENDIAN).putInt(80, facets)
        bytes.position(84)
        for (i in 0 until facets) {
            val numbers = FloatArray(12) { (31 * i + it) * it % 1009f }
            numbers.forEach(bytes::putFloat)
            bytes.putShort(0)
        }
        assertEnds { Scenes.load(bytes.array(), SceneFormat.STL, "a", LoadOptions(LIMITS)) }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun timeOfAHeaderIsProportionalToItsLength() {
        fun header(elements: Int) = LongInputs.text(
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n",
            "end_header\n0 0 0\n", bytes = elements * BYTES_AN_ELEMENT,
        ) { "element e$it 0\n" }

        fun time(elements: Int): Long {
            val bytes = header(elements)
            val reading = WatchedReading { Scenes.load(bytes, SceneFormat.PLY, "a", OPTIONS) }
            assertNull(reading.thrown)
            return reading.total
        }
        time(20_000)
        val short = (1..3).minOf { time(5_000) }
        val long = (1..3).minOf { time(40_000) }
        assertTrue(long < 4 * 8 * short, "8 times the elements take ${long.toDouble() / short} times as long")
    }

    private fun assertEnds(read: () -> Unit) {
        val whole = WatchedReading(read = read)
        val error = whole.thrown
        assertTrue(error == null || error is SceneFormatException, "$error")
        assertTrue(whole.longest <= MOST, "${whole.longest} ns without a look, until ${whole.place}")
        val interrupted = WatchedReading(whole.looks / 2, read)
        assertTrue("the thread is interrupted" in interrupted.thrown?.message.orEmpty(), "${interrupted.thrown}")
        assertTrue(interrupted.longest <= MOST, "${interrupted.longest} ns until ${interrupted.place}")
    }

    private companion object {
        const val MOST = 100_000_000L
        const val BYTES_AN_ELEMENT = 17
        val LIMITS = LoadLimits(items = Long.MAX_VALUE)
        val OPTIONS = LoadOptions(LIMITS, smoothNormals = false)

        @JvmStatic
        fun inputs(): List<LongInput> = chosen(LongInputs.all)

        /** Before times are measured, the classes of readers are loaded. */
        @JvmStatic
        @BeforeAll
        fun loadClasses() {
            val gltf = """{"asset": {"version": "2.0"}, "nodes": [{}]}""".toByteArray()
            Scenes.load(gltf, SceneFormat.GLTF, "a", OPTIONS)
        }

        @JvmStatic
        fun streamed(): List<LongInput> = chosen(LongInputs.all.filter { it.isStreamed })

        private fun chosen(all: List<LongInput>): List<LongInput> = when (System.getProperty("lazyz.effort")) {
            null -> all.take(1)
            "rest" -> all.filterIndexed { index, _ -> index % 5 == 0 }
            else -> all
        }
    }
}
