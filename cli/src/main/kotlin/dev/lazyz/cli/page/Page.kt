package dev.lazyz.cli.page

import dev.lazyz.Image
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.scenes.writers.toPng

/**
 * A page of HTML that is one file: style, pictures and script are in it, and browsers may load nothing else.
 *
 * @param title what the page is about, plain text
 */
internal class Page(private val title: String) {
    /** The pictures of the page. */
    val pictures = PictureStore()

    /**
     * Returns the page.
     *
     * @param content the main part, HTML
     * @param script what makes the page move, or empty; all content must be there without it
     */
    fun html(content: String, script: String = ""): String = buildString {
        val sources = listOf("default-src 'none'", "img-src data:", "style-src 'unsafe-inline'") +
            (if (script.isEmpty()) emptyList() else listOf("script-src 'unsafe-inline'"))
        appendLine("<!DOCTYPE html>")
        appendLine("""<html lang="en">""")
        appendLine("<head>")
        appendLine("""<meta charset="utf-8">""")
        appendLine("""<meta name="viewport" content="width=device-width, initial-scale=1">""")
        appendLine("""<meta name="color-scheme" content="light dark">""")
        appendLine("""<meta http-equiv="Content-Security-Policy" content="${sources.joinToString("; ")}">""")
        appendLine("""<link rel="icon" href="data:,">""")
        appendLine("<title>${escaped(title)}</title>")
        appendLine("<style>")
        append(resource(Page::class.java, "page.css"))
        appendLine("</style>")
        appendLine("</head>")
        appendLine("<body>")
        appendLine("""<a class="skip" href="#content">Skip to the content</a>""")
        appendLine("""<main id="content">""")
        append(content)
        appendLine("</main>")
        append(pictures.definitions())
        if (script.isNotEmpty()) append("<script>\n").append(script).append("</script>\n")
        appendLine("</body>")
        appendLine("</html>")
    }

    companion object {
        /** Returns the text of the file [name] beside the class [place]. */
        fun resource(place: Class<*>, name: String): String {
            val stream = checkNotNull(place.getResourceAsStream(name)) { "$name is missing in the jar" }
            return stream.use { it.readAllBytes().decodeToString() }
        }
    }
}

/**
 * A chart of horizontal bars that begin at 0, as SVG. It is as wide as its place, and the text keeps its size.
 *
 * @param title what the bars show
 * @param partName what the last part of a bar shows, in the description
 */
internal class BarChart(private val title: String, private val bars: List<Bar>, private val partName: String = "") {
    /**
     * A bar.
     *
     * @property value its length, 0 or more, or null if there is none
     * @property text the value as text, or why there is none
     * @property part so much of [value] is drawn in another colour, at the end
     */
    class Bar(val label: String, val value: Double?, val text: String, val part: Double = 0.0)

    private val most = bars.mapNotNull { it.value }.maxOrNull()?.takeIf { it > 0 } ?: 1.0

    /** Returns the chart. All its numbers are in its description, too. */
    fun svg(): String = buildString {
        val height = bars.size * ROW
        append("""<svg class="bars" role="img" width="100%" height="$height" aria-label="${escaped(description())}">""")
        appendLine()
        for ((number, bar) in bars.withIndex()) append(bar, number * ROW)
        appendLine("</svg>")
    }

    private fun description(): String = bars.joinToString("; ", "$title: ") { bar ->
        val part = if (bar.part > 0) " ($partName ${percent(bar.part / checkNotNull(bar.value))})" else ""
        "${bar.label} ${bar.text}$part"
    }

    private fun StringBuilder.append(bar: Bar, top: Int) {
        appendLine("""<text x="0" y="${top + BASE_LINE}">${escaped(bar.label)}</text>""")
        appendLine("""<text class="value" x="100%" y="${top + BASE_LINE}">${escaped(bar.text)}</text>""")
        appendLine(rectangle("track", top, 0.0, 1.0))
        val value = bar.value ?: return
        appendLine(rectangle("bar", top, 0.0, (value - bar.part) / most))
        if (bar.part > 0) appendLine(rectangle("part", top, (value - bar.part) / most, bar.part / most))
    }

    private fun rectangle(look: String, top: Int, start: Double, length: Double): String =
        """<rect class="$look" x="${percent(start)}" y="${top + BAR_TOP}" width="${percent(length)}" """ +
            """height="$BAR_HEIGHT"/>"""

    private fun percent(part: Double): String = "%.2f%%".format(null, 100 * part)

    private companion object {
        const val ROW = 36
        const val BASE_LINE = 13
        const val BAR_TOP = 19
        const val BAR_HEIGHT = 8
    }
}

/** The pictures of a page. A picture that is shown several times is stored once. */
internal class PictureStore {
    /** The numbers of pictures by size and pixel hash. */
    private val numbers = HashMap<String, Int>()
    private val definitions = StringBuilder()

    /**
     * Returns HTML that shows [image], as wide as its place.
     *
     * @param description what it shows, for readers who do not see it
     */
    fun show(image: Image, description: String): String {
        val key = "${image.width}x${image.height} ${image.pixelHash()}"
        val number = numbers[key] ?: define(image).also { numbers[key] = it }
        val look = if (image.width <= SMALL) "picture pixels" else "picture"
        return """<svg class="$look" role="img" aria-label="${escaped(description)}" """ +
            """viewBox="0 0 ${image.width} ${image.height}"><use href="#picture-$number"/></svg>"""
    }

    /** Returns the pictures themselves, which [show] refers to. */
    fun definitions(): String =
        if (definitions.isEmpty()) "" else "<svg class=\"store\" aria-hidden=\"true\">\n$definitions</svg>\n"

    private fun define(image: Image): Int {
        val number = numbers.size + 1
        val size = """width="${image.width}" height="${image.height}""""
        definitions.append("""<symbol id="picture-$number" viewBox="0 0 ${image.width} ${image.height}">""")
            .append("""<image $size href="""").append(Html.pngUri(image.toPng())).append("\"/></symbol>\n")
        return number
    }

    private companion object {
        /** Pictures of at most so many columns are enlarged without smoothing. */
        const val SMALL = 400
    }
}
