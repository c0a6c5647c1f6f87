package dev.lazyz.cli.diff

import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.copyTo
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `zcli diff` compares pixels, not files. */
class DiffTest {
    @TempDir
    lateinit var folder: Path

    private fun picture(
        name: String,
        width: Int = 4,
        type: Int = BufferedImage.TYPE_INT_RGB,
        change: (BufferedImage) -> Unit = {},
    ): Path {
        val image = BufferedImage(width, 3, type)
        for (y in 0 until 3) for (x in 0 until width) image.setRGB(x, y, 0xFF406080.toInt())
        change(image)
        return folder.resolve(name).also { ImageIO.write(image, "png", it.toFile()) }
    }

    @Test
    fun formsOfFilesDoNotMatter() {
        val first = picture("a.png")
        val second = picture("b.png", type = BufferedImage.TYPE_INT_ARGB)
        assertFalse(first.readBytes().contentEquals(second.readBytes()))
        val words = "$second is the same as $first\nall 12 pixels are the same\n"
        assertEquals(words, zcli("diff", first, second).done().text)
        val json = zcli("diff", first, second, "--json").done()
        assertEquals("true", json.stat("identical"))
        assertEquals("0", json.stat("differingPixels"))
    }

    /** All formats that the help lists, but JPEG, which loses colours. */
    @Test
    fun allFormatsAreRead() {
        val image = BufferedImage(8, 8, BufferedImage.TYPE_BYTE_BINARY).apply { setRGB(1, 2, -1) }
        val files = listOf("png", "tiff", "bmp", "gif", "wbmp").map { format ->
            folder.resolve("a.$format").also { assertTrue(ImageIO.write(image, format, it.toFile()), format) }
        }
        for (file in files) zcli("diff", files[0], file).done()
        val help = zcli("diff", "--help").text
        for (format in listOf("PNG", "TIFF", "BMP", "GIF", "WBMP", "JPEG")) assertTrue(format in help, help)
    }

    @Test
    fun differencesAreCountedLocatedAndShown() {
        val first = picture("a.png")
        val second = picture("b.png") { it.setRGB(2, 1, 0xFF406083.toInt()) }
        val where = folder.resolve("where.png")
        val run = zcli("diff", first, second, "--diff", where)
        assertEquals(ExitCode.DIFFERENT, run.code)
        assertEquals(
            "$second differs from $first\n1 of 12 pixels differ, within columns 2 to 2, rows 1 to 1\n" +
                "first at column 2, row 1: expected #406080ff, but was #406083ff\n" +
                "largest difference of a channel: 3 of 255; mean: 0.0625\n",
            run.text,
        )
        assertEquals("", run.errors)
        assertEquals(0xFFFF0000.toInt(), where.image.getRGB(2, 1) and 0xFFFF00FF.toInt())
        assertEquals(0, where.image.getRGB(1, 1).let { (it and 0xFF) - (it shr 8 and 0xFF) })

        val json = zcli("diff", first, second, "--json")
        assertEquals(ExitCode.DIFFERENT, json.code)
        assertEquals(
            """{"expected":{"file":"$first","width":4,"height":3},"actual":{"file":"$second","width":4,"height":3},""" +
                """"threshold":0.0,"identical":false,"matches":false,"differingPixels":1,"largestDifference":3.0,""" +
                """"meanDifference":0.0625,"bounds":{"x":2,"y":1,"width":1,"height":1},""" +
                """"firstDifference":{"x":2,"y":1,"expected":{"color":"#406080ff"},"actual":{"color":"#406083ff"}}}""" +
                "\n",
            json.text,
        )
    }

    @Test
    fun aThresholdAcceptsSmallDifferences() {
        val first = picture("a.png")
        val second = picture("b.png") { it.setRGB(2, 1, 0xFF406083.toInt()) }
        val json = zcli("diff", first, second, "--threshold", "3", "--json").done()
        assertEquals(listOf("false", "true"), listOf("identical", "matches").map { json.stat(it) })
        assertEquals(ExitCode.DIFFERENT, zcli("diff", first, second, "--threshold", "2.9").code)
        for (wrong in listOf("-1", "256", "x")) zcli("diff", first, second, "--threshold=$wrong").mistake("--threshold")
    }

    @Test
    fun badInputIsAMistake() {
        val good = picture("a.png")
        val missing = folder.resolve("missing.png")
        val text = folder.resolve("text.png").apply { writeText("text") }
        zcli("diff", good, missing).mistake("$missing: there is no such file")
        zcli("diff", "-", good).mistake("OLD", "'-', standard input or output, is not possible here: name a file")
        zcli("diff", good, "-").mistake("NEW", "'-', standard input or output, is not possible here: name a file")
        zcli("diff", text, good).mistake("$text: it is no image that can be decoded")
        zcli("diff", good).mistake("NEW")
        zcli("diff", good, "a.stl").mistake("a.stl is a model and $good is none by its name")
        zcli("diff", good, good, "--size", "9").mistake("--size is for models")
        zcli("diff", good, good, "-o", "a.html").mistake("-o is for models")
        zcli("diff", good, good, "--diff", "where.jpg").mistake("--diff must end in .png")
        val copy = good.copyTo(folder.resolve("copy.png"))
        zcli("diff", copy, good, "--diff", good).mistake("NEW and --diff must be different files")
        zcli("diff", good, copy, "--diff", good).mistake("OLD and --diff must be different files")
        zcli("diff", good, missing, "--diff", folder.resolve("where.png")).mistake("no such file")
        assertFalse(folder.resolve("where.png").exists())
        assertArrayEquals(copy.readBytes(), good.readBytes())
    }

    /** Together they would need a picture of 2^32 pixels. */
    @Test
    fun longAndHighPicturesDiffer() {
        val (long, high) = listOf(65536 to 1, 1 to 65536).map { (width, height) ->
            val image = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
            folder.resolve("$width.png").also { ImageIO.write(image, "png", it.toFile()) }
        }
        assertEquals(1, zcli("diff", long, high).code)
        val marked = folder.resolve("marked.png")
        zcli("diff", long, high, "--diff", marked).mistake("65536x65536 pixels", "omit --diff", "the sizes differ")
        assertFalse(Files.exists(marked))
    }
}
