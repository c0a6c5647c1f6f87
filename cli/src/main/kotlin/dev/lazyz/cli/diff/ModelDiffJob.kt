package dev.lazyz.cli.diff

import dev.lazyz.Image
import dev.lazyz.Renderer
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.BlankPictures
import dev.lazyz.cli.output.Json
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Choices
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.scenes.diff.ModelDifference
import dev.lazyz.scenes.html.Html
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
    private val old: Subject,
    private val new: Subject,
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
        for (subject in listOf(old, new)) subject.requireKept(replaced)
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
