package dev.lazyz.strategies.hybrid

import dev.lazyz.Counters
import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.pipeline.Pane
import dev.lazyz.render
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.asFlow
import kotlinx.coroutines.flow.flow
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Checks the hybrid's promises with its counters. */
class HybridRendererTest {
    private val raster = Raster(40, 40)
    private val imageBytes = 12 * raster.size

    /** Four hundred tiles, and over them ten walls, each nearer than the one before. */
    private val mosaic: Frame = Frame(
        raster,
        List(400) { Pane(tile(it % 20 * 2, it / 20 * 2), Depth.FAR - it, Rgba.BLACK) } +
            List(10) { Pane(raster.region, Depth.FAR / 2 - it, Rgba.BLACK) },
    )

    private fun tile(column: Int, row: Int) = Region(column, row, column + 2, row + 2)

    @Test
    fun lessMemoryMeansMoreShadingAndNeverMoreThanTheBudget() {
        val eager = ZBufferRenderer().render(mosaic)
        val unlimited = HybridRenderer().render(mosaic).counters.peakBytes - imageBytes
        val extra = ArrayList<Long>()
        for (budget in listOf(0, unlimited / 10, unlimited / 3, unlimited - 1, unlimited)) {
            val image = render(mosaic, budget)
            assertEquals(eager, image)
            assertTrue(image.counters.peakBytes <= imageBytes + budget)
            extra.add(image.counters.shadingCalls - image.visible)
        }

        // From shading all fragments that pass, through shading some of the tiles early, to no extra shading
        assertEquals(10 * raster.size, extra[0])
        for (some in extra.subList(1, 4)) assertTrue(some in 1..2 * raster.size) { extra.toString() }
        assertEquals(0, extra[4])
    }

    @Test
    fun laterSuspensionsAreLazyAgainAfterForcing() {
        // There is room for a few tiles only: they are forced several times, and so is the first wall as its record
        // grows
        val image = render(mosaic, 2000)
        val calls = mosaic.primitives.map { (it as Pane).shadingCalls }
        assertTrue(calls.take(401).sum() > raster.size / 2) { calls.toString() }

        // Of the walls that follow, only the last is shaded
        assertEquals(List(8) { 0 } + raster.size.toInt(), calls.drop(401))
        assertEquals(calls.sum().toLong(), image.counters.shadingCalls)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun bytesGrowWithSuspensionsAndAreFreedWhenTheyAreHidden() {
        val tiles = Frame(raster, mosaic.primitives.take(400))
        val half = Frame(raster, mosaic.primitives.take(200))
        val growth =
            HybridRenderer().render(tiles).counters.peakBytes - HybridRenderer().render(half).counters.peakBytes
        assertTrue(growth > 200 * 100) { "$growth bytes for 200 more records" }

        // Ten thousand walls, each hiding the one before: at most two of them are held at a time
        val walls = Frame(raster, List(10_000) { Pane(raster.region, Depth.FAR - it, Rgba.BLACK) })
        val counters = HybridRenderer().render(walls).counters
        assertTrue(counters.peakBytes - imageBytes < 3000) { counters.toString() }
        assertEquals(raster.size, counters.peakSuspensions)
    }

    @Test
    fun aStreamKeepsOnlyPrimitivesThatSuspensionsReferTo() {
        val held = 1_000_000L
        val walls = flow<Primitive> {
            for (i in 0 until 1000) emit(Pane(raster.region, Depth.FAR - i, Rgba.BLACK, held))
            for (i in 0 until 1000) emit(Pane(raster.region, Depth.FAR - i, Rgba.BLACK, held))
        }
        val counters = stream(HybridRenderer(), walls).counters
        assertTrue(counters.peakBytes in imageBytes + held..imageBytes + 2 * held + 5000) { counters.toString() }
        assertEquals(raster.size, counters.shadingCalls)
    }

    @Test
    fun aPrimitiveTooLargeForTheBudgetForcesNothingElse() {
        val tiles = mosaic.primitives.take(20)
        val large = Pane(Region(30, 30, 40, 40), Depth.NEAR, Rgba.WHITE, heldBytes = 1_000_000)
        val cover = Pane(Region(0, 0, 40, 2), Depth.NEAR, Rgba.WHITE)
        val hybrid = HybridRenderer(RenderOptions(memoryBudget = 20_000))
        val image = stream(hybrid, (tiles + large + cover).asFlow())
        assertEquals(image.visible.toLong(), image.counters.shadingCalls)
    }

    @Test
    fun sharedVerticesAreCountedOnce() {
        // A fine mesh, all visible: its shared vertices take far more bytes than its triangles alone
        val side = 30
        val scene = Scene(listOf(SampleScenes.sheet(side) { x, y, axis -> listOf(x, y, 0)[axis] }.withSmoothNormals()))
        val counters = stream(HybridRenderer(), scene.primitives(raster).asFlow()).counters
        val records = 2 * (side - 1) * (side - 1)
        val vertices = 128L * side * side
        assertTrue(counters.peakBytes > imageBytes + vertices)
        assertTrue(counters.peakBytes < imageBytes + 2 * vertices + records * 1200L) { counters.toString() }
    }

    private fun render(frame: Frame, budget: Long): Image =
        HybridRenderer(RenderOptions(memoryBudget = budget)).render(frame)

    private fun stream(hybrid: HybridRenderer, primitives: Flow<Primitive>): Image = runBlocking {
        val collector = Image.Collector(raster.region)
        val counters: Counters = hybrid.render(raster, primitives, collector)
        collector.toImage(counters)
    }
}
