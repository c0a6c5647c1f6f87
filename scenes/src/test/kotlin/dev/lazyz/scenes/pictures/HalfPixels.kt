package dev.lazyz.scenes.pictures

/**
 * An SVG file that [PictureDrawing] wrote, drawn without anti-aliasing at points that are half a pixel apart. Only what
 * these files have is understood.
 */
internal class HalfPixels(svg: String, width: Int, height: Int) {
    private val columns = 2 * width + 1
    private val rows = 2 * height + 1
    private val colors = IntArray(columns * rows) { 0xFFFFFF }
    private val styles =
        Regex("""([.,a-z]+)\{(.*)}""").findAll(svg).map { it.groupValues[1] to it.groupValues[2] }.toList()

    init {
        for (path in Regex("""<path class="([^"]+)" d="([^"]*)"/>""").findAll(svg)) {
            val (names, data) = path.destructured
            val lines = data.split("M").drop(1).map(::points)
            val fill = value(names, "fill").orEmpty()
            if (fill != "none") fill(lines, color(fill))
            val stroke = value(names, "stroke").orEmpty()
            if (stroke == "none") continue
            val half = checkNotNull(value(names, "stroke-width")).toDouble() / 2
            for (line in lines) stroke(line, half, color(stroke))
        }
    }

    /** The colours at most half a pixel from the middle of a pixel. */
    fun around(x: Int, y: Int): Set<Int> = (0..8).map { colors[(2 * y + it / 3) * columns + 2 * x + it % 3] }.toSet()

    private fun value(names: String, property: String): String? = styles
        .filter { (selector, _) -> selector.split(",").any { it.removePrefix(".") in names.split(" ") } }
        .mapNotNull { (_, text) -> Regex("(^|;)$property:([^;]+)").find(text)?.groupValues?.get(2) }.lastOrNull()

    private fun color(text: String) = text.removePrefix("#").toInt(16)

    private fun points(data: String): List<Pair<Double, Double>> {
        val numbers = Regex("-?[0-9.]+").findAll(data.trim().removeSuffix("h0")).map { it.value.toDouble() }.toList()
        val points = arrayListOf(numbers[0] to numbers[1])
        for (i in 2 until numbers.size step 2) {
            points += points.last().first + numbers[i] to points.last().second + numbers[i + 1]
        }
        return if ("z" in data) points + points.first() else points
    }

    private fun stroke(line: List<Pair<Double, Double>>, half: Double, color: Int) {
        for ((a, b) in if (line.size == 1) listOf(line[0] to line[0]) else line.zipWithNext()) {
            val x = b.first - a.first
            val y = b.second - a.second
            fun cells(from: Double, until: Double, most: Int): IntRange {
                val first = maxOf(0, (2 * (minOf(from, until) - half)).toInt())
                return first..minOf(most - 1, (2 * (maxOf(from, until) + half)).toInt() + 1)
            }
            for (row in cells(a.second, b.second, rows)) {
                for (column in cells(a.first, b.first, columns)) {
                    val toX = column / 2.0 - a.first
                    val toY = row / 2.0 - a.second
                    val along = if (x == 0.0 && y == 0.0) 0.0 else (toX * x + toY * y) / (x * x + y * y)
                    val t = along.coerceIn(0.0, 1.0)
                    if (StrictMath.hypot(toX - t * x, toY - t * y) <= half) colors[row * columns + column] = color
                }
            }
        }
    }

    private fun fill(contours: List<List<Pair<Double, Double>>>, color: Int) {
        for (row in 0 until rows) {
            val y = row / 2.0
            val crossings = contours.flatMap { it.zipWithNext() }
                .filter { (a, b) -> (a.second <= y) != (b.second <= y) }
                .map { (a, b) ->
                    a.first + (y - a.second) / (b.second - a.second) * (b.first - a.first) to
                        if (a.second <= y) 1 else -1
                }
            for (column in 0 until columns) {
                if (crossings.sumOf { (x, sign) -> if (x <= column / 2.0) sign else 0 } != 0) {
                    colors[row * columns + column] = color
                }
            }
        }
    }
}
