package dev.lazyz.testing

import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped

/** The page that shows failures side by side: HTML with all pictures in it, so that one file can be kept or sent. */
internal object FailurePage {
    private val style = """
        body { font: 15px/1.5 system-ui, sans-serif; margin: 2em; color: #222; background: #fff; }
        article { border-top: 1px solid #ccc; padding: 0 0 1.5em; }
        h2 { margin-bottom: 0; }
        pre { background: #f4f4f4; padding: .6em; white-space: pre-wrap; }
        .side { display: flex; flex-wrap: wrap; gap: 1em; }
        figure { margin: 0; flex: 1 1 16em; }
        img { width: 100%; max-width: 60em; border: 1px solid #ccc; image-rendering: pixelated;
              background: repeating-conic-gradient(#ddd 0 25%, #fff 0 50%) 0 0 / 16px 16px; }
    """.trimIndent()

    /** Returns the page of these [parts]. */
    fun of(parts: List<String>): String = """
        |<!DOCTYPE html>
        |<html lang="en">
        |<head>
        |<meta charset="utf-8">
        |<title>Golden pictures: ${parts.size} different</title>
        |<style>
        |$style
        |</style>
        |</head>
        |<body>
        |<h1>Golden pictures: ${parts.size} different</h1>
        |<p>From the last run of each test class. In the difference, pixels that differ are yellow to red, and pixels that
        |only one picture has are blue. If the actual picture is right, run the test with
        |<code>-D${GoldenSettings.UPDATE}=true</code>.</p>
        |
    """.trimMargin() + parts.joinToString("") + "</body>\n</html>\n"

    /** Returns the part of the page that shows [failure] of the class [test]. */
    fun part(test: String, failure: GoldenFailure): String = buildString {
        appendLine("<article>")
        appendLine("<h2>${escaped(failure.golden)}</h2>")
        appendLine("<p>${escaped(test)}</p>")
        appendLine("<pre>${escaped(failure.problem)}</pre>")
        appendLine("<div class=\"side\">")
        append(figure("expected", failure.expected))
        append(figure("actual", failure.actual.png))
        append(figure("difference", failure.difference))
        appendLine("</div>")
        appendLine("</article>")
    }

    private fun figure(caption: String, png: ByteArray?): String {
        if (png == null) return "<figure><figcaption>$caption: none</figcaption></figure>\n"
        val image = "<img alt=\"$caption\" src=\"${Html.pngUri(png)}\">"
        return "<figure><figcaption>$caption</figcaption>$image</figure>\n"
    }
}
