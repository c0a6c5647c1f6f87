package dev.lazyz.planning

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.filter.SuperSampling
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.lazy.LazyRenderer
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledMemory
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class RenderPlannerTest {
    private val glass = Material(Rgba(0.5f, 0.4f, 0.3f, 0.5f), alphaMode = AlphaMode.BLEND)

    private val scenes: List<Scene> = listOf(
        SampleScenes.mixed(Random(1)),
        scene(soup(3_000, 0.02, Material())),
        scene(soup(200, 1.0, Material())),
        scene(soup(500, 0.3, glass)),
        scene(soup(500, 0.05, glass)),
        scene(soup(50, 0.5, Material(texture = SampleScenes.checks, alphaMode = AlphaMode.MASK))),
    )

    private fun scene(mesh: Mesh): Scene = Scene(listOf(mesh)).withViewpoint(SampleScenes.camera)

    /** Random triangles of about this size. */
    private fun soup(triangles: Int, size: Double, material: Material): Mesh {
        val random = Random(triangles.toLong())
        val positions = FloatArray(9 * triangles)
        for (triangle in 0 until triangles) {
            val center = FloatArray(3) { random.nextFloat() * 2 - 1 }
            for (i in 0 until 9) {
                positions[9 * triangle + i] = center[i % 3] + (size * (random.nextDouble() - 0.5)).toFloat()
            }
        }
        val uvs = FloatArray(6 * triangles) { random.nextFloat() }
        return Mesh(positions, IntArray(3 * triangles) { it }, material, uvs = uvs)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun tiledNeedsNoMoreThanTheBounds() {
        for (scene in scenes) {
            for ((width, height) in listOf(320 to 200, 33 to 400, 700 to 20)) {
                val frame = scene.frame(Raster(width, height))
                for (threads in listOf(1, 3)) for (tile in listOf(8, 64)) requireBound(frame, tile, threads)
            }
        }
    }

    private fun requireBound(frame: Frame, tile: Int, threads: Int) {
        val options = RenderOptions(threads = threads, tileSize = tile)
        val peak = TiledRenderer(options).render(frame) { _, _, _, _ -> }.peakBytes
        val need = TiledMemory(frame, tile, threads)

        // The counter has twice the bins, even if there is only one set of them
        val bound = need.rowBytes * need.rowArrays + 2 * need.bins + need.singles + need.layers + need.workers
        assertTrue(peak <= bound) { "$frame, tiles of $tile, $threads threads: $peak bytes, and the bound is $bound" }
    }

    @Test
    fun lessMemoryMeansSmallerTilesThenOneThreadAndThenNoPlan() {
        val frame = SuperSampling(2).frame(scenes[1], Raster(8_000, 2_000))
        val options = RenderOptions(threads = 2)
        val plans = listOf(256, 32, 18, 5).map {
            RenderPlanner(it * MEBIBYTE, options).plan(frame, listOf(TiledRenderer()))
        }
        assertEquals(listOf(true, true, true, false), plans.map { it.fits })
        assertTrue("2 threads, tiles of 64 x 64" in plans[0].summary, plans[0].summary)
        assertTrue("2 threads" in plans[1].summary && "64 x 64" !in plans[1].summary, plans[1].summary)
        assertTrue(plans[2].bytes < plans[1].bytes)
        val enough = RenderPlanner(plans[3].leastMemory, options).plan(frame, listOf(TiledRenderer()))
        assertTrue(enough.fits, "$enough")
        assertTrue("tiles of" in enough.explain() && "reserve" in enough.explain(), enough.explain())
    }

    @Test
    fun otherThingsInMemoryCount() {
        val frame = SuperSampling.NONE.frame(scenes[1], Raster(64, 64))
        val planner = RenderPlanner(64 * MEBIBYTE)
        assertTrue(planner.plan(frame, Renderers.builtIn, listOf(RenderPlan.Item("scene", 20 * MEBIBYTE))).fits)
        assertFalse(planner.plan(frame, Renderers.builtIn, listOf(RenderPlan.Item("scene", 50 * MEBIBYTE))).fits)
    }

    @Test
    fun aRendererThatCanLimitItsMemoryGetsABudget() {
        val frame = SuperSampling.NONE.frame(scenes[1], Raster(20_000, 200))
        val plan = RenderPlanner(16 * MEBIBYTE).plan(frame, listOf(LazyRenderer()))
        assertTrue(plan.fits, "$plan")
        assertTrue("a budget of" in plan.summary || plan.bytes < 9 * MEBIBYTE, plan.summary)
    }

    /** Strategies without batches need an object for each triangle, and for a flat one also its vertices. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun objectsOfTrianglesAreCounted() {
        val flat = soup(60_000, 0.02, Material(shading = Shading.FLAT))
        for (mesh in listOf(flat, flat.withSmoothNormals(180.0).withMaterials { it.withShading(Shading.PHONG) })) {
            val frame = scene(mesh).frame(Raster(2_000, 2_000))
            val sampled = SuperSampling.NONE.of(frame)
            val planned = RenderPlanner(512 * MEBIBYTE).plan(sampled, listOf(ListsRenderer())).bytes
            val before = usedMemory()
            val objects = frame.primitives.toList()
            val taken = usedMemory() - before
            assertTrue(planned >= taken) { "${objects.size} triangles take $taken bytes, and $planned are planned" }
        }
    }

    /** What a surface says of its set-up is at least what the frame takes. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun setUpTakesNoMoreThanTheSurfacesSay() {
        val mesh = soup(60_000, 0.02, Material())
        val vertices = mesh.positions
        for (surface in listOf(mesh, Points(vertices), Lines(vertices, IntArray(vertices.size / 3)))) {
            val scene = Scene(listOf(surface)).withViewpoint(SampleScenes.camera)
            val before = usedMemory()
            val frame = scene.frame(Raster(640, 480))
            val taken = usedMemory() - before
            assertTrue(taken <= scene.setUpBytes) { "$frame of $surface takes $taken, not ${scene.setUpBytes} bytes" }
        }
    }

    private fun usedMemory(): Long {
        repeat(2) { System.gc() }
        return Runtime.getRuntime().run { totalMemory() - freeMemory() }
    }

    /** Triangles that are read again for each pass. */
    private val streamed = object : MeshSource {
        private val mesh = soup(64, 0.5, Material())
        override val triangleCount = 64
        override val partCount = 1
        override val origin = Vector3d()
        override val hasColors = false

        override fun triangleCount(number: Int) = 64

        override fun bounds(number: Int) = mesh.bounds

        override fun read(first: Int, count: Int) = mesh
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aStreamedFrameIsRenderedInBandsThatFit() {
        val scene = Scene(listOf(StreamedMesh(streamed))).withViewpoint(SampleScenes.camera)
        val frame = SuperSampling.NONE.frame(scene, Raster(1_000, 3_000))
        val wide = RenderPlanner(512 * MEBIBYTE).plan(frame, Renderers.builtIn)
        val narrow = RenderPlanner(96 * MEBIBYTE).plan(frame, Renderers.builtIn)
        assertEquals(1, wide.passes)
        assertTrue(narrow.fits && narrow.passes > 1, "$narrow")
        assertEquals(frame.render(wide.renderer).pixelHash(), frame.render(narrow.renderer).pixelHash())
        assertFalse(RenderPlanner(32 * MEBIBYTE).plan(frame, Renderers.builtIn).fits)
    }

    /** A plan with a pass for each row would fit, but take very long. */
    @Test
    fun noPlanHasManyPasses() {
        for (material in listOf(Material(), glass)) {
            val scene = Scene(listOf(StreamedMesh(streamed, material))).withViewpoint(SampleScenes.camera)
            val frame = SuperSampling.NONE.frame(scene, Raster(20_000, 20_000))
            val least = RenderPlanner(0).plan(frame, listOf(TiledRenderer())).leastMemory
            val plan = RenderPlanner(least).plan(frame, listOf(TiledRenderer()))
            assertTrue(plan.fits && plan.passes in 30..64, "$plan")
            assertFalse(RenderPlanner(least - MEBIBYTE).plan(frame, listOf(TiledRenderer())).fits)
        }
    }

    @Test
    fun onlyWhatCanRenderTheFrameIsPlanned() {
        val frame = SuperSampling.NONE.frame(scenes[3], Raster(64, 64))
        val planner = RenderPlanner(512 * MEBIBYTE)
        assertThrows(IllegalArgumentException::class.java) { planner.plan(frame, listOf(LazyRenderer())) }
        assertEquals("tiled", planner.plan(frame, listOf(LazyRenderer(), TiledRenderer())).renderer.id)
        val none = assertThrows(IllegalArgumentException::class.java) { planner.plan(frame, emptyList()) }
        assertEquals("there are no renderers to choose from; pass some, as Renderers.builtIn", none.message)
        assertThrows(IllegalArgumentException::class.java) { RenderPlanner(-1) }
    }

    private companion object {
        const val MEBIBYTE = 1L shl 20
    }
}
