package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** Colours, textures, backgrounds and square sizes from the command line. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class ColorOptionsTest {
    @TempDir
    lateinit var folder: Path

    private val wedge: Path by lazy { folder.wedge() }

    /** A square with texture coordinates, whose vertices have colours. */
    private val square: Path by lazy {
        folder.resolve("square.obj").apply {
            writeText(
                "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" +
                    "f 1/1 2/2 3/3 4/4\n",
            )
        }
    }

    /** Upper half red, lower half blue. */
    private val flag: Path by lazy {
        val image = BufferedImage(16, 16, BufferedImage.TYPE_INT_RGB)
        for (x in 0 until 16) for (y in 0 until 16) image.setRGB(x, y, if (y < 8) 0xFF0000 else 0x0000FF)
        folder.resolve("flag.png").also { ImageIO.write(image, "png", it.toFile()) }
    }

    private fun picture(input: Any, vararg words: String): BufferedImage {
        val out = folder.resolve("out.png")
        zcli("render", input, "--size", "40x30", "--aa", "1", "-o", out, *words).done()
        return out.image
    }

    private fun colors(input: Any, vararg words: String): Set<String> =
        picture(input, "--shading", "constant", "--view", "front", *words).argb().map { "%08x".format(it) }.toSet()

    @Test
    fun transparencyThatAFileLosesCausesAWarning() {
        fun errors(name: String, vararg words: String): String =
            zcli("render", square, "-o", "$folder/$name", "--size", "8", *words).errors
        val clear = arrayOf("--background", "transparent")
        val warning = "a .ppm file has no alpha: what is transparent is written as opaque; use .png\n"
        assertEquals("zcli: warning: $warning", errors("a.ppm", *clear))
        assertEquals("zcli: warning: square iso: $warning", errors("{view}.ppm", "--views", "iso", *clear))
        assertEquals("", errors("a.ppm") + errors("a.png", *clear) + errors("a.dzi", *clear))
    }

    @Test
    fun aColorReplacesThoseOfTheModel() {
        assertTrue(colors(square).size > 20)
        assertEquals(setOf("ff663399", "ffffffff"), colors(square, "--color", "rebeccapurple"))
        assertEquals(setOf("ff663399", "ff000000"), colors(wedge, "--color", "RebeccaPurple", "--background", "black"))
        assertEquals(setOf("ff123456", "ffffffff"), colors(square, "--color", "123456"))
        val glass = colors(square, "--color", "ff000080", "--background", "transparent")
        assertEquals(setOf("80ff0000", "00000000"), glass)
    }

    @Test
    fun aTextureReplacesThoseOfTheModel() {
        val image = picture(
            square, "--texture", "$flag", "--shading", "constant", "--projection", "orthographic", "--view", "front",
        )
        assertEquals(0xFFFF0000.toInt(), image.getRGB(20, 5))
        assertEquals(0xFF0000FF.toInt(), image.getRGB(20, 25))
        val blue = picture(
            square, "--texture", "$flag", "--shading", "constant", "--projection", "orthographic", "--view", "front",
            "--color", "blue",
        )
        assertEquals(0xFF000000.toInt(), blue.getRGB(20, 5))
        assertEquals(0xFF0000FF.toInt(), blue.getRGB(20, 25))
    }

    @Test
    fun aTextureNeedsCoordinates() {
        val out = folder.resolve("out.png")
        zcli("render", wedge, "--texture", flag, "-o", out).mistake("--texture: $wedge has no texture coordinates")
        val both = folder.resolve("both.json")
        both.writeText("""{"lazyz":1,"surfaces":[{"mesh":"${square.fileName}"},{"mesh":"${wedge.fileName}"}]}""")
        val run = zcli("render", both, "--texture", flag, "-o", out)
        assertEquals(ExitCode.DONE, run.code, run.errors)
        assertTrue("1 of 2 surfaces have no texture coordinates, so --texture has no effect on them" in run.errors)
        val front = listOf("--aa", "1", "--shading", "constant", "--view", "front", "--background", "black")
        zcli("render", both, "--size", "40x30", "--texture", flag, "-o", out, *front.toTypedArray())
        val plain = out.image.argb().map { "%08x".format(it) }
        assertTrue("ffffffff" in plain, "$plain: the wedge is white, not the colour of a corner of the flag")
        zcli("render", square, "--texture", "no.png", "-o", out).mistake("no.png: there is no such file")
        zcli("render", square, "--texture", square, "-o", out).mistake("is not an image that can be read")
        zcli("render", square, "--texture", flag, "--max-texels", "255", "-o", out).mistake("texels")
    }

    @Test
    fun aGradientIsBehindTheModel() {
        val image = picture(wedge, "--background", "#102030,gold")
        assertEquals(30, (0 until 30).map { image.getRGB(0, it) }.toSet().size)
        assertEquals(1, (0 until 40).map { image.getRGB(it, 0) }.toSet().size)
        val (first, last) = image.getRGB(0, 0) to image.getRGB(0, 29)
        assertTrue(distance(first, 0x102030) < 8 && distance(last, 0xFFD700) < 8, "%08x %08x".format(first, last))

        // The model hides it, and depth knows nothing of it
        val plain = picture(wedge, "--background", "transparent")
        for (y in 0 until 30) {
            for (x in 0 until 40) {
                val color = plain.getRGB(x, y)
                if (color ushr 24 == 0xFF) assertEquals(color, image.getRGB(x, y)) else assertEquals(0, color ushr 24)
            }
        }
        assertTrue(!image.colorModel.hasAlpha() && plain.colorModel.hasAlpha())
    }

    private fun distance(argb: Int, rgb: Int): Int =
        listOf(0, 8, 16).maxOf { Math.abs((argb shr it and 0xFF) - (rgb shr it and 0xFF)) }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "--color|tomatoo|'tomatoo' is not a colour",
            "--color|#12|'#12' is not a colour",
            "--color|red,blue|'red,blue' is not a colour",
            "--color|rgb(1)|'rgb(1)' is not a colour",
            "--background|red,|'' is not a colour",
            "--background|red,green,blue|a gradient has two colours, TOP,BOTTOM",
            "--background|red,transparent|the colours of a gradient must be opaque",
            "--background|red,nocolor|'nocolor' is not a colour",
        ],
    )
    fun wrongValuesAreReported(option: String, value: String, message: String) {
        zcli("render", wedge, "-o", folder.resolve("out.png"), "$option=$value").mistake("$option: $message")
    }
}
