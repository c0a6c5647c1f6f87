package dev.lazyz.pipeline

import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FramePart
import dev.lazyz.FrameParts
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.SampleScenes
import dev.lazyz.Workers
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material.AlphaMode
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Returns a scene in which every third surface is translucent. */
internal fun glazed(seed: Long): Scene {
    val scene = SampleScenes.mixed(Random(seed))
    return scene.withSurfaces(
        scene.surfaces.mapIndexed { number, surface ->
            if (number % 3 > 0) surface else surface.withMaterials { it.withAlphaMode(AlphaMode.BLEND) }
        },
    )
}

/** Streamed frames with translucent primitives: the same picture, however little memory there is. */
class LayeredRenderingTest {
    private val frame = glazed(7).frame(40, 37)

    private fun render(
        mostBytes: Long,
        reversed: Boolean = false,
        mostOfASample: Long = 1 shl 20,
        frame: Frame = this.frame,
    ): Image {
        val pieces = frame.primitives.chunked(3).withIndex().toList()
        val parts = FrameParts(frame.primitives.size, hasTranslucency = true) {
            (if (reversed) pieces.reversed() else pieces).map { (number, piece) ->
                FramePart(3 * number, piece.size, null) { FrameContent.of(piece) }
            }.iterator()
        }
        val collector = Image.Collector(frame.region)
        val rendering = LayeredRendering(frame, parts, Workers.ALL, mostBytes, mostOfASample)
        return collector.toImage(rendering.run(collector))
    }

    @Test
    fun areasOfAnySizeGiveTheSamePicture() {
        assertTrue(frame.primitives.any { it.isTranslucent } && frame.primitives.any { !it.isTranslucent })
        val expected = TiledRenderer().render(frame)
        val fragments = ZBufferRenderer().render(frame.asOpaque()).counters.fragments
        for (mostBytes in listOf(1L shl 30, 100_000, 30_000, 5000, 2240, 0)) {
            for (reversed in listOf(false, true)) {
                val image = render(mostBytes, reversed)
                assertEquals(expected.pixelHash(), image.pixelHash(), "$mostBytes bytes, $reversed")
                assertEquals(fragments, image.counters.fragments, "$mostBytes bytes, $reversed")
                for (y in 0 until 37) {
                    for (x in 0 until 40) {
                        assertEquals(expected.depth(x, y), image.depth(x, y))
                        assertEquals(expected.primitive(x, y), image.primitive(x, y))
                    }
                }
            }
        }
    }

    /** In a narrow region a row has little memory, so that single samples have too many fragments for it. */
    @Test
    fun aSampleMayTakeMoreThanARow() {
        val (left, top) = 20 to 5
        for (width in 1..3) {
            val part = frame.within(Region(left, top, left + width, 30))
            val expected = TiledRenderer().render(part).pixelHash()
            for (reversed in listOf(false, true)) {
                assertEquals(expected, render(0, reversed, frame = part).pixelHash(), "$width columns, $reversed")
            }
        }
    }

    @Test
    fun aSampleThatDoesNotFitIsNamed() {
        val narrow = frame.within(Region(20, 0, 21, 37))
        val thrown = assertThrows(IllegalArgumentException::class.java) {
            render(28, mostOfASample = 28, frame = narrow)
        }
        assertTrue("translucent fragments" in thrown.message!! && "-Xmx" in thrown.message!!, thrown.message)
    }
}
