package dev.lazyz.scenes.writers

import dev.lazyz.Counters
import dev.lazyz.Image
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.util.Random
import javax.imageio.ImageIO
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals

/** An independent reader gets back every pixel that was written. */
class PngSinkProperties {
    @Property(seed = "1995", tries = 300)
    fun javaxImageioReadsBackEveryPixel(@ForAll("images") image: Image) {
        val back = ImageIO.read(ByteArrayInputStream(png(image, AlphaChannel.KEEP)))
        assertEquals(image.width, back.width)
        assertEquals(image.height, back.height)
        assertArrayEquals(image.argb, back.getRGB(0, 0, image.width, image.height, null, 0, image.width))
    }

    @Property(seed = "1995", tries = 100)
    fun withoutAlphaTheColoursStayAsTheyAre(@ForAll("images") image: Image) {
        val back = ImageIO.read(ByteArrayInputStream(png(image, AlphaChannel.DROP)))
        val opaque = IntArray(image.argb.size) { image.argb[it] or (0xFF shl 24) }
        assertArrayEquals(opaque, back.getRGB(0, 0, image.width, image.height, null, 0, image.width))
    }

    @Property(seed = "1995", tries = 50)
    fun aBufferedImageHasTheSamePixels(@ForAll("images") image: Image) {
        val picture = image.toBufferedImage()
        assertArrayEquals(image.argb, picture.getRGB(0, 0, image.width, image.height, null, 0, image.width))
    }

    /** Noise, gradients and flat areas, so that every filter is the best of some row. */
    @Provide
    fun images(): Arbitrary<Image> = Combinators.combine(
        Arbitraries.integers().between(1, 300),
        Arbitraries.integers().between(1, 200),
        Arbitraries.longs(),
    ).`as` { width, height, seed ->
        val random = Random(seed)
        val kinds = IntArray(height) { random.nextInt(4) }
        val argb = IntArray(width * height)
        for (i in argb.indices) {
            argb[i] = when (kinds[i / width]) {
                0 -> random.nextInt()
                1 -> (i % width) * 0x01030507
                2 -> if (i >= width) argb[i - width] + 0x01010101 else 0x7F000000
                else -> 0xFF336699.toInt()
            }
        }
        Image(width, height, argb, IntArray(argb.size), IntArray(argb.size), Counters.NONE)
    }

    private fun png(image: Image, alpha: AlphaChannel): ByteArray {
        val bytes = ByteArrayOutputStream()
        PngSink(bytes, image.width, image.height, alpha).use { image.sendTo(it) }
        return bytes.toByteArray()
    }
}
