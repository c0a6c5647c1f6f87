package dev.lazyz.scenes.pictures

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image

/**
 * A picture of [width] x [height] pixels, to draw rectangles and text on. Everything outside is cut off. Not thread
 * safe.
 *
 * @param background the initial colour, `0xAARRGGBB`
 */
internal class Canvas(val width: Int, val height: Int, background: Int) {
    private val argb = IntArray(Math.multiplyExact(width, height)) { background }

    /** Sets the pixel at column [x] and row [y]. */
    fun set(x: Int, y: Int, color: Int) {
        if (x in 0 until width && y in 0 until height) argb[y * width + x] = color
    }

    /** Fills a rectangle. */
    fun fill(x: Int, y: Int, width: Int, height: Int, color: Int) {
        for (row in y until y + height) for (column in x until x + width) set(column, row, color)
    }

    /** Draws [text] in [PixelFont], its upper left corner at ([x], [y]), with pixels of [scale] x [scale] pixels. */
    fun text(text: String, x: Int, y: Int, scale: Int, color: Int) {
        for (row in 0 until PixelFont.HEIGHT) {
            for (column in 0 until PixelFont.width(text)) {
                if (PixelFont.isSet(text, column, row)) fill(x + scale * column, y + scale * row, scale, scale, color)
            }
        }
    }

    /** Returns the picture, without copying it. It has no depth. */
    fun toImage(): Image = Image(
        width, height, argb, IntArray(argb.size), IntArray(argb.size) { DepthTest.BACKGROUND }, Counters.NONE,
    )
}
