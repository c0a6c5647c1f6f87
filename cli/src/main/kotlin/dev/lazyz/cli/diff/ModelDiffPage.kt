package dev.lazyz.cli.diff

import dev.lazyz.Image
import dev.lazyz.cli.page.Page
import dev.lazyz.scenes.diff.Measure
import dev.lazyz.scenes.diff.ModelDifference.Change
import dev.lazyz.scenes.html.Html.escaped

/** What changed in a model, as one page of HTML. [images] are the pictures before, after, and of the changes. */
internal class ModelDiffPage(private val text: ModelDiffText, private val images: List<Image>) {
    private val page = Page(text.verdict)
    private val difference = text.difference

    fun html(): String = page.html(
        buildString {
            val (look, sign) = if (difference.isEqual) "good" to "✓" else "bad" to "✗"
            appendLine("<header><h1>What changed</h1>")
            appendLine("""<p class="verdict $look"><strong>$sign ${escaped(text.verdict)}</strong></p></header>""")
            appendLine("""<div class="grid">""")
            for ((name, image) in listOf("before", "after", "difference").zip(images)) {
                val shown = page.pictures.show(image, if (name == "difference") "$name; ${text.pixels}" else name)
                appendLine("<figure>$shown<figcaption>$name</figcaption></figure>")
            }
            appendLine("""</div><ul class="legend">""")
            for (change in Change.entries) {
                val color = "#%06x".format(null, change.color)
                append("""<li><span class="swatch" style="background:$color"></span> """)
                appendLine("%s: %,d pixels</li>".format(null, ModelDiffText.word(change), difference.count(change)))
            }
            appendLine("</ul>")
            numbers()
            if (text.changedParts.isNotEmpty()) parts()
        },
    )

    private fun StringBuilder.numbers() = table("Numbers", listOf("", "old", "new", "difference")) {
        for (measure in Measure.entries) {
            row(ModelDiffText.title(measure), ModelDiffText.texts(measure, difference.whole))
        }
    }

    private fun StringBuilder.parts() {
        val columns = Measure.entries - Measure.PARTS
        table("Parts that changed", listOf("part", "") + columns.map(ModelDiffText::title)) {
            for (part in text.changedParts) {
                val cells = columns.map { ModelDiffText.texts(it, part) }.map { (old, new, _) ->
                    if (old == new) old else "$old → $new"
                }
                row(part.name, listOf(ModelDiffText.change(part)) + cells)
            }
        }
    }

    private fun StringBuilder.table(title: String, columns: List<String>, rows: () -> Unit) {
        appendLine("""<h2>$title</h2><div class="scroll" role="region" tabindex="0" aria-label="$title"><table>""")
        appendLine(columns.joinToString("", "<thead><tr>", "</tr></thead><tbody>") { """<th scope="col">$it</th>""" })
        rows()
        appendLine("</tbody></table></div>")
    }

    private fun StringBuilder.row(name: String, cells: List<String>) {
        val all = cells.joinToString("") { "<td>${escaped(it)}</td>" }
        appendLine("""<tr><th scope="row">${escaped(name)}</th>$all</tr>""")
    }
}
