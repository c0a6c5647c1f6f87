package dev.lazyz.strategies.tiled

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.setup.FrameBuilder
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class TiledRendererTest {
    private fun tiled(threads: Int, tileSize: Int = 16) = TiledRenderer(Coherence.DIRECT, threads, tileSize)

    /** [count] layers over the whole raster; the nearest is first, and lacks its lower right [corner]. */
    private fun layers(count: Int, corner: Int = 0): Frame {
        val builder = FrameBuilder(Raster(100, 50))
        for (i in 0 until count) {
            val z = 0.1 + 0.8 * i / count
            val cut = if (i == 0) corner.toDouble() else 0.0
            builder.polygon(
                Rgba(i / count.toFloat(), 0f, 1f),
                doubleArrayOf(
                    0.0, 0.0, z, 100.0, 0.0, z, 100.0, 50 - cut, z, 100 - cut, 50 - cut, z, 100 - cut, 50.0, z,
                    0.0, 50.0, z,
                ),
            )
        }
        return builder.build()
    }

    @Test
    fun whatIsBehindAFullTileIsRejected() {
        for (threads in listOf(1, 3)) {
            val image = tiled(threads).render(layers(100))
            assertEquals(5000, image.counters.fragments)
            assertEquals(5000, image.counters.depthEvaluations)
            assertEquals(5000, image.counters.shadingCalls)
        }
    }

    @Test
    fun aRowIsScannedOnceForAllTiles() {
        for (threads in listOf(1, 4)) {
            val wide = Probe(Region(3, 5, 97, 49))
            val narrow = Probe(Region(17, 2, 30, 50))
            tiled(threads).render(Frame(Raster(100, 50), listOf(wide, narrow)))
            assertEquals((5 until 49).toList(), wide.rows.sorted())
            assertEquals((2 until 50).toList(), narrow.rows.sorted())
        }
    }

    @Test
    fun memoryDoesNotGrowWithTheRows() {
        for (threads in listOf(1, 2)) {
            val few = peakBytes(1000, threads)
            assertEquals(few, peakBytes(16_000, threads))
            assertTrue(few < 12L * 64 * 1000) { "$few bytes are the picture's" }
        }
    }

    private fun peakBytes(rows: Int, threads: Int): Long {
        val probe = Probe(Region(0, 0, 64, rows))
        return tiled(threads).render(Frame(Raster(64, rows), listOf(probe)), NOWHERE).peakBytes
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aPrimitiveOfManyTilesTakesOneEntryABand() {
        // 10,000 primitives in 2,000 tiles would take 20 million entries, 80 megabytes
        val frame = Frame(Raster(2000, 1), List(10_000) { Probe(Region(0, 0, 2000, 1)) })
        val bytes = tiled(1, tileSize = 1).render(frame, NOWHERE).peakBytes
        assertTrue(bytes < 10_000L * 300) { "$bytes" }
    }

    private companion object {
        val NOWHERE = RowSink { _, _, _, _ -> }
    }
}
