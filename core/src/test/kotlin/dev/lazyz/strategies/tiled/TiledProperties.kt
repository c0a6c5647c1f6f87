package dev.lazyz.strategies.tiled

import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.strategies.tiled.binning.ArrayPool
import dev.lazyz.strategies.tiled.binning.Arrivals
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.zbuffer.ZBuffer
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rules 5, 7 and 8, for any size of tiles and number of threads. */
class TiledProperties {
    @Property(tries = 150, seed = "1989", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_thePictureIsTheZBuffersForAnyTilesAndThreads(@ForAll seed: Long) {
        val frame = TileFrames(seed).next()
        val expected = ZBuffer().render(frame)
        for (tileSize in SIZES) {
            val alone = Tiled(Coherence.DIRECT, 1, tileSize).render(frame)
            assertEquals(expected, alone) { "TileFrames($seed).next(), tileSize $tileSize" }
            assertTrue(alone.counters.depthEvaluations <= alone.counters.fragments)
            assertEquals(expected.counters.primitives, alone.counters.primitives)
            assertTrue(alone.counters.fragments <= expected.counters.fragments)
            assertTrue(alone.counters.depthPasses in alone.visible..alone.counters.fragments)
            assertEquals(alone.visible.toLong(), alone.counters.shadingCalls)
            val threads = THREADS[Math.floorMod(seed + tileSize, THREADS.size)]
            val image = Tiled(Coherence.DIRECT, threads, tileSize).render(frame)
            assertEquals(expected, image) { "TileFrames($seed).next(), tileSize $tileSize, $threads threads" }
            assertEquals(work(alone.counters), work(image.counters))
        }
    }

    @Property(tries = 150, seed = "1994", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_5_coherenceChangesNothing(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = TileFrames(seed).next()
        val expected = ZBuffer().render(frame)
        for (tileSize in listOf(8, 64)) {
            val alone = Tiled(coherence, 1, tileSize).render(frame)
            val together = Tiled(coherence, 3, tileSize).render(frame)
            assertEquals(expected, alone) { "TileFrames($seed).next(), tileSize $tileSize, $coherence" }
            assertEquals(expected, together) { "TileFrames($seed).next(), tileSize $tileSize, $coherence" }
            assertEquals(work(alone.counters), work(together.counters))
            assertEquals(alone.visible.toLong(), alone.counters.shadingCalls)
        }
    }

    @Property(tries = 300, seed = "2008", edgeCases = EdgeCasesMode.NONE)
    fun aBinHoldsWhatMayCoverTheTileInSubmissionOrder(@ForAll seed: Long) {
        val frame = TileFrames(seed).next()
        for (tileSize in SIZES) {
            val grid = TileGrid(frame.region, tileSize)
            val arrivals = Arrivals(frame, grid)
            val band = Band(frame, grid, ArrayPool())
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
                    assertEquals(expected, bin) { "TileFrames($seed).next(), tile $column of band $number" }
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
