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
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.output.printable
import dev.lazyz.cli.page.Page
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.diff.Measure
import dev.lazyz.scenes.diff.ModelDifference
import dev.lazyz.scenes.diff.ModelDifference.Change
import dev.lazyz.scenes.diff.PartDifference
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.scenes.writers.writePng
import dev.lazyz.strategies.tiled.TiledRenderer
import java.math.BigDecimal
import java.math.MathContext
import java.nio.file.Path
import kotlin.math.abs
import kotlinx.serialization.json.JsonElement

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

/** The [difference] of the models [old] and [new] as text and as JSON. Scripts depend on the names in [toJson]. */
internal class ModelDiffText(private val old: String, private val new: String, val difference: ModelDifference) {
    /** The result in one line. */
    val verdict: String = "$new ${if (difference.isEqual) "is equal to" else "differs from"} $old"

    /** The parts that differ; none if both models have only one. */
    val changedParts: List<PartDifference> =
        if (difference.parts.size > 1) difference.parts.filter { !it.isEqual } else emptyList()

    /** What changed, in words. */
    val pixels: String = Change.entries.joinToString(prefix = "pixels: ") {
        counted(difference.count(it), it.id, it.id)
    }

    /** What is printed. */
    val lines: String = buildString {
        appendLine(printable(verdict))
        appendLine(pixels)
        append("".padEnd(COLUMN))
        appendLine(listOf("old", "new", "difference").joinToString("") { it.padStart(COLUMN) })
        for (measure in Measure.entries) {
            append(title(measure).padEnd(COLUMN))
            appendLine(texts(measure, difference.whole).joinToString("") { it.padStart(COLUMN) })
        }
        for (part in changedParts) appendLine("${part.change} part: ${printable(part.name)}${details(part)}")
    }

    fun toJson(): JsonElement = Json.element(difference.toData(old, new))

    companion object {
        private const val COLUMN = 14

        fun title(measure: Measure): String = measure.name.lowercase().replace('_', ' ')

        /** Returns [measure] of [part] before and after, and the difference, as text; `-` if there is none. */
        fun texts(measure: Measure, part: PartDifference): List<String> {
            val texts = values(measure, part).map { it?.let { value -> text(measure, value) } ?: "-" }
            return texts.take(2) + (if ((part.difference(measure) ?: 0.0) > 0) "+" else "").plus(texts[2])
        }

        /** Returns the numbers of [part] that changed: `, area 1 to 2`. */
        fun details(part: PartDifference): String = Measure.entries.map { it to texts(it, part) }
            .filter { (_, texts) -> "-" !in texts && texts[2] != "0" }
            .joinToString("") { (measure, texts) -> ", ${title(measure)} ${texts[0]} to ${texts[1]}" }

        private fun values(measure: Measure, part: PartDifference): List<Double?> =
            listOf(part.before?.get(measure), part.after?.get(measure), part.difference(measure))

        private fun text(measure: Measure, value: Double): String {
            if (measure.isCount) return "%,d".format(null, value.toLong())
            val digits = BigDecimal(value).round(MathContext(DIGITS)).stripTrailingZeros()
            return if (value == 0.0 || abs(value) in 1e-4..1e9) digits.toPlainString() else digits.toString()
        }

        private const val DIGITS = 7
    }
}
