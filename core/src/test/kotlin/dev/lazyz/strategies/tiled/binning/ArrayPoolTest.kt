package dev.lazyz.strategies.tiled.binning

import com.sun.management.ThreadMXBean
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.SampleScenes
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import java.lang.management.ManagementFactory
import java.util.Random
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ArrayPoolTest {
    @Test
    fun framesThatAreAlikeAllocateNothingLarge() {
        val mesh = SampleScenes.soup(Random(1), 3000, Material())
        val frame = Scene(listOf(mesh), emptyList(), SampleScenes.camera).frame(3000, 200)
        val sink = RowSink { _, _, _, _ -> }
        val renderer = TiledRenderer(Coherence.DIRECT, 1, 64)
        val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean

        fun allocated(): Long {
            val before = threads.currentThreadAllocatedBytes
            renderer.render(frame, sink)
            return threads.currentThreadAllocatedBytes - before
        }

        val first = allocated()
        val rows = 12L * 64 * 3000
        assertTrue(first > rows) { "$first" }
        assertTrue(allocated() < first - rows)
    }
}
