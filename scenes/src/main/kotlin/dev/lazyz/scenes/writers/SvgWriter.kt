package dev.lazyz.scenes.writers

import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.drawing.EdgeDrawing
import dev.lazyz.drawing.EdgeDrawing.DrawnCap
import dev.lazyz.drawing.EdgeDrawing.DrawnLine
import dev.lazyz.drawing.EdgeDrawing.LineKind
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import java.io.BufferedOutputStream
import java.io.OutputStream
import java.util.Base64
import kotlin.math.floor

/**
 * Writes a line drawing as SVG 1.1. Coordinates are pixels of the picture, rounded to hundredths; the numbers are
 * written by integer arithmetic. Points that are then on the straight line between their neighbours are left out. Each
 * class of lines is one path. Not thread safe.
 *
 * Source: "Scalable Vector Graphics (SVG) 1.1", second edition, W3C.
 */
internal class SvgWriter(output: OutputStream) {
    private val output = BufferedOutputStream(output, BUFFER)

    /** Cells of a grid in which a line is so short that it is a dot; one for each is enough. */
    private val dots = HashSet<Long>()

    // The points of the polyline that is written, hundredths of a pixel
    private var kept = LongArray(64)
    private var size = 0

    /** Writes the head of a drawing of [pixels]; [pixelSize] is that of a pixel in millimetres, or null. */
    fun begin(pixels: Region, pixelSize: Double?) {
        fun side(count: Int) = if (pixelSize == null) "$count" else decimal(count * pixelSize, SIZE_DIGITS) + "mm"
        text("<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"")
        text(" width=\"${side(pixels.width)}\" height=\"${side(pixels.height)}\"")
        text(" viewBox=\"${pixels.columnStart} ${pixels.rowStart} ${pixels.width} ${pixels.height}\">\n")
    }

    /**
     * Writes the styles of all classes.
     *
     * @param background the colour of the background, or null if there is none
     * @param caps the colours of caps and of their stripes, which may be null; the first counts
     */
    fun styles(style: EdgeStyle, background: Rgba?, caps: List<Pair<Rgba, Rgba?>>) {
        text("<style>\n")
        if (background != null) text(".background{fill:${color(background)}}\n")
        caps.firstOrNull()?.let { (ground, stripe) ->
            text(".cap{fill:${color(ground)};fill-rule:nonzero;stroke:none}\n")
            if (stripe != null) text(".hatch{fill:${color(stripe)};fill-rule:nonzero;stroke:none}\n")
        }
        text(LineKind.entries.joinToString(",") { ".${className(it)}" })
        text("{fill:none;stroke:${color(style.color)};stroke-width:${width(style.width)}")
        text(";stroke-linecap:round;stroke-linejoin:round}\n")
        if (style.hidden != HiddenLines.NONE) {
            text(".hidden{stroke:${color(style.hiddenColor)}")
            text(";stroke-width:${width(style.width * EdgeStyle.HIDDEN_SHARE)}")
            if (style.hidden == HiddenLines.DASHED) {
                val dash = width(style.width * EdgeDrawing.DASH)
                text(";stroke-dasharray:$dash ${width(style.width * EdgeDrawing.GAP)}")
            }
            text("}\n")
        }
        text("</style>\n")
    }

    /** Writes a background behind [pixels]. */
    fun background(pixels: Region): Unit = text("<rect class=\"background\" ${place(pixels)}/>\n")

    /** Calls [render] with a sink for the picture of [pixels]. */
    fun image(pixels: Region, alpha: AlphaChannel, render: (RowSink) -> Unit) {
        text("<image ${place(pixels)} xlink:href=\"data:image/png;base64,")
        val encoded = Base64.getEncoder().wrap(NonClosingStream(output))
        PngSink(encoded, pixels.width, pixels.height, alpha).use(render)
        text("\"/>\n")
    }

    private fun place(pixels: Region) = "x=\"${pixels.columnStart}\" y=\"${pixels.rowStart}\" " +
        "width=\"${pixels.width}\" height=\"${pixels.height}\""

    /** Writes [cap] and its stripes. */
    fun cap(cap: DrawnCap) {
        for ((name, contours) in listOf("cap" to cap.contours, "hatch" to cap.stripes)) {
            if (contours.isEmpty()) continue
            text("<path class=\"$name\" d=\"")
            for (contour in contours) polyline(contour, isClosed = true)
            text("\"/>\n")
        }
    }

    /** Writes [lines], which are of one class. */
    fun lines(kind: LineKind, isHidden: Boolean, lines: List<DrawnLine>) {
        dots.clear()
        text("<path class=\"${className(kind)}${if (isHidden) " hidden" else ""}\" d=\"")
        for (line in lines) polyline(line.points)
        text("\"/>\n")
    }

    /** Writes the end of the file, and flushes the stream. */
    fun end() {
        text("</svg>\n")
        output.flush()
    }

    private fun polyline(points: DoubleArray, isClosed: Boolean = false) {
        size = 0
        for (i in points.indices step 2) keep(hundredths(points[i]), hundredths(points[i + 1]))
        val least = if (isClosed) TRIANGLE else TRIANGLE + 2
        val returns = size >= least && kept[0] == kept[size - 2] && kept[1] == kept[size - 1]
        if (returns) size -= 2
        if (isClosed && size < TRIANGLE) return
        if (size == 2 && !dots.add(cell(kept[0]) shl Int.SIZE_BITS or (cell(kept[1]) and MASK))) return
        text("\nM${decimal(kept[0], 2)} ${decimal(kept[1], 2)}")
        if (size == 2) text("h0")
        for (i in 2 until size step 2) {
            text(if (i == 2) "l" else " ")
            text(decimal(kept[i] - kept[i - 2], 2))
            text(" ")
            text(decimal(kept[i + 1] - kept[i - 1], 2))
        }
        if (isClosed || returns) text("z")
    }

    private fun cell(place: Long): Long = Math.floorDiv(place, DOT_CELL)

    /** Adds a point, unless it is the last one; replaces the last one if that is on the way to it. */
    private fun keep(x: Long, y: Long) {
        if (size >= 2 && kept[size - 2] == x && kept[size - 1] == y) return
        if (size >= 4) {
            val runX = kept[size - 2] - kept[size - 4]
            val runY = kept[size - 1] - kept[size - 3]
            val nextX = x - kept[size - 2]
            val nextY = y - kept[size - 1]
            if (runX * nextY == runY * nextX && runX * nextX + runY * nextY > 0) size -= 2
        }
        if (size == kept.size) kept = kept.copyOf(2 * size)
        kept[size++] = x
        kept[size++] = y
    }

    private fun hundredths(place: Double): Long = floor(place * 100.0 + 0.5).toLong()

    private fun width(width: Double) = decimal(width, SIZE_DIGITS)

    /** Returns [value] with so many [digits] after the point at most, rounded half up. */
    private fun decimal(value: Double, digits: Int): String {
        var scale = 1.0
        repeat(digits) { scale *= 10.0 }
        return decimal(floor(value * scale + 0.5).toLong(), digits)
    }

    /** Returns the number of which [value] is the multiple by a power of ten, without zeros at its ends. */
    private fun decimal(value: Long, digits: Int): String {
        val text = StringBuilder()
        if (value < 0) text.append('-')
        val all = Math.abs(value).toString().padStart(digits + 1, '0')
        val whole = all.dropLast(digits)
        val part = all.takeLast(digits).trimEnd('0')
        if (whole != "0" || part.isEmpty()) text.append(whole)
        if (part.isNotEmpty()) text.append('.').append(part)
        return text.toString()
    }

    private fun color(color: Rgba): String = "#" + "%06x".format(null, color.toArgb() and 0xFFFFFF)

    private fun className(kind: LineKind) = kind.name.lowercase()

    private fun text(text: String) = output.write(text.toByteArray(Charsets.US_ASCII))

    private companion object {
        const val BUFFER = 1 shl 16

        /** Digits of widths and of millimetres after the point. */
        const val SIZE_DIGITS = 3

        /** Number of coordinates of a triangle. */
        const val TRIANGLE = 6

        /** Side of a cell of a dot: a quarter of a pixel, in hundredths. */
        const val DOT_CELL = 25L
        const val MASK = 0xFFFFFFFFL
    }
}
