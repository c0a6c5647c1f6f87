package dev.lazyz.cli.page

import dev.lazyz.scenes.html.Html.escaped

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
