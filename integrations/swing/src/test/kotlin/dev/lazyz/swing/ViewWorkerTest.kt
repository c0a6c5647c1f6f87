package dev.lazyz.swing

import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.spi.Shader
import java.awt.image.BufferedImage
import java.util.Collections
import java.util.IdentityHashMap
import java.util.concurrent.CountDownLatch
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What is rendered when, and which images it takes. */
class ViewWorkerTest {
    private val pictures = LinkedBlockingQueue<Shown>()
    private val images: MutableSet<BufferedImage> = Collections.newSetFromMap(IdentityHashMap())
    private var front: BufferedImage? = null
    private val worker = ViewWorker(
        show = { shown ->
            images += shown.image
            pictures += shown
            front.also { front = shown.image }
        },
        fail = { _, message -> throw AssertionError(message) },
    )

    private fun next(): Shown = checkNotNull(pictures.poll(10, TimeUnit.MINUTES)) { "no picture" }

    private fun wish(source: Source, azimuth: Double) =
        Wish(source, PictureSettings().with(PictureParameters.AZIMUTH, azimuth), ImageSize(32, 24))

    @Test
    fun allPicturesTakeTwoImages() {
        val source = Source("teapot") { LoadedScene(Scenes.teapot(2), emptyList()) }
        for (azimuth in 0..20) {
            worker.request(wish(source, azimuth.toDouble()))
            assertFalse(next().isFinal)
        }
        assertTrue(next().isFinal)
        worker.request(wish(source, 30.0))
        assertFalse(next().isFinal)
        assertEquals(2, images.size)
    }

    /** The shader of the second picture waits until it is interrupted. */
    @Test
    fun aPictureWithAllSamplesIsInterruptedByTheNext() {
        val started = CountDownLatch(1)
        var isSlow = false
        val shader = Shader { fragment ->
            if (isSlow) {
                started.countDown()
                Thread.sleep(TimeUnit.MINUTES.toMillis(20))
            }
            fragment.setColor(1f, 0f, 0f)
        }
        val scene = Scenes.teapot(2).withMaterials { it.withShader(shader) }
        val source = Source("teapot") { LoadedScene(scene, emptyList()) }
        worker.request(wish(source, 0.0))
        assertFalse(next().isFinal)
        isSlow = true
        assertTrue(started.await(10, TimeUnit.MINUTES))
        isSlow = false
        worker.request(wish(source, 10.0))
        assertEquals(10.0, next().wish.settings[PictureParameters.AZIMUTH])
        val final = next()
        assertTrue(final.isFinal)
        assertEquals(10.0, final.wish.settings[PictureParameters.AZIMUTH])
        assertTrue(pictures.isEmpty())
    }

    /** Another model does not wait for one that is being read. */
    @Test
    fun readingIsInterruptedByAnotherModel() {
        val started = CountDownLatch(1)
        val endless = Source("endless") {
            started.countDown()
            Thread.sleep(TimeUnit.MINUTES.toMillis(20))
            throw AssertionError("it was not interrupted")
        }
        worker.request(wish(endless, 0.0))
        assertTrue(started.await(10, TimeUnit.MINUTES))
        worker.request(wish(Source("teapot") { LoadedScene(Scenes.teapot(2), emptyList()) }, 0.0))
        assertEquals("teapot", next().wish.source.name)
    }
}
