package dev.lazyz.strategies

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.ShadingRate
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.drawing.EdgeStyle.EdgeSet
import dev.lazyz.filter.SuperSampling
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import java.lang.management.ManagementFactory
import java.util.concurrent.atomic.AtomicReference
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/**
 * How much processor time the threads of the library take after an interrupt, while they set up, sort, draw, shade and
 * filter. The promise is 100 ms. Not the clock on the wall: the machine may be busy.
 */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class InterruptTimesTest {
    private val threads = ManagementFactory.getThreadMXBean()

    /** A relief of some 300,000 triangles in an order that is not sorted in any direction. */
    private val relief = relief(Material())

    private fun relief(material: Material): Mesh {
        val sheet = SampleScenes.sheet(390) { column, row, axis ->
            listOf(column / 389f - 0.5f, row / 389f - 0.5f, 0.01f * ((column * 31 + row * 17) % 50))[axis]
        }
        val squares = sheet.triangleCount / 2
        val shuffled = IntArray(6 * squares) { sheet.triangles[(it / 6 * 7919L % squares).toInt() * 6 + it % 6] }
        return Mesh(sheet.positions, shuffled, material)
    }

    private fun scene(mesh: Mesh) = Scene(listOf(mesh), viewpoint = Camera.fit())

    private val raster = Raster(400, 400)

    /** Calls [work], interrupts its thread when it has taken [moment] ms, and returns the milliseconds that follow. */
    private fun after(moment: Int, work: () -> Unit): Long {
        val end = AtomicReference<Long>()
        val thread = Thread {
            try {
                // Work that ends early begins again
                while (true) work()
            } catch (_: InterruptedException) {
                end.set(threads.currentThreadCpuTime)
            }
        }
        thread.start()
        while (thread.isAlive && threads.getThreadCpuTime(thread.id) < moment * 1_000_000L) Thread.sleep(1)
        thread.interrupt()

        // Read after the interrupt, because a busy machine may let this thread wait before it; negative at the end
        val reached = threads.getThreadCpuTime(thread.id)
        val helped = helpers()
        thread.join()
        val last = checkNotNull(end.get()) { "ended without an InterruptedException" }
        return if (reached < 0) 0 else (last - reached + helpers() - helped) / 1_000_000
    }

    /** Processor time of the library's own threads. */
    private fun helpers(): Long = threads.getThreadInfo(threads.allThreadIds).filterNotNull()
        .filter { it.threadName.startsWith("lazyz-") }
        .sumOf { maxOf(threads.getThreadCpuTime(it.threadId), 0) }

    private fun assertShort(name: String, work: () -> Unit) {
        for (moment in listOf(3, 120)) {
            val time = after(moment, work)
            assertTrue(time <= 100, "$name goes on for $time ms after an interrupt at $moment ms")
        }
    }

    @Test
    @Timeout(600)
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun allStrategiesEnd() {
        for (renderer in Renderers.builtIn) {
            assertShort(renderer.id) { renderer.render(scene(relief).frame(raster)) { _, _, _, _ -> } }
        }
    }

    @Test
    @Timeout(600)
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun blendingEnds() {
        val glass = scene(relief(Material(Rgba.WHITE.withAlpha(0.1f), alphaMode = AlphaMode.BLEND)))
        for (id in listOf("tiled", "lists", "scanline", "painter", "raycast", "bsp")) {
            val renderer = Renderers.builtIn.first { it.id == id }
            assertShort("glass by $id") { renderer.render(glass.frame(raster)) { _, _, _, _ -> } }
        }
    }

    @Test
    @Timeout(600)
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun setUpFiltersDrawingsAndShadowsEnd() {
        val renderer = Renderers.builtIn.first { it.id == "zbuffer" }
        val filtered = SuperSampling(4, rate = ShadingRate.PIXEL)
        assertShort("set-up") { scene(relief).frame(raster) }
        assertShort("a filter") { filtered.frame(scene(relief), raster).render(renderer) { _, _, _, _ -> } }
        assertShort("a drawing") { EdgeStyle(EdgeSet.ALL).drawnOn(scene(relief)).frame(raster) }
        assertShort("occlusion") { AmbientOcclusion.of(scene(relief)) }
    }
}
