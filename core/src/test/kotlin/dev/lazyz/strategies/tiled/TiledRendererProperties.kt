package dev.lazyz.strategies.tiled

import dev.lazyz.Counters
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.strategies.AwkwardFrames
import dev.lazyz.strategies.tiled.binning.ActivePrimitives
import dev.lazyz.strategies.tiled.binning.ArrayPool
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 5, 7 and 8, for any size of tiles and number of threads. */
class TiledRendererProperties {
    @Property(tries = 80, seed = "1989", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_thePictureIsTheZBuffersForAnyTilesAndThreads(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = AwkwardFrames(seed).frame()
        val expected = ZBufferRenderer().render(frame)
        for (tileSize in SIZES) {
            val what = "AwkwardFrames($seed).frame(), tileSize $tileSize, $coherence"
            val alone = TiledRenderer(coherence, 1, tileSize).render(frame)
            assertEquals(expected, alone) { what }
            assertTrue(alone.counters.depthEvaluations <= alone.counters.fragments) { what }
            assertTrue(alone.counters.fragments <= expected.counters.fragments) { what }
            assertTrue(alone.counters.depthPasses in alone.visible..alone.counters.fragments) { what }
            val threads = THREADS[Math.floorMod(seed + tileSize, THREADS.size)]
            val image = TiledRenderer(coherence, threads, tileSize).render(frame)
            assertEquals(expected, image) { "$what, $threads threads" }
            assertEquals(work(alone.counters), work(image.counters)) { "$what, $threads threads" }
        }
    }

    @Property(tries = 100, seed = "2008", edgeCases = EdgeCasesMode.NONE)
    fun aBinHoldsWhatMayCoverTheTileInSubmissionOrder(@ForAll seed: Long) {
        val frame = AwkwardFrames(seed).frame()
        for (tileSize in SIZES) {
            val grid = TileGrid(frame.region, tileSize)
            val arrivals = ActivePrimitives(frame, grid)
            val band = Band(frame, grid, ArrayPool(), side = 1)
            for (number in 0 until grid.bands) {
                arrivals.moveTo(number)
                band.fill(number, arrivals, null)
                for (column in 0 until grid.columns) {
                    val expected = frame.primitives.indices.filter {
                        val primitive = frame.primitives[it]
                        primitive.rowStart < minOf(grid.rowEnd(number), primitive.rowEnd) &&
                            primitive.rowEnd > grid.rowStart(number) &&
                            primitive.columnStart < minOf(grid.columnEnd(column), primitive.columnEnd) &&
                            primitive.columnEnd > grid.columnStart(column)
                    }
                    val bin = ArrayList<Int>()
                    band.forEachMember(column) { bin += band.single(it) }
                    assertEquals(expected, bin) { "AwkwardFrames($seed).frame(), tile $column of band $number" }
                }
            }
        }
    }

    /** All counters except the one that depends on the number of threads. */
    private fun work(counters: Counters): String = counters.toBuilder().apply { peakBytes = 0 }.toString()

    private companion object {
        val SIZES = listOf(1, 2, 8, 16, 64, 1024)
        val THREADS = listOf(2, 3, 8)
    }
}
