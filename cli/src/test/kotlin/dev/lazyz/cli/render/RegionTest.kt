package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.zcli
import dev.lazyz.strategies.Renderers
import java.nio.file.Path
import kotlin.io.path.readBytes
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `--region` gives a rectangle of the whole picture, bit for bit. */
class RegionTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = folder.resolve("out.png")

    private fun pixels(vararg options: Any): List<Int> {
        zcli("render", "teapot", "-o", out, "--size", "80x60", *options).done()
        return out.image.argb()
    }

    private fun List<Int>.cropped(x: Int, y: Int, width: Int, height: Int): List<Int> =
        (y until y + height).flatMap { subList(it * 80 + x, it * 80 + x + width) }

    @Test
    fun isACropOfTheWhole() {
        val whole = pixels()
        for (strategy in Renderers.builtIn.map { it.id }) {
            val part = pixels("--region", "20,10,33x31", "--strategy", strategy)
            assertEquals(whole.cropped(20, 10, 33, 31), part, strategy)
            assertEquals(33 to 31, out.image.width to out.image.height)
        }
        assertEquals(whole, pixels("--region", "0,0,80x60"))
        assertEquals(whole.cropped(40, 30, 1, 1), pixels("--region", "40,30,1x1"))

        // The last pixel is background
        val corner = zcli("render", "teapot", "-o", out, "--size", "80x60", "--region", "79,59,1x1")
        assertEquals(ExitCode.DONE to whole.cropped(79, 59, 1, 1), corner.code to out.image.argb())
    }

    @Test
    fun isACropOfTheDepthToo() {
        fun depth(vararg options: Any): ByteArray {
            val pfm = folder.resolve("out.pfm")
            pixels("--depth-out", pfm, *options)
            return pfm.readBytes()
        }
        val whole = depth()
        val upperLeft = depth("--region", "0,0,80x20")
        // The bottom row comes first
        val bytes = 4 * 80 * 20
        assertArrayEquals(whole.takeLast(bytes).toByteArray(), upperLeft.takeLast(bytes).toByteArray())
        assertTrue(String(upperLeft, Charsets.ISO_8859_1).startsWith("Pf\n80 20\n-1.0\n"))
    }

    @Test
    fun statisticsAreOfTheRegion() {
        val run = zcli(
            "render", "teapot", "-o", out, "--size", "80x60", "--region", "30,20,20x10", "--stats=json",
        ).done()
        assertEquals("20" to "10", run.stat("width") to run.stat("height"))
        assertEquals("200", run.stat("visible"))
        assertEquals("1.0", run.stat("coverage"))
        assertEquals(run.stat("fragments").toLong() / (16 * 200.0), run.stat("overdraw").toDouble())
    }

    @Test
    fun aRegionOfAPictureLargerThanMemoryIsRendered() {
        zcli("render", "teapot", "-o", out, "--size", "200000x150000", "--region", "90000,70000,9x7").done()
        assertEquals(9 to 7, out.image.width to out.image.height)
    }
}
