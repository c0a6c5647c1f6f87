package dev.lazyz.scenes.outputs

import dev.lazyz.RowSink
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.pictures.PixelFont
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.PngSink
import java.io.IOException
import java.io.OutputStream
import java.nio.file.Path

/**
 * One picture with many in cells, in rows from the top, each with a label below, as `zcli render --contact-sheet`
 * writes it.
 *
 * Memory: 4 bytes for each pixel of a cell. [put] and [fail] can be called from any thread.
 *
 * @param cell the size of each picture
 * @param labels the labels of the cells, in their order; they also say how many cells there are
 * @param columns cells in a row
 * @param background the colour between the cells, `0xAARRGGBB`
 * @throws IllegalArgumentException if there are no columns
 */
public class ContactSheet(
    private val cell: ImageSize,
    private val labels: List<String>,
    private val columns: Int,
    private val background: Int,
) {
    init {
        require(columns >= 1) { "columns must be at least 1: $columns" }
    }

    private val cells = arrayOfNulls<IntArray>(labels.size)
    private val reasons = arrayOfNulls<String>(labels.size)
    private val scale = (cell.width / PIXELS_PER_SCALE).coerceIn(1, MAX_SCALE)
    private val reasonScale = (scale + 1) / 2
    private val gap = GAP * scale
    private val labelHeight = (PixelFont.HEIGHT + 2 * LABEL_MARGIN) * scale
    private val pitchX = cell.width + gap
    private val pitchY = cell.height + labelHeight + gap
    private val rows = (labels.size + columns - 1) / columns
    private val ink = if (isDark(background)) WHITE else BLACK

    /** Columns of the whole sheet. */
    public val width: Long = columns * pitchX.toLong() + gap

    /** Rows of the whole sheet. */
    public val height: Long = rows * pitchY.toLong() + gap

    /** Whether no picture has arrived. */
    public val isEmpty: Boolean get() = cells.all { it == null }

    /** Says why a cell has no picture. The [reason] is shown in its place, as far as there is room. */
    public fun fail(number: Int, reason: String) {
        synchronized(cells) { reasons[number] = reason }
    }

    /**
     * Sets the picture of a cell: pixels in rows from the top. A cell without a picture says that it failed. The array
     * is not copied.
     *
     * @throws IllegalArgumentException if it does not have one element for each pixel
     */
    public fun put(number: Int, argb: IntArray) {
        require(argb.size == cell.width * cell.height) { "a cell has ${cell.width}x${cell.height} pixels" }
        synchronized(cells) { cells[number] = argb }
    }

    /** Whether files need alpha. */
    private val alpha: AlphaChannel
        get() {
            val isOpaque = background ushr 24 == 0xFF && cells.all { it == null || it.all { c -> c ushr 24 == 0xFF } }
            return if (isOpaque) AlphaChannel.DROP else AlphaChannel.KEEP
        }

    /**
     * Writes the sheet to an image file at [path], see [ImageFiles].
     *
     * @throws IOException if the file cannot be written
     * @throws ArithmeticException if the sheet has more than 2^31-1 rows or columns
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun write(path: Path) {
        val (w, h) = Math.toIntExact(width) to Math.toIntExact(height)
        ImageFiles.write(path, w, h, alpha = alpha) { sink -> writeRows(w, h, sink) }
    }

    /** Writes the sheet to [output] as a PNG file, and closes it. Throws like the other [write]. */
    @Throws(IOException::class)
    public fun write(output: OutputStream) {
        val (w, h) = Math.toIntExact(width) to Math.toIntExact(height)
        PngSink(output, w, h, alpha).use { writeRows(w, h, it) }
    }

    override fun toString(): String = "ContactSheet(${labels.size} cells, $width x $height)"

    private fun writeRows(width: Int, height: Int, sink: RowSink) {
        val none = IntArray(width)
        val row = IntArray(width)
        for (y in 0 until height) {
            row.fill(background)
            val below = (y - gap) % pitchY
            if (y >= gap) for (column in 0 until columns) drawCell((y - gap) / pitchY * columns + column, below, row)
            sink.row(y, row, none, none)
        }
    }

    /** Draws row [y] of a cell with its label. */
    private fun drawCell(number: Int, y: Int, row: IntArray) {
        if (number >= labels.size) return
        val x = gap + number % columns * pitchX
        val argb = cells[number]
        if (y >= cell.height) {
            draw(labels[number], y - cell.height - LABEL_MARGIN * scale, x, row)
        } else if (argb != null) {
            argb.copyInto(row, x, y * cell.width, (y + 1) * cell.width)
        } else {
            drawFailure(number, y, x, row)
        }
    }

    /** Draws row [y] of a cell without a picture: that it failed, and as much of the reason as there is room for. */
    private fun drawFailure(number: Int, y: Int, x: Int, row: IntArray) {
        val reason = wrapped(reasons[number].orEmpty())
        val height = LINE * scale + LINE * reasonScale * reason.size
        val below = y - (cell.height - height) / 2
        if (below < LINE * scale) return draw(FAILED, below, x, row)
        val line = (below - LINE * scale) / (LINE * reasonScale)
        if (line !in reason.indices) return
        draw(reason[line], (below - LINE * scale) % (LINE * reasonScale), x, row, reasonScale)
    }

    /** Returns the lines of [text] that fit into a cell, below the word above them. */
    private fun wrapped(text: String): List<String> {
        val most = cell.width / (PixelFont.ADVANCE * reasonScale)
        val room = (cell.height - LINE * scale) / (LINE * reasonScale)
        if (most < LEAST_LETTERS || room < 1) return emptyList()
        val lines = ArrayList<String>()
        for (word in text.split(' ', '\n').flatMap { it.chunked(most) }) {
            val last = lines.lastOrNull()
            if (last != null && last.length + 1 + word.length <= most) {
                lines[lines.size - 1] = "$last $word"
            } else {
                lines += word
            }
        }
        if (lines.size <= room) return lines
        return lines.take(room - 1) + (lines[room - 1].take(most - DOTS.length) + DOTS)
    }

    /** Draws row [y] of a text, in the middle of the columns from [x]: smaller, and at last shorter, until it fits. */
    private fun draw(text: String, y: Int, x: Int, row: IntArray, most: Int = scale) {
        val size = (most downTo 1).firstOrNull { text.length * PixelFont.ADVANCE * it <= cell.width } ?: 1
        val room = cell.width / (PixelFont.ADVANCE * size)
        val shown = if (text.length <= room) text else text.take(maxOf(room - DOTS.length, 0)) + DOTS.take(room)
        val letterRow = Math.floorDiv(y, size)
        if (letterRow !in 0 until PixelFont.HEIGHT) return
        val length = shown.length * PixelFont.ADVANCE * size
        val start = x + (cell.width - length) / 2
        for (i in 0 until length) if (PixelFont.isSet(shown, i / size, letterRow)) row[start + i] = ink
    }

    public companion object {
        private const val GAP = 6
        private const val LABEL_MARGIN = 3
        private const val MAX_SCALE = 16

        /** A cell of this width has labels of single pixels; larger ones have larger labels. */
        private const val PIXELS_PER_SCALE = 128
        private const val DOTS = ".."
        private const val FAILED = "failed"

        /** Rows of a line of text. */
        private const val LINE = PixelFont.HEIGHT + 2

        /** Letters of a line in a cell that has room for a reason. */
        private const val LEAST_LETTERS = 8
        private const val BLACK = 0xFF shl 24
        private const val WHITE = -1

        /** Opaque, and nearer to black than to white. The weights are those of luma. */
        private fun isDark(color: Int): Boolean {
            val luma = 299 * (color shr 16 and 0xFF) + 587 * (color shr 8 and 0xFF) + 114 * (color and 0xFF)
            return color ushr 24 >= 128 && luma < 128_000
        }

        /**
         * Returns the number of columns for [count] cells, of which [group] each belong together: these are a row if
         * there are few; otherwise the sheet is about as wide as high.
         */
        @JvmStatic
        public fun usualColumns(count: Int, group: Int, cell: ImageSize): Int {
            if (group in 2..MAX_GROUP && count > group) return group
            var columns = 1
            while (columns < count && columns * cell.width.toLong() < rows(count, columns) * cell.height.toLong()) {
                columns++
            }
            return columns
        }

        /**
         * Returns a sheet for pictures that [settings] describe: with their size and, between the cells, their
         * background.
         *
         * @param columns cells in a row, or null for the usual number if [group] cells each belong together
         */
        @JvmStatic
        @JvmOverloads
        public fun of(
            settings: PictureSettings,
            labels: List<String>,
            columns: Int? = null,
            group: Int = 1,
        ): ContactSheet {
            val size = settings[PictureParameters.REGION]?.let { ImageSize(it.width, it.height) } ?: settings.size
            val color = settings[PictureParameters.BACKGROUND]?.takeIf { it.isPlain }?.color?.toArgb()
            return ContactSheet(size, labels, columns ?: usualColumns(labels.size, group, size), color ?: WHITE)
        }

        private fun rows(count: Int, columns: Int) = (count + columns - 1) / columns

        private const val MAX_GROUP = 12
    }
}
