package dev.lazyz.cli.sheet

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.outputs.ContactSheet
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class ContactSheetTest {
    @TempDir
    lateinit var folder: Path

    private val out by lazy { folder.resolve("sheet.png") }

    @Test
    fun cellsAreThePicturesOfSingleRuns() {
        val inputs = arrayOf("teapot", "city", "molecule")
        zcli("render", *inputs, "--contact-sheet", "--columns", 2, "--size", "40x30", "-o", out).done()
        val sheet = out.image

        // Cells of 40 x 30 with a label of 15 rows, and gaps of 6
        assertEquals(2 * 46 + 6 to 2 * 51 + 6, sheet.width to sheet.height)
        for ((i, name) in inputs.withIndex()) {
            val alone = folder.resolve("$name.png")
            zcli("render", name, "--size", "40x30", "-o", alone).done()
            val cell = sheet.getSubimage(6 + i % 2 * 46, 6 + i / 2 * 51, 40, 30)
            assertEquals(alone.image.argb(), cell.argb(), name)
            val label = sheet.getSubimage(6 + i % 2 * 46, 6 + i / 2 * 51 + 30, 40, 15)
            assertEquals(setOf(-1, 0xFF shl 24), label.argb().toSet())
        }
        assertTrue(sheet.getSubimage(52, 57, 46, 51).argb().all { it == -1 })
    }

    @Test
    fun labelsAreTheSameEverywhere() {
        val sheet = ContactSheet(ImageSize(12, 2), listOf("Hg", "too long"), 1, -1)
        repeat(2) { sheet.put(it, IntArray(24)) }
        folder.resolve("s.png").also { sheet.write(it) }.image.let { image ->
            val rows = (6 + 2 until 6 + 2 + 15).map { y ->
                (6 until 18).joinToString("") { x -> if (image.getRGB(x, y) == -1) "." else "#" }
            }
            val letters = """
                #...#.......
                #...#.......
                #...#..####.
                #####.#...#.
                #...#.#...#.
                #...#.#...#.
                #...#..####.
                ...........#
            """.trimIndent().lines().map {
                it.padEnd(12, '.')
            }
            assertEquals(letters.take(7), rows.subList(3, 10))
        }
    }

    @Test
    fun aFailedInputHasACellThatSaysSo() {
        val bad = folder.resolve("bad.stl").apply { writeText("not a model") }
        val run = zcli("render", "teapot", bad, "--contact-sheet", "--size", "64x64", "-o", out)
        assertEquals(ExitCode.MISTAKE, run.code)
        assertTrue("1 of 2 inputs failed" in run.errors) { run.errors }
        val cell = out.image.getSubimage(6 + 70, 6, 64, 64).argb()
        assertEquals(setOf(-1, 0xFF shl 24), cell.toSet())

        // Below the word is the reason
        bad.writeText("")
        assertEquals(ExitCode.MISTAKE, zcli("render", "teapot", bad, "--contact-sheet", "--size", "64", "-o", out).code)
        assertNotEquals(cell, out.image.getSubimage(6 + 70, 6, 64, 64).argb())
        assertEquals(ExitCode.MISTAKE, zcli("render", bad, "--contact-sheet", "-o", folder.resolve("none.png")).code)
        assertFalse(folder.resolve("none.png").exists())
    }

    @Test
    fun aReasonFillsItsCellAndNoMore() {
        fun sheet(reason: String): List<List<Int>> {
            val sheet = ContactSheet(ImageSize(60, 50), listOf("a", "b"), 1, -1)
            sheet.put(1, IntArray(3000) { -1 })
            sheet.fail(0, reason)
            sheet.write(out)
            return List(50) { y -> out.image.getSubimage(6, 6 + y, 60, 1).argb() }
        }
        fun inked(rows: List<List<Int>>): IntRange =
            rows.indexOfFirst { 0xFF shl 24 in it }..rows.indexOfLast { 0xFF shl 24 in it }
        // Lines of 11 rows: the word alone, with two lines, and with as many as there is room for
        assertEquals(19..25, inked(sheet("")))
        assertEquals(8..36, inked(sheet("is empty; check")))
        assertEquals(3..42, inked(sheet("a very-long-word-without-spaces and more than fits")))
    }

    @Test
    fun theBackgroundIsThatOfThePictures() {
        zcli("render", "teapot", "--contact-sheet", "--size", "32", "--background", "black", "-o", out).done()
        assertEquals(0xFF shl 24, out.image.getRGB(0, 0))
        zcli("render", "teapot", "--contact-sheet", "--size", "32", "--background", "transparent", "-o", out).done()
        assertEquals(0, out.image.getRGB(0, 0) ushr 24)
    }

    @Test
    fun columnsAreChosenForASheetAboutAsWideAsHigh() {
        val square = ImageSize(100, 100)
        assertEquals(1, ContactSheet.usualColumns(1, 1, square))
        assertEquals(4, ContactSheet.usualColumns(16, 1, square))
        assertEquals(2, ContactSheet.usualColumns(10, 1, ImageSize(400, 100)))
        assertEquals(3, ContactSheet.usualColumns(30, 3, square))
        assertEquals(6, ContactSheet.usualColumns(36, 36, square))
    }
}
