package dev.lazyz.scenes.pictures

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image
import java.text.Normalizer

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

/**
 * Letters made of pixels for labels in pictures: the printable characters of ASCII, 5 columns wide. Letters with
 * accents are drawn without them, and other characters as `?`. Fonts of the machine would give other pictures on other
 * machines. Immutable and thread safe.
 */
public object PixelFont {
    /** Columns of a letter, with the empty one that follows. */
    public const val ADVANCE: Int = 6

    /** Rows of a letter: 7 above the base line, 2 below. */
    public const val HEIGHT: Int = 9

    /** Returns the columns of [text], without the empty one at the end. */
    @JvmStatic
    public fun width(text: String): Int = maxOf(ADVANCE * text.length - 1, 0)

    private const val FIRST = ' '
    private const val LAST = '~'
    private const val LETTERS_OF_STRIP = 16

    /**
     * Returns whether the pixel at [column] and [row] of [text] is set; a letter takes [ADVANCE] columns.
     *
     * @throws IndexOutOfBoundsException if [column] is not in 0 until `ADVANCE * text.length`, or [row] not in 0 until
     *   [HEIGHT]
     */
    @JvmStatic
    public fun isSet(text: String, column: Int, row: Int): Boolean {
        val number = known(text[column / ADVANCE]) - FIRST
        val strip = strips[number / LETTERS_OF_STRIP]
        return strip[row].getOrElse(number % LETTERS_OF_STRIP * ADVANCE + column % ADVANCE) { ' ' } == '#'
    }

    /** Returns the letter to draw for [letter]: itself, or it without accents, or `?`. */
    private fun known(letter: Char): Char {
        if (letter in FIRST..LAST) return letter
        val base = Normalizer.normalize(letter.toString(), Normalizer.Form.NFD)[0]
        return if (base in FIRST..LAST) base else '?'
    }

    /** The letters in the order of their codes, 16 to a strip. */
    private val strips: List<List<String>> = """
        ..... ..#.. .#.#. .#.#. ..#.. ##... .##.. ..#.. ...#. .#... ..... ..... ..... ..... ..... .....
        ..... ..#.. .#.#. .#.#. .#### ##..# #..#. ..#.. ..#.. ..#.. ..#.. ..#.. ..... ..... ..... ....#
        ..... ..#.. .#.#. ##### #.#.. ...#. #.#.. .#... .#... ...#. #.#.# ..#.. ..... ..... ..... ...#.
        ..... ..#.. ..... .#.#. .###. ..#.. .#... ..... .#... ...#. .###. ##### ..... ##### ..... ..#..
        ..... ..#.. ..... ##### ..#.# .#... #.#.# ..... .#... ...#. #.#.# ..#.. ..... ..... ..... .#...
        ..... ..... ..... .#.#. ####. #..## #..#. ..... ..#.. ..#.. ..#.. ..#.. ..##. ..... .##.. #....
        ..... ..#.. ..... .#.#. ..#.. ...## .##.# ..... ...#. .#... ..... ..... ..#.. ..... .##.. .....
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... .....
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....

        .###. ..#.. .###. ####. ...#. ##### ..##. ##### .###. .###. ..... ..... ...#. ..... .#... .###.
        #...# .##.. #...# ....# ..##. #.... .#... ....# #...# #...# .##.. .##.. ..#.. ..... ..#.. #...#
        #..## ..#.. ....# ....# .#.#. ####. #.... ...#. #...# #...# .##.. .##.. .#... ##### ...#. ....#
        #.#.# ..#.. ...#. .###. #..#. ....# ####. ..#.. .###. .#### ..... ..... #.... ..... ....# ...#.
        ##..# ..#.. ..#.. ....# ##### ....# #...# ..#.. #...# ....# .##.. ..... .#... ##### ...#. ..#..
        #...# ..#.. .#... ....# ...#. #...# #...# ..#.. #...# ...#. .##.. ..##. ..#.. ..... ..#.. .....
        .###. .###. ##### ####. ...#. .###. .###. ..#.. .###. .##.. ..... ..#.. ...#. ..... .#... ..#..
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... ..... .....
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....

        .###. ..#.. ####. .###. ####. ##### ##### .###. #...# .###. ..### #...# #.... #...# #...# .###.
        #...# .#.#. #...# #...# #...# #.... #.... #...# #...# ..#.. ...#. #..#. #.... ##.## ##..# #...#
        #.### #...# #...# #.... #...# #.... #.... #.... #...# ..#.. ...#. #.#.. #.... #.#.# ##..# #...#
        #.#.# #...# ####. #.... #...# ####. ####. #.### ##### ..#.. ...#. ##... #.... #.#.# #.#.# #...#
        #.### ##### #...# #.... #...# #.... #.... #...# #...# ..#.. ...#. #.#.. #.... #...# #..## #...#
        #.... #...# #...# #...# #...# #.... #.... #...# #...# ..#.. #..#. #..#. #.... #...# #..## #...#
        .###. #...# ####. .###. ####. ##### #.... .###. #...# .###. .##.. #...# ##### #...# #...# .###.
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....

        ####. .###. ####. .###. ##### #...# #...# #...# #...# #...# ##### .###. ..... .###. ..#.. .....
        #...# #...# #...# #...# ..#.. #...# #...# #...# #...# #...# ....# .#... #.... ...#. .#.#. .....
        #...# #...# #...# #.... ..#.. #...# #...# #...# .#.#. .#.#. ...#. .#... .#... ...#. #...# .....
        ####. #...# ####. .###. ..#.. #...# #...# #.#.# ..#.. ..#.. ..#.. .#... ..#.. ...#. ..... .....
        #.... #.#.# #.#.. ....# ..#.. #...# #...# #.#.# .#.#. ..#.. .#... .#... ...#. ...#. ..... .....
        #.... #..#. #..#. #...# ..#.. #...# .#.#. ##.## #...# ..#.. #.... .#... ....# ...#. ..... .....
        #.... .##.# #...# .###. ..#.. .###. ..#.. #...# #...# ..#.. ##### .###. ..... .###. ..... #####
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....
        ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....

        .#... ..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #.... .##.. ..... ..... .....
        ..#.. ..... #.... ..... ....# ..... .#... ..... #.... ..... ..... #.... ..#.. ..... ..... .....
        ...#. .###. ####. .###. .#### .###. ####. .#### ####. .##.. ..##. #..#. ..#.. ##.#. ####. .###.
        ..... ....# #...# #.... #...# #...# .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# #...#
        ..... .#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##... ..#.. #.#.# #...# #...#
        ..... #...# #...# #.... #...# #.... .#... #...# #...# ..#.. ...#. #.#.. ..#.. #.#.# #...# #...#
        ..... .#### ####. .###. .#### .###. .#... .#### #...# .###. ...#. #..#. .###. #.#.# #...# .###.
        ..... ..... ..... ..... ..... ..... ..... ....# ..... ..... #..#. ..... ..... ..... ..... .....
        ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. ..... ..... ..... ..... .....

        ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..##. ..#.. .##.. .....
        ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..#.. ..#.. ..#.. .....
        ####. .#### #.##. .#### ####. #...# #...# #...# #...# #...# ##### ..#.. ..#.. ..#.. .#...
        #...# #...# ##... #.... .#... #...# #...# #.#.# .#.#. #...# ...#. .#... ..#.. ...#. #.#.#
        #...# #...# #.... .###. .#... #...# #...# #.#.# ..#.. #...# ..#.. ..#.. ..#.. ..#.. ...#.
        #...# #...# #.... ....# .#... #...# .#.#. #.#.# .#.#. #...# .#... ..#.. ..#.. ..#.. .....
        ####. .#### #.... ####. ..##. .#### ..#.. .#.#. #...# .#### ##### ..##. ..#.. .##.. .....
        #.... ....# ..... ..... ..... ..... ..... ..... ..... ....# ..... ..... ..... ..... .....
        #.... ....# ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... ..... ..... .....
    """.trimIndent().split("\n\n").map {
        it.lines()
    }
}
