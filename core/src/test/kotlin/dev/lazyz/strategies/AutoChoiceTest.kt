package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.Selector
import dev.lazyz.samples
import dev.lazyz.strategies.Renderers.StrategyEstimates
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Which renderer [Renderers.auto] chooses, and that it supports the request. */
class AutoChoiceTest {
    private val glass = Material(Rgba(0.5f, 0.5f, 0.5f, 0.5f), alphaMode = AlphaMode.BLEND)

    private fun frame(side: Int, vararg surfaces: Surface): Frame = scene {
        for (surface in surfaces) add(surface)
        viewpoint(Camera.orthographic(Vector3d(0.0, 0.0, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 0.0, 8.0))
    }.frame(side, side)

    /** A grid of 2 x [cells] x [cells] triangles that fills the picture. */
    private fun grid(cells: Int, z: Double = 0.0): Mesh = SampleScenes.sheet(cells + 1) { column, row, axis ->
        listOf(2.0 * column / cells - 1.0, 2.0 * row / cells - 1.0, z)[axis]
    }

    private fun sphere(material: Material) = Sphere(Vector3d(0.0, 0.0, 0.0), 0.5, material)

    @Test
    fun numbersOfAMesh() {
        val numbers = FrameNumbers.of(frame(64, grid(4), grid(4, 1.0)))
        assertEquals(64, numbers.columns)
        assertEquals(64L, numbers.primitives)
        assertEquals(2.0, numbers.depthComplexity, 1e-3)
        assertEquals(64 * 16.0, numbers.primitiveRows, 1e-6)
    }

    @Test
    fun numbersOfASphereAndOfARegion() {
        val frame = frame(64, sphere(Material()))
        val numbers = FrameNumbers.of(frame)
        assertEquals(StrictMath.PI / 16, numbers.depthComplexity, 0.02)
        assertEquals(32.0, numbers.primitiveRows, 4.0)
        assertEquals(1.0, FrameNumbers.of(frame.within(Region(28, 28, 36, 36))).depthComplexity, 1e-9)
        val half = FrameNumbers.of(frame(64, grid(1)).within(Region(0, 0, 64, 32)))
        assertEquals(1.0, half.depthComplexity, 1e-3)
        assertEquals(64.0, half.primitiveRows, 1e-6)
    }

    @Test
    fun allBuiltInsAreMeasured() {
        val numbers = FrameNumbers.of(frame(64, grid(4)))
        for (renderer in Renderers.builtIn) {
            assertTrue(StrategyModel.milliseconds(renderer.id, numbers) > 0.0, renderer.id)
            assertTrue(StrategyMemory.expected(renderer.id, numbers) > 0.0, renderer.id)
        }
        assertTrue(StrategyModel.milliseconds("unheard-of", numbers).isNaN())
    }

    @Test
    fun theUsualOneIsTakenUnlessAnotherIsMuchFaster() {
        assertEquals("tiled", Renderers.auto(frame(512, grid(20))).id)
        for (side in listOf(1, 2, 4, 8, 16, 32, 64, 128)) {
            val estimates = Renderers.estimates(frame(side, grid(1)))
            val usual = estimates.all.single { it.renderer.id == Renderers.builtIn.first().id }
            val least = estimates.all.minOf { it.milliseconds }
            val best = checkNotNull(estimates.best)
            if (usual.milliseconds <= StrategyEstimates.MARGIN * least) {
                assertEquals(usual, best)
            } else {
                assertEquals(least, best.milliseconds)
            }
        }
        val tiny = Renderers.auto(frame(4, grid(1)), RenderOptions(threads = 1)).id
        assertTrue(tiny != "tiled") { "tiles for 16 samples" }
    }

    @Test
    fun whoCannotBlendIsNotTakenForATranslucentFrame() {
        val estimates = Renderers.estimates(frame(64, sphere(glass)))
        for (estimate in estimates.all) {
            val isAble = Capability.TRANSPARENCY in estimate.renderer.capabilities
            assertEquals(if (isAble) null else "lacks transparency", estimate.ruledOut)
        }
        assertTrue(Capability.TRANSPARENCY in Renderers.auto(frame(64, sphere(glass))).capabilities)
    }

    @Test
    fun aBudgetOrASelectorIsHeeded() {
        val frame = frame(64, grid(4))
        assertTrue(Capability.MEMORY_BUDGET in Renderers.auto(frame, RenderOptions(memoryBudget = 1000)).capabilities)
        assertEquals("lists", Renderers.auto(frame, RenderOptions(selector = Selector.count())).id)
        val streaming = Renderers.auto(frame, needs = setOf(Capability.STREAMS_ROWS))
        assertTrue(Capability.STREAMS_ROWS in streaming.capabilities)
        val both = RenderOptions(memoryBudget = 1000, selector = Selector.count())
        val refused = assertThrows(IllegalArgumentException::class.java) { Renderers.auto(frame, both) }
        assertTrue("lacks memory budget" in refused.message.orEmpty(), refused.message)
        assertNull(Renderers.estimates(frame, both).best)
    }

    @Test
    fun whoNeedsMoreMemoryThanThereIsIsNotTaken() {
        val frame = Frame(Raster(16_384, 16_384), emptyList())
        val gigabyte = 1L shl 30
        val estimates = Renderers.estimates(frame, memory = gigabyte)
        val byId = estimates.all.associateBy { it.renderer.id }
        for (id in listOf("zbuffer", "hybrid", "painter", "hierarchical")) {
            assertTrue(byId.getValue(id).ruledOut.orEmpty().startsWith("needs about "), id)
        }
        assertTrue(Capability.CONSTANT_MEMORY in checkNotNull(estimates.best).renderer.capabilities)
        val roomy = Renderers.estimates(frame, memory = Long.MAX_VALUE)
        assertTrue(roomy.all.all { it.ruledOut == null })
    }

    @Test
    fun aBudgetBoundsTheMemory() {
        val layers = FrameNumbers(1000, 1000, 1000, 1e6, 1e9)
        val least = 12e6 + 1000 + 256 * 1000
        assertEquals(least, StrategyMemory.expected("hybrid", layers, 1000))
        assertTrue(StrategyMemory.expected("hybrid", layers) > least)
        val frame = frame(256, *Array(200) { grid(1, it * 0.01) })
        val unbounded = StrategyMemory.expected("hybrid", FrameNumbers.of(frame)).toLong()
        val bounded = Renderers.estimates(frame, RenderOptions(memoryBudget = 1000), memory = unbounded - 1)
        assertEquals(null, bounded.all.single { it.renderer.id == "hybrid" }.ruledOut)
    }

    @Test
    fun explanationNamesEveryRenderer() {
        val text = Renderers.estimates(frame(64, sphere(glass)), RenderOptions(threads = 3)).explain()
        val lines = text.trimEnd().lines()
        assertEquals(2 + Renderers.all().size, lines.size, text)
        assertTrue(lines[0].startsWith("frame: 64 x 64 samples, 1 primitives, some translucent; about 0.2"), text)
        assertTrue(lines[1].startsWith("threads: 3; memory: "), text)
        val opaqueOnly = Renderers.builtIn.count { Capability.TRANSPARENCY !in it.capabilities }
        assertEquals(opaqueOnly, lines.count { it.endsWith("ruled out: lacks transparency") }, text)
    }

    @Test
    fun whatIsChosenGivesTheSameBits() {
        val frame = frame(96, grid(7), sphere(Material(Rgba.ofRgb(0x2F7FD0))))
        assertEquals(ZBufferRenderer().render(frame).pixelHash(), Renderers.auto(frame).render(frame).pixelHash())
    }
}
