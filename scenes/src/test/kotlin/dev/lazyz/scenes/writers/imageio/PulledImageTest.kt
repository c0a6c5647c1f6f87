package dev.lazyz.scenes.writers.imageio

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Raster as Samples
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.scenes.ChildJava
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.writers.toBufferedImage
import dev.lazyz.strategies.tiled.TiledRenderer
import java.awt.Rectangle
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.InterruptedIOException
import java.io.UncheckedIOException
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.fileSize
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class PulledImageTest {
    @TempDir
    lateinit var folder: Path

    private val teapot = Scenes.builtins.first { it.id == "teapot" }.scene()

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun writersOfJavaWriteThePicture() {
        for (background in listOf(Rgba.WHITE, Rgba.TRANSPARENT)) {
            val frame = teapot.frame(Samples(300, 200, background = background))
            val expected = TiledRenderer().render(frame).toBufferedImage()
            for (format in listOf("png", "tiff")) {
                val bytes = ByteArrayOutputStream()
                assertTrue(ImageIO.write(PulledImage.of(TiledRenderer(), frame), format, bytes))
                assertArrayEquals(argb(expected), argb(ImageIO.read(ByteArrayInputStream(bytes.toByteArray()))), format)
            }
        }
    }

    /** A band has 41 rows here. */
    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun partsOfAWidePicture() {
        val region = Region(1000, 300, 101_000, 400)
        val frame = teapot.frame(Samples(102_000, 800)).within(region)
        val image = PulledImage.of(TiledRenderer(), frame)
        assertEquals(3, image.numYTiles)
        for (rows in listOf(0..0, 40..40, 41..41, 30..90, 82..99)) {
            val rect = Rectangle(45_000, rows.first, 9_000, rows.count())
            val data = image.getData(rect)
            assertEquals(rect, data.bounds)
            val part = Region(46_000, 300 + rows.first, 55_000, 301 + rows.last)
            val expected = TiledRenderer().render(frame.within(part)).argb
            val actual = data.getDataElements(rect.x, rect.y, rect.width, rect.height, null) as IntArray

            // There is no alpha
            assertArrayEquals(IntArray(actual.size) { expected[it] shl 8 }, IntArray(actual.size) { actual[it] shl 8 })
        }
        assertThrows<IndexOutOfBoundsException> { image.getTile(0, 3) }
    }

    @Test
    fun exceptionsOfTheRendererCanBeCaughtByJava() {
        val frame = teapot.frame(90, 60)
        for (read in listOf<(PulledImage) -> Unit>({ it.data }, { it.getTile(0, 0) }, { it.copyData(null) })) {
            Thread.currentThread().interrupt()
            val e = assertThrows<UncheckedIOException> { read(PulledImage.of(TiledRenderer(), frame)) }
            assertEquals(InterruptedIOException::class.java, e.cause!!.javaClass)
            assertTrue(Thread.interrupted(), "the status is set")
        }
        val failure = IOException("out of luck")
        val failing = object : Renderer {
            override val id get() = "failing"
            override val summary get() = "fails"

            override fun render(frame: Frame, sink: RowSink): Counters = throw failure
        }
        assertSame(failure, assertThrows<UncheckedIOException> { PulledImage.of(failing, frame).data }.cause)
    }

    /** Each picture has 137 MiB. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun picturesLargerThanTheHeapAreWritten() {
        for (format in listOf("png", "tiff")) {
            val path = folder.resolve("large.$format")
            assertEquals("written", ChildJava.run(WriteInChild::class.java, listOf("-Xmx64m"), "$path", format))
            assertTrue(path.fileSize() > 100_000)
        }
    }

    private fun argb(image: BufferedImage): IntArray =
        image.getRGB(0, 0, image.width, image.height, null, 0, image.width)
}

/** Writes a picture in a Java of its own. */
internal object WriteInChild {
    @JvmStatic
    fun main(args: Array<String>) {
        val scene = Scenes.builtins.first { it.id == "teapot" }.scene()
        ImageIO.write(PulledImage.of(TiledRenderer(), scene.frame(6000, 6000)), args[1], Path.of(args[0]).toFile())
        println("written")
    }
}
