package dev.lazyz.testing

import dev.lazyz.Capability
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/**
 * Golden tests of this project's own, as its users write them. `-Dlazyz.golden.update=true` writes the pictures. Hashes
 * of more pictures are in GoldenTest of `scenes`.
 */
class GoldenPicturesTest {
    /** `zcli render teapot --size 120x90 --aa 2` makes the same picture; a test of the command line checks it. */
    @Test
    fun teapot() {
        assertThat(Scenes.teapot()).at(120, 90).withAntiAliasing(SuperSampling(2)).matches("golden/teapot.png")
    }

    @Test
    fun allStrategiesMakeTheSamePicture() {
        for (renderer in Renderers.builtIn) {
            assertThat(Scenes.city(blocks = 2)).at(96, 72).withRenderer(renderer).matches("golden/city.png")
        }
    }

    @Test
    fun optionsChooseTheRenderer() {
        val options = RenderOptions(selector = Selector.farthest())
        val city = assertThat(Scenes.city(blocks = 2)).at(96, 72).withOptions(options)
        city.matches("golden/city-farthest.png")
        val message = assertThrows(IllegalArgumentException::class.java) {
            city.withRenderer(ZBufferRenderer()).matches("golden/city-farthest.png")
        }.message
        assertTrue(Capability.SELECTION.name in message!!, message)
    }

    @Test
    fun imagesAndPngFilesInMemory() {
        val sampling = SuperSampling(2, PixelFilter.MITCHELL)
        val image = sampling.frame(Scenes.teapot(), Raster(64, 64)).render(ZBufferRenderer())
        assertThat(image).matches("golden/teapot-mitchell.png")
        assertThat(image.toPng()).matches("golden/teapot-mitchell.png")
    }

    @Test
    fun anInterruptEndsTheTest() {
        Thread.currentThread().interrupt()
        val assertion = assertThat(Scenes.teapot()).at(120, 90).withRenderer(InterruptibleRenderer)
        val error = assertThrows(AssertionError::class.java) { assertion.matches("golden/teapot.png") }
        assertTrue(Thread.interrupted())
        assertTrue("interrupted" in error.message!!, error.message)
    }
}
