package dev.lazyz.swing

import java.awt.BasicStroke
import java.awt.Color
import java.awt.Graphics2D
import java.awt.geom.Ellipse2D
import java.awt.geom.Line2D
import java.awt.geom.Point2D

/** Half the width of a dot. */
internal const val DOT_RADIUS: Double = 7.0

/** Draws a circle with a dot in it, which can be seen on any background. */
internal fun Graphics2D.drawDot(at: Point2D, color: Color) {
    val circle = Ellipse2D.Double(at.x - DOT_RADIUS, at.y - DOT_RADIUS, 2 * DOT_RADIUS, 2 * DOT_RADIUS)
    this.color = Color.WHITE
    stroke = BasicStroke(4f)
    draw(circle)
    this.color = color
    stroke = BasicStroke(2f)
    draw(circle)
    draw(Line2D.Double(at.x - 1, at.y, at.x + 1, at.y))
}

/** Draws the lines of [text] in the upper left corner. */
internal fun Graphics2D.drawLines(text: String, foreground: Color, background: Color) {
    text.lines().forEachIndexed { line, words ->
        val y = MARGIN + line * fontMetrics.height
        color = background
        fillRect(MARGIN - 2, y, fontMetrics.stringWidth(words) + 4, fontMetrics.height)
        color = foreground
        drawString(words, MARGIN, y + fontMetrics.ascent)
    }
}

private const val MARGIN = 10
