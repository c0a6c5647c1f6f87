package dev.lazyz.cli.diff

import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.page.Page
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.diff.Measure
import dev.lazyz.scenes.diff.ModelDifference
import dev.lazyz.scenes.diff.ModelDifference.Change
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.scenes.writers.writePng
import dev.lazyz.strategies.tiled.TiledRenderer
import java.nio.file.Path

/**
 * One run of `zcli diff` with the models [old] and [new].
 *
 * @param output where to write a page, or a page and pictures, or null
 * @param marked where to write the picture of the changes, or null
 */
internal class ModelDiffJob(
    private val old: ShownInput,
    private val new: ShownInput,
    private val output: Path?,
    private val marked: Path?,
    private val choices: Choices,
    private val blanks: BlankPictures,
    private val streams: Streams,
) {
    /** Compares the models, prints the result and writes the files. Returns whether the models are equal. */
    fun run(isJson: Boolean): Boolean {
        val place = output?.let { ReportPlace(it, "-o") }
        val pictures = PICTURES.map { name -> place?.folder?.resolve(name) }
        val files = (pictures + place?.page).mapNotNull { file -> file?.let { "-o" to it } } +
            listOfNotNull(marked?.let { "--diff" to it })
        OutputFile.requireDistinct(files)
        val replaced = OutputPlaces(files)
        val renderer = renderer()
        for (shown in listOf(old, new)) shown.requireKept(replaced)
        val sources = listOf(old, new).map { FrameSource(it, streams) }
        val (was, now) = sources.map { source -> source.load().also { source.requireKept(it, replaced) } }
        val (before, after) = sources.zip(listOf("before", "after")) { source, name -> source.observer(name) }
        val difference = ModelDifference.between(was, now, old.settings, renderer, choices.options(), before, after)
        val text = ModelDiffText(sources[0].input.name, sources[1].input.name, difference)
        blanks.report(difference.before, streams, "before")
        blanks.report(difference.after, streams, "after")

        val images = listOf(difference.before, difference.after, difference.toImage())
        (pictures + marked).zip(images + images[2]) { file, image -> file?.let { write(it, image) } }
        place?.page?.let { page ->
            OutputFile.createFolder(page)
            Html.write(page, ModelDiffPage(text, images).html())
            streams.remark("wrote $page")
        }
        streams.print(if (isJson) Json.of(text.toJson()) + "\n" else text.lines)
        return difference.isEqual
    }

    private fun write(file: Path, image: Image) {
        OutputFile.createFolder(file)
        image.writePng(file)
        streams.remark("wrote $file")
    }

    private fun renderer(): Renderer {
        val tiled = TiledRenderer()
        val missing = Strategies.missing(choices.needs, tiled.capabilities) ?: return choices.applyTo(tiled)
        throw Mistake("models are compared with the strategy '${tiled.id}', which does not support $missing")
    }

    private companion object {
        val PICTURES = listOf("before.png", "after.png", "difference.png")
    }
}

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
                appendLine("%s: %,d pixels</li>".format(null, change.id, difference.count(change)))
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
                row(part.name, listOf(part.change) + cells)
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
