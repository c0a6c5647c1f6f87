package dev.lazyz

import dev.lazyz.setup.FrameBuilder
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The worked example of `docs/algorithms/zbuffer.md`; checks that the page shows the computed values. */
class TextbookExampleTest {
    private val raster = Raster(4, 4)

    /**
     * Converts a textbook depth to the fraction of the distance from near to far, in steps that are whole units of
     * depth.
     */
    private fun unit(depth: Double): Double = Depth.toUnit(Depth.NEAR + ((depth + 1) * STEP).toInt())

    /** The upper three rows, at depth 3. */
    private val a = doubleArrayOf(0.0, 0.0, unit(3.0), 4.0, 0.0, unit(3.0), 4.0, 3.0, unit(3.0), 0.0, 3.0, unit(3.0))

    /** The triangle below the diagonal, with depth 3 at the samples of the first row and 0 at those of the last. */
    private val b = doubleArrayOf(4.0, 0.0, unit(3.5), 4.0, 4.0, unit(-0.5), 0.0, 4.0, unit(-0.5))

    private fun image(vararg contours: DoubleArray): Image {
        val builder = FrameBuilder(raster)
        for (contour in contours) builder.polygon(Rgba.BLACK, contour)
        return ZBufferRenderer().render(builder.build())
    }

    private fun depths(image: Image): String = rows { x, y ->
        val depth = image.depth(x, y)
        if (depth == Int.MAX_VALUE) "inf" else "%3d".format(textbookDepth(depth))
    }

    private fun textbookDepth(depth: Int): Int {
        assertEquals(0, (depth - Depth.NEAR) % STEP) { "depth $depth" }
        return (depth - Depth.NEAR) / STEP - 1
    }

    private fun rows(cell: (Int, Int) -> String): String =
        (0 until 4).joinToString("\n") { y -> (0 until 4).joinToString(" ") { x -> cell(x, y) } }

    private val empty = """
        inf inf inf inf
        inf inf inf inf
        inf inf inf inf
        inf inf inf inf
    """.trimIndent()

    /** The margin bar of trimMargin keeps the blanks before the first digit. */
    private val afterA = """
        |  3   3   3   3
        |  3   3   3   3
        |  3   3   3   3
        |inf inf inf inf
    """.trimMargin()

    private val afterB = """
        |  3   3   3   3
        |  3   3   2   2
        |  3   1   1   1
        |  0   0   0   0
    """.trimMargin()

    private val owners = """
        A A A A
        A A B B
        A B B B
        B B B B
    """.trimIndent()

    @Test
    fun theBufferAfterEachStep() {
        assertEquals(empty, depths(image()))
        assertEquals(afterA, depths(image(a)))
        assertEquals(afterB, depths(image(a, b)))
        val both = image(a, b)
        assertEquals(owners, rows { x, y -> if (both.primitive(x, y) == 0) "A" else "B" })
    }

    @Test
    fun thePageShowsTheSame() {
        val page = ProjectFiles.root.resolve("docs/algorithms/zbuffer.md").readText()
        var from = page.indexOf("## Worked example")
        for (block in listOf(empty, afterA, afterB, owners)) {
            val found = page.indexOf(block.prependIndent("    "), from)
            assertTrue(found >= 0) { "docs/algorithms/zbuffer.md must show, in this order,\n$block" }
            from = found + 1
        }
    }

    private companion object {
        const val STEP = 1 shl 28
    }
}
