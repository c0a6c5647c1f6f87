package dev.lazyz.pipeline

import dev.lazyz.Checkpoint
import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions.Coherence
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ChainTest {
    private fun frame(rows: Int, vararg extents: IntRange): Frame =
        Frame(Raster(4, rows), extents.map { Witness(Region(0, it.first, 4, it.last + 1), Depth.NEAR) })

    /** The stages that each row of [frame] passes through, by index, and the bytes counted for each row. */
    private fun walk(frame: Frame): List<Pair<List<Int>, Long>> {
        val chain = Chain(frame, Coherence.DIRECT, Checkpoint.NONE, ::Stage)
        return (frame.region.rowStart until frame.region.rowEnd).map { y ->
            var row = chain.begin(y)
            val stages = List(chain.size) { chain[it].index }
            for (i in 0 until chain.size) row = chain[i].next(row)
            chain.end(row)
            Pair(stages, row.counters.peakBytes)
        }
    }

    @Test
    fun stagesStandInSubmissionOrderFromTheirFirstRowToTheirLast() {
        val stages = walk(frame(6, 2..3, 0..5, 1..2, 2..2, 1..1)).map { it.first }
        assertEquals(listOf(listOf(1), listOf(1, 2, 4), listOf(0, 1, 2, 3), listOf(0, 1), listOf(1), listOf(1)), stages)
    }

    @Test
    fun onlyRowsOfTheRegionCount() {
        val stages = walk(frame(9, 0..1, 0..8, 3..4, 7..8).within(Region(1, 2, 3, 7))).map { it.first }
        assertEquals(listOf(listOf(1), listOf(1, 2), listOf(1, 2), listOf(1), listOf(1)), stages)
    }

    @Test
    fun aStageHasLeftWhenItsLastRowIsDone() {
        val chain = Chain(frame(3, 0..0, 0..1), Coherence.DIRECT, Checkpoint.NONE, ::Stage)
        val row = chain.begin(0)
        assertEquals(2, chain.size)
        chain.end(row)
        assertEquals(1, chain.size)
        chain.end(chain.begin(1))
        assertEquals(0, chain.size)
    }

    @Test
    fun theRoomOfACrowdIsGivenBack() {
        val extents = Array(5_000) { 1..1 }
        val bytes = walk(frame(4, *extents)).map { it.second }
        assertEquals(bytes[0], bytes[3])
        assertTrue(bytes[1] > bytes[0] + 5_000 * 60) { "$bytes" }
    }
}
