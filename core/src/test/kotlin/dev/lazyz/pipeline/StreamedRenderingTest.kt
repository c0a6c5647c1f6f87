package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FramePart
import dev.lazyz.FrameParts
import dev.lazyz.Image
import dev.lazyz.Reach
import dev.lazyz.SampleScenes
import dev.lazyz.Workers
import dev.lazyz.strategies.tiled.TiledRenderer
import java.lang.ref.WeakReference
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Streamed frames: bands of rows, parts that are not read, and failures. */
class StreamedRenderingTest {
    private val frame = SampleScenes.mixed(Random(5)).frame(40, 37).asOpaque()
    private val reads = AtomicInteger()

    /** The primitives of [frame] in parts of three. */
    private fun parts(knowsReach: Boolean, fail: Int = -1): FrameParts {
        val pieces = frame.primitives.chunked(3)
        return FrameParts(frame.primitives.size, hasTranslucency = false) {
            pieces.withIndex().map { (number, piece) ->
                val reach = Reach(
                    piece.minOf { it.columnStart }, piece.minOf { it.rowStart },
                    piece.maxOf { it.columnEnd }, piece.maxOf { it.rowEnd },
                )
                FramePart(3 * number, piece.size, reach.takeIf { knowsReach }) {
                    reads.incrementAndGet()
                    check(number != fail) { "broken part" }
                    FrameContent.of(piece)
                }
            }.iterator()
        }
    }

    private fun render(parts: FrameParts, mostBytes: Long, workers: Workers = Workers.ALL): Image {
        val collector = Image.Collector(frame.region)
        val rendering =
            StreamedRendering(frame, parts, workers, mostBytes) { part, sink -> TiledRenderer().render(part, sink) }
        val counters: Counters = rendering.run(collector)
        return collector.toImage(counters)
    }

    @Test
    fun partsAreForgottenAlsoIfTheExecutorRunsNoTask() {
        val live = ArrayList<WeakReference<FrameContent>>()
        var most = 0
        val pieces = frame.primitives.chunked(1).take(12)
        val parts = FrameParts(pieces.size, hasTranslucency = false) {
            pieces.withIndex().map { (number, piece) ->
                FramePart(number, 1, null) {
                    System.gc()
                    most = maxOf(most, live.count { it.get() != null })
                    FrameContent.of(piece).also { live += WeakReference(it) }
                }
            }.iterator()
        }
        render(parts, Long.MAX_VALUE, Workers(2) { })
        assertEquals(12, live.size)
        assertTrue(most <= 2) { "$most parts are in memory while another one is made" }
    }

    @Test
    fun bandsOfAnyHeightGiveTheSamePicture() {
        val expected = TiledRenderer().render(frame)
        for (rows in listOf(0, 1, 2, 36, 37, 38)) {
            for (knowsReach in listOf(true, false)) {
                val image = render(parts(knowsReach), 12L * 40 * rows)
                assertEquals(expected.pixelHash(), image.pixelHash(), "$rows rows")
                assertEquals(expected.counters.primitives, image.counters.primitives)
            }
        }
    }

    @Test
    fun eachPartIsReadOnceForAPictureThatFits() {
        for (workers in listOf(Workers.ALL, Workers(1, Workers.ALL.executor))) {
            reads.set(0)
            render(parts(knowsReach = false), Long.MAX_VALUE, workers)
            assertEquals(frame.primitives.chunked(3).size, reads.get())
        }
    }

    @Test
    fun theFailureOfAPartReachesTheCaller() {
        for (fail in listOf(0, 1, 3)) {
            val thrown = assertThrows(IllegalStateException::class.java) {
                render(parts(knowsReach = false, fail), Long.MAX_VALUE)
            }
            assertEquals("broken part", thrown.message)
        }
    }

    @Test
    fun aFrameWithoutPrimitivesShowsTheBackground() {
        val empty = FrameParts(0, hasTranslucency = false) { emptyList<FramePart>().iterator() }
        assertEquals(
            TiledRenderer().render(Frame(frame.raster, emptyList())).pixelHash(),
            render(empty, 1000).pixelHash(),
        )
    }
}
