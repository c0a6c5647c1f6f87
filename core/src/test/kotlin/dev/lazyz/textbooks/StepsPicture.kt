package dev.lazyz.textbooks

import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Draws the steps of a worked example as SVG: a grid of depths after each step, coloured by the visible shape. */
internal object StepsPicture {
    private const val CELL = 28
    private const val GAP = 24
    private const val TITLE = 26
    private const val MARGIN = 12
    private val colors = listOf("#bfdbfe", "#fde68a", "#bbf7d0")

    fun of(example: WorkedExample): String = buildString {
        val steps = example.shapes.size + 1

        // Grids of one row are below each other, others side by side
        val isTall = example.height > 1
        val stepX = if (isTall) example.width * CELL + GAP else 0
        val stepY = if (isTall) 0 else example.height * CELL + TITLE + GAP / 2
        val width = 2 * MARGIN + example.width * CELL + stepX * (steps - 1)
        val height = 2 * MARGIN + TITLE + example.height * CELL + stepY * (steps - 1)
        append("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 $width $height\" ")
        append("width=\"$width\" height=\"$height\" font-family=\"sans-serif\" font-size=\"13\">\n")
        append("<title>${example.title}</title>\n<rect width=\"$width\" height=\"$height\" fill=\"#ffffff\"/>\n")
        for (step in 0 until steps) grid(example, step, MARGIN + step * stepX, MARGIN + step * stepY)
        append("</svg>\n")
    }

    private fun StringBuilder.grid(example: WorkedExample, step: Int, left: Int, top: Int) {
        val label = if (step == 0) "empty" else "after ${example.shapes[step - 1].name}"
        append("<text x=\"$left\" y=\"${top + TITLE - 10}\" fill=\"#0f172a\">$label</text>\n")
        val image = ZBufferRenderer().render(example.frame(step))
        val depths = example.depthsOf(image)
        for (y in 0 until example.height) {
            for (x in 0 until example.width) {
                val owner = image.primitive(x, y)
                val cellX = left + x * CELL
                val cellY = top + TITLE + y * CELL
                append("<rect x=\"$cellX\" y=\"$cellY\" width=\"$CELL\" height=\"$CELL\" ")
                append("fill=\"${if (owner < 0) "#ffffff" else colors[owner]}\" stroke=\"#334155\"/>")
                append("<text x=\"${cellX + CELL / 2}\" y=\"${cellY + CELL / 2 + 5}\" text-anchor=\"middle\" ")
                append("fill=\"#0f172a\">${depths[y][x].trim().replace("inf", "∞")}</text>\n")
            }
        }
    }
}
