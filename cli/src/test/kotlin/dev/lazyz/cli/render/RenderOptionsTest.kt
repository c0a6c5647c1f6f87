package dev.lazyz.cli.render

import dev.lazyz.cli.WEDGE
import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.cli.zcliReading
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/** Each flag of `zcli render` has the documented effect. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class RenderOptionsTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = folder.resolve("out.png")

    /** Renders the wedge as a small picture, and returns its pixels. */
    private fun pixels(vararg options: Any): List<Int> {
        zcli("render", folder.wedge(), "-o", out, "--size", "40x30", *options).done()
        return out.image.argb()
    }

    /** The hash of the wedge's picture. */
    private fun hash(vararg options: Any): String =
        zcli("render", folder.wedge(), "-o", out, "--size", "40x30", "--stats=json", *options).done().stat("pixelHash")

    @Test
    fun pictureIs640By480UnlessSaid() {
        zcli("render", folder.wedge(), "-o", out).done()
        assertEquals(640 to 480, out.image.width to out.image.height)
        zcli("render", folder.wedge(), "-o", out, "--size", "17x33").done()
        assertEquals(17 to 33, out.image.width to out.image.height)
        zcli("render", folder.wedge(), "-o", out, "--size=1x1").done()
        assertEquals(1 to 1, out.image.width to out.image.height)
    }

    @Test
    fun endingChoosesTheFormat() {
        val ppm = folder.resolve("out.PPM")
        zcli("render", folder.wedge(), "--output", ppm, "--size", "40x30").done()
        assertEquals("P6", String(ppm.readBytes().copyOf(2)))
        zcli("render", folder.wedge(), "-o$out", "--size", "40x30").done()
        assertEquals("PNG", String(out.readBytes().copyOfRange(1, 4)))
    }

    @Test
    fun minusWritesPngToStandardOutput() {
        val toFile = pixels()
        assertEquals(toFile, zcli("render", folder.wedge(), "-o", "-", "--size", "40x30").done().image.argb())
        assertArrayEquals(out.readBytes(), zcli("render", folder.wedge(), "-o-", "--size", "40x30").done().output)
    }

    @Test
    fun pictureIsNamedAfterTheInputUnlessSaid() {
        val name = "zcli-test-${System.nanoTime()}"
        val picture = Path.of("$name.png")
        try {
            zcli("render", folder.wedge("$name.obj"), "--size", "40x30").done()
            assertTrue(picture.exists())
            val old = picture.readBytes()
            zcli("render", folder.wedge("$name.obj"), "--size", "4x3").mistake("$picture exists", "-o $picture")
            assertArrayEquals(old, picture.readBytes())
        } finally {
            picture.toFile().delete()
        }
    }

    @Test
    fun standardInputIsReadByFormat() {
        val options = arrayOf("-o", out, "--size", "40x30")
        zcliReading(WEDGE, "render", "-", "--format", "obj", *options).done()
        val piped = out.image.argb()
        assertEquals(pixels(), piped)
    }

    @Test
    fun formatOverridesTheName() {
        zcli("render", folder.wedge("wedge.txt"), "--format", "OBJ", "-o", out, "--size", "40x30").done()
        val named = out.image.argb()
        assertEquals(pixels(), named)
    }

    @Test
    fun shadingReplacesTheMaterials() {
        val ways = listOf("constant", "flat", "gouraud", "phong", "blinn-phong")
        val turned = arrayOf("--background", "black", "--azimuth", "-135", "--aa", "1", "--shading")
        val colors = ways.associateWith { pixels(*turned, it).toSet().size }
        assertEquals(2, colors["constant"], "one colour and the background")
        assertTrue(colors.getValue("flat") in 3..4, "$colors")
        val pictures = ways.map { zcli("render", "teapot", "-o", "-", "--size", "60x40", "--shading", it).image.argb() }
        assertTrue(pictures.toSet().size >= 4, "only the two kinds of highlight may look the same")
        assertEquals(pixels("--shading", "flat"), pixels("--shading", "FLAT"))
    }

    @Test
    fun eachViewIsAzimuthAndElevation() {
        val views = mapOf(
            "front" to ("0" to "0"), "back" to ("180" to "0"), "left" to ("-90" to "0"), "right" to ("90" to "0"),
            "top" to ("0" to "90"), "bottom" to ("0" to "-90"), "iso" to ("45" to "35.264389682754654"),
        )
        val hashes = views.map { (view, angles) ->
            val hash = hash("--view", view)
            assertEquals(hash("--azimuth", angles.first, "--elevation", angles.second), hash, view)
            hash
        }
        assertEquals(hashes.size, hashes.toSet().size, "views differ")
    }

    /** The edges get colours between those of the wedge and of the background; all else stays. */
    @Test
    fun antiAliasing() {
        val jagged = pixels("--aa", "1")
        assertEquals(pixels(), pixels("--aa", "4", "--aa-filter", "box", "--shading-rate", "sample"))
        assertEquals(2, pixels("--select", "count").toSet().size)
        for (samples in listOf("2", "4", "8")) {
            val smooth = pixels("--aa", samples)
            assertEquals(jagged.size, smooth.size)
            assertTrue(smooth.toSet().size > jagged.toSet().size, "$samples x $samples samples")
            assertTrue(smooth.indices.count { smooth[it] == jagged[it] } > jagged.size * 3 / 4)
        }
        val whole = pixels("--aa", "4")
        val part = pixels("--aa", "4", "--region", "10,5,20x15")
        val rows = (5 until 20).flatMap { y -> whole.subList(40 * y + 10, 40 * y + 30) }
        assertEquals(rows, part)
        zcli("compare", folder.wedge(), "--aa", "2", "--size", "40x30").done()
        zcli("render", folder.wedge(), "-o", out, "--aa", "3").mistake("'3' is not one of 1, 2, 4, 8")
        zcli("render", folder.wedge(), "-o", out, "--aa", "8", "--size", "100000x8").mistake("at most 32768 pixels")
    }

    @ParameterizedTest
    @ValueSource(strings = ["smaller", "larger"])
    fun depthIsWrittenBesideThePicture(order: String) {
        val pfm = folder.resolve("out.pfm")
        val picture = pixels("--depth-out", pfm, "--depth-convention", order)
        assertEquals(pixels(), picture)
        val header = String(pfm.readBytes().copyOf(9), Charsets.ISO_8859_1)
        assertEquals("Pf\n40 30\n", header)
    }

    @Test
    fun filesWithABuiltInsNameNeedAFolderOrAFormat() {
        val path = Path.of("teapot")
        val builtin = zcli("render", "teapot", "-o", "-", "--size", "40x30").done().image.argb()
        try {
            path.writeText(WEDGE)
            assertEquals(builtin, zcli("render", "teapot", "-o", "-", "--size", "40x30").done().image.argb())
            val wedge = pixels()
            val wanted = arrayOf("-o", "-", "--size", "40x30", "--format", "obj")
            assertEquals(wedge, zcli("render", "./teapot", *wanted).done().image.argb())
            assertEquals(wedge, zcli("render", "teapot", *wanted).done().image.argb())
        } finally {
            path.toFile().delete()
        }
    }

    @Test
    fun fileNamesMayBeginWithAnAt() {
        zcli("render", folder.wedge("@wedge.obj"), "-o", out, "--size", "4x3").done()
        zcli("render", "@${folder.resolve("none.obj")}", "-o", out).mistake("none.obj: no such file")
        assertTrue(WEDGE == folder.resolve("@wedge.obj").readText())
    }
}
