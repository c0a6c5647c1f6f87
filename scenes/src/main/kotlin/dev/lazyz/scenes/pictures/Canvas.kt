package dev.lazyz.scenes.pictures

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image

/**
 * A picture of [width] x [height] pixels, to draw rectangles and text on: legends and labels. Everything outside is cut
 * off. Not thread safe. Memory: 4 bytes a pixel.
 *
 * @property width number of columns
 * @property height number of rows
 * @param background the initial colour, `0xAARRGGBB`
 * @throws ArithmeticException if there are more than 2^31-1 pixels
 */
public class Canvas(public val width: Int, public val height: Int, background: Int) {
    private val argb = IntArray(Math.multiplyExact(width, height)) { background }

    /** Sets the pixel at column [x] and row [y] to [color], `0xAARRGGBB`. */
    public fun set(x: Int, y: Int, color: Int) {
        if (x in 0 until width && y in 0 until height) argb[y * width + x] = color
    }

    /** Fills a rectangle of [width] x [height] pixels, its upper left corner at ([x], [y]). */
    public fun fill(x: Int, y: Int, width: Int, height: Int, color: Int) {
        for (row in y until y + height) for (column in x until x + width) set(column, row, color)
    }

    /** Draws [text] in [PixelFont], its upper left corner at ([x], [y]), with pixels of [scale] x [scale] pixels. */
    public fun text(text: String, x: Int, y: Int, scale: Int, color: Int) {
        for (row in 0 until PixelFont.HEIGHT) {
            for (column in 0 until PixelFont.width(text)) {
                if (PixelFont.isSet(text, column, row)) fill(x + scale * column, y + scale * row, scale, scale, color)
            }
        }
    }

    /** Returns the picture, without copying its colours. It has no depth. */
    public fun toImage(): Image = Image(
        width, height, argb, IntArray(argb.size), IntArray(argb.size) { DepthTest.BACKGROUND }, Counters.NONE,
    )

    override fun toString(): String = "Canvas($width x $height)"
}
