package dev.lazyz.scenes.writers.animation

import dev.lazyz.RowSink
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.PngSink
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.imageio.ImageReader
import javax.imageio.metadata.IIOMetadataNode
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class AnimationFilesTest {
    @TempDir
    lateinit var folder: Path

    private val white = 0xFFFFFFFF.toInt()
    private val red = 0xFFFF0000.toInt()

    private fun RowSink.frame(width: Int, height: Int, color: (Int, Int) -> Int) {
        for (y in 0 until height) {
            row(y, IntArray(width) { x -> color(x, y) }, IntArray(width), IntArray(width))
        }
    }

    /** Writes frames of a white picture in which a red dot moves. */
    private fun dots(path: Path, animation: Animation, background: Int = white) =
        AnimationFiles.write(path, animation) { sink ->
            for (f in 0 until animation.frames) {
                sink.frame(animation.width, animation.height) { x, y -> if (x == f && y == 1) red else background }
            }
        }

    private fun gif(path: Path): Pair<ImageReader, Int> {
        val reader = ImageIO.getImageReadersByFormatName("gif").next()
        reader.input = ImageIO.createImageInputStream(ByteArrayInputStream(path.readBytes()))
        return reader to reader.getNumImages(true)
    }

    private fun ImageReader.attribute(frame: Int, node: String, name: String): String {
        val metadata = getImageMetadata(frame)
        val root = metadata.getAsTree(metadata.nativeMetadataFormatName) as IIOMetadataNode
        return (root.getElementsByTagName(node).item(0) as IIOMetadataNode).getAttribute(name)
    }

    private fun ImageReader.place(frame: Int): Pair<Int, Int> {
        val (x, y) = listOf("Left", "Top").map { attribute(frame, "ImageDescriptor", "image${it}Position").toInt() }
        return x to y
    }

    /** Returns what is seen after each frame: opaque frames are drawn over those before. */
    private fun ImageReader.seen(count: Int, width: Int, height: Int): List<BufferedImage> {
        val canvas = BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB)
        return List(count) { f ->
            val (x, y) = place(f)
            canvas.createGraphics().drawImage(read(f), x, y, null)
            BufferedImage(canvas.colorModel, canvas.copyData(null), false, null)
        }
    }

    @Test
    fun aGifOfFewColoursIsExactAndLoops() {
        val path = folder.resolve("a.gif")
        dots(path, Animation(5, 3, 4, framesPerSecond = 3, alpha = AlphaChannel.DROP))
        val (reader, count) = gif(path)
        assertEquals(4, count)
        for ((f, image) in reader.seen(4, 5, 3).withIndex()) {
            for (y in 0 until 3) {
                for (x in 0 until 5) assertEquals(if (x == f && y == 1) red else white, image.getRGB(x, y), "$f $x $y")
            }
        }

        // A third of a second is 33 or 34 hundredths
        val delays = (0 until 4).map { reader.attribute(it, "GraphicControlExtension", "delayTime").toInt() }
        assertEquals(listOf(33, 33, 34, 33), delays)
        assertEquals("NETSCAPE", reader.attribute(0, "ApplicationExtension", "applicationID"))
    }

    /** The dot is in another column each time, and is gone after the second frame. */
    @Test
    fun opaqueFramesOfAGifAreOnlyTheirChanges() {
        val path = folder.resolve("a.gif")
        AnimationFiles.write(path, Animation(6, 5, 5, alpha = AlphaChannel.DROP)) { sink ->
            sink.frame(6, 5) { x, y -> if (x == 1 && y == 1) red else white }
            sink.frame(6, 5) { x, y -> if (x == 4 && y == 3) red else white }
            repeat(2) { sink.frame(6, 5) { _, _ -> white } }
            sink.frame(6, 5) { x, y -> if (x == 0 || y == 4) red else white }
        }
        val (reader, count) = gif(path)
        assertEquals(5, count)
        assertEquals(listOf(0 to 0, 1 to 1, 4 to 3, 0 to 0, 0 to 0), (0 until 5).map { reader.place(it) })
        val sizes = (0 until 5).map { f -> reader.getWidth(f) to reader.getHeight(f) }
        assertEquals(listOf(6 to 5, 4 to 3, 1 to 1, 1 to 1, 6 to 5), sizes)
        assertEquals("doNotDispose", reader.attribute(1, "GraphicControlExtension", "disposalMethod"))
        val reds = reader.seen(5, 6, 5).map { image ->
            (0 until 30).filter { image.getRGB(it % 6, it / 6) == red }.map { it % 6 to it / 6 }
        }
        assertEquals(listOf(listOf(1 to 1), listOf(4 to 3), listOf(), listOf()), reds.dropLast(1))
        assertEquals(10, reds.last().size)
    }

    /** 262,144 colours and a background: the palette is near all of them, and the background is exact. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun manyColoursGetNearOnes() {
        val path = folder.resolve("a.gif")
        val background = 0xFF123456.toInt()
        AnimationFiles.write(path, Animation(512, 513, 1)) { sink ->
            sink.frame(512, 513) { x, y ->
                val n = (y - 1) * 512 + x
                if (y == 0) {
                    background
                } else {
                    0xFF shl 24 or (n and 63 shl 18) or (n shr 6 and 63 shl 10) or (n shr 12 shl 2)
                }
            }
        }
        val (reader, _) = gif(path)
        val image = reader.read(0)
        assertEquals(background, image.getRGB(7, 0))
        var total = 0L
        for (n in 0 until 512 * 512) {
            val found = image.getRGB(n % 512, n / 512 + 1)
            for ((shift, value) in listOf(16 to (n and 63), 8 to (n shr 6 and 63), 0 to (n shr 12))) {
                val d = (found shr shift and 0xFF) - value * 4
                total += d * d
            }
        }

        // 256 equal cubes of a colour space would have a mean square of about 400
        val mean = total / (512.0 * 512)
        assertTrue(mean < 600) { "$mean" }
    }

    /** The data of each frame is that of a PNG file of the frame; programs that read PNG files see the first. */
    @Test
    fun framesOfAnAnimatedPngAreExact() {
        val path = folder.resolve("a.png")
        val color = { f: Int, x: Int, y: Int -> 0x80000000.toInt() or (f * 70_000 + x * 300 + y) }
        AnimationFiles.write(path, Animation(300, 300, 3, framesPerSecond = 7)) { sink ->
            for (f in 0 until 3) sink.frame(300, 300) { x, y -> color(f, x, y) }
        }
        val chunks = chunks(path.readBytes())
        assertEquals("IHDR", chunks.first().first)
        assertEquals("IEND", chunks.last().first)
        val control = chunks.single { it.first == "acTL" }.second
        assertEquals(3 to 0, ByteBuffer.wrap(control).getInt() to ByteBuffer.wrap(control).getInt(4))
        val numbered = chunks.filter { it.first in listOf("fcTL", "fdAT") }.map { ByteBuffer.wrap(it.second).getInt() }
        assertEquals(numbered.indices.toList(), numbered)
        val delay = ByteBuffer.wrap(chunks.first { it.first == "fcTL" }.second)
        assertEquals(1 to 7, delay.getShort(20).toInt() to delay.getShort(22).toInt())
        for (f in 0 until 3) {
            val alone = ByteArrayOutputStream()
            PngSink(alone, 300, 300).use { sink -> sink.frame(300, 300) { x, y -> color(f, x, y) } }
            assertArrayEquals(data(chunks(alone.toByteArray()), 0), data(chunks, f))
        }
        assertEquals(color(0, 5, 6), ImageIO.read(path.toFile()).getRGB(5, 6))
    }

    /** Returns the compressed bytes of a frame. */
    private fun data(chunks: List<Pair<String, ByteArray>>, frame: Int): ByteArray {
        var current = -1
        val bytes = ByteArrayOutputStream()
        for ((type, data) in chunks) {
            if (type == "fcTL") current++
            val isCurrent = current == frame || current < 0
            if (type == "IDAT" && isCurrent) bytes.writeBytes(data)
            if (type == "fdAT" && isCurrent) bytes.writeBytes(data.copyOfRange(4, data.size))
        }
        return bytes.toByteArray()
    }

    private fun chunks(file: ByteArray): List<Pair<String, ByteArray>> {
        val buffer = ByteBuffer.wrap(file).position(8)
        val chunks = ArrayList<Pair<String, ByteArray>>()
        while (buffer.hasRemaining()) {
            val data = ByteArray(buffer.getInt())
            val type = ByteArray(4).also { buffer.get(it) }.decodeToString()
            buffer.get(data)
            buffer.getInt()
            chunks.add(type to data)
        }
        return chunks
    }

    @Test
    fun anIncompleteAnimationLeavesNoFile() {
        for (name in listOf("a.gif", "a.png", "a.apng")) {
            val e = assertThrows(IOException::class.java) {
                AnimationFiles.write(folder.resolve(name), Animation(4, 4, 2)) { it.frame(4, 4) { _, _ -> white } }
            }
            assertTrue("1 of 2 frames" in e.message.orEmpty()) { "$e" }
        }
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }

    @Test
    fun rowsAndShapesThatAreWrongAreRefused() {
        for (name in listOf("a.gif", "a.apng")) {
            val path = folder.resolve(name)
            assertThrows(IllegalArgumentException::class.java) {
                AnimationFiles.write(path, Animation(4, 4, 1)) { it.row(0, IntArray(3), IntArray(3), IntArray(3)) }
            }
            val e = assertThrows(IllegalArgumentException::class.java) {
                AnimationFiles.write(path, Animation(4, 4, 1)) { sink ->
                    repeat(2) { sink.frame(4, 4) { _, _ -> white } }
                }
            }
            assertEquals("there are only 1 frames", e.message)
        }
        assertThrows(IllegalArgumentException::class.java) { Animation(4, 4, 0) }
        assertThrows(IllegalArgumentException::class.java) { Animation(0, 4, 1) }
        assertThrows(IllegalArgumentException::class.java) { Animation(4, 4, 1, 51) }
        assertThrows(IllegalArgumentException::class.java) { AnimationFiles.formatOf(Path.of("a.jpg")) }
        assertThrows(IllegalArgumentException::class.java) { GifSink(ByteArrayOutputStream(), Animation(65_536, 1, 1)) }
    }

    @Test
    fun anInterruptLeavesNoFile() {
        for (name in listOf("a.gif", "a.apng")) {
            assertThrows(InterruptedException::class.java) {
                AnimationFiles.write(folder.resolve(name), Animation(4, 4, 1)) { sink ->
                    Thread.currentThread().interrupt()
                    sink.frame(4, 4) { _, _ -> white }
                }
            }
            assertFalse(Thread.interrupted(), "the status is cleared")
        }
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }
}
