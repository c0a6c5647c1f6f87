package dev.lazyz.textbooks

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.setup.FrameBuilder
import org.junit.jupiter.api.Assertions.assertEquals

/** A polygon of a worked example. Its contour has depths as in textbooks: small numbers of steps, smaller is nearer. */
internal class Shape(val name: Char, vararg val contour: Double)

/**
 * An example of a few samples that can be worked by hand: shapes that are drawn one after the other, and the contents
 * of the depth buffer before the first and after each of them.
 *
 * @param depths the expected depths after each step, in rows from the top; `inf` is the background
 * @param owners the names of the visible shapes at the end, `.` for the background
 */
internal class WorkedExample(
    val name: String,
    val title: String,
    val width: Int,
    val height: Int,
    val shapes: List<Shape>,
    val depths: List<String>,
    val owners: String,
) {
    /** Returns the frame of the first [count] shapes. */
    fun frame(
        count: Int = shapes.size,
        convention: DepthConvention = DepthConvention.SMALLER_IS_NEARER,
        test: DepthTest = convention.nearest,
    ): Frame {
        val raster = Raster(width, height, Rgba.WHITE, convention, test)
        val builder = FrameBuilder(raster)
        for (shape in shapes.take(count)) {
            val contour = DoubleArray(shape.contour.size) {
                val number = shape.contour[it]
                if (it % 3 == 2) Depth.toUnit(Depth.NEAR + ((number + 1) * STEP).toInt()) else number
            }
            builder.polygon(Rgba.BLACK, contour)
        }
        return builder.build()
    }

    /** Returns the depths of an [image] in steps, each of three characters. */
    fun depthsOf(
        image: Image,
        convention: DepthConvention = DepthConvention.SMALLER_IS_NEARER,
    ): List<List<String>> = cells { x, y ->
        val depth = image.depth(x, y)
        val fromNear = if (convention == DepthConvention.SMALLER_IS_NEARER) depth else Int.MAX_VALUE - depth
        number(fromNear).padStart(3)
    }

    /** Returns the names of the visible shapes. */
    fun ownersOf(image: Image): List<List<String>> = cells { x, y ->
        val index = image.primitive(x, y)
        if (index == DepthTest.BACKGROUND) "." else shapes[index].name.toString()
    }

    private fun cells(cell: (Int, Int) -> String): List<List<String>> =
        List(height) { y -> List(width) { x -> cell(x, y) } }

    private fun number(depth: Int): String {
        if (depth == Int.MAX_VALUE) return "inf"
        assertEquals(0, (depth - Depth.NEAR) % STEP) { "depth $depth is not a whole number of steps" }
        return ((depth - Depth.NEAR) / STEP - 1).toString()
    }

    companion object {
        /** Units of depth in a step. Depths of -1 to 14 steps are within the range. */
        const val STEP = 1 shl 27

        /** Returns a rectangle whose depth is [left] at its left side and [right] at its right side. */
        fun rectangle(name: Char, columns: IntRange, rows: IntRange, left: Double, right: Double = left): Shape {
            val x0 = columns.first.toDouble()
            val x1 = columns.last + 1.0
            val y0 = rows.first.toDouble()
            val y1 = rows.last + 1.0
            return Shape(name, x0, y0, left, x1, y0, right, x1, y1, right, x0, y1, left)
        }

        /** Returns the text of [cells], as on the page. */
        fun text(cells: List<List<String>>): String = cells.joinToString("\n") { it.joinToString(" ") }
    }
}
