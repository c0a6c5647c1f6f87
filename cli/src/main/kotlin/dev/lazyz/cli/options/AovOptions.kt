package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.RawOption
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.aov.Aov
import dev.lazyz.cli.render.AovOutput
import dev.lazyz.cli.render.AovOutputs
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.text.EditDistance
import java.nio.file.Path

/** Options of arbitrary output variables. */
internal class AovOptions : OptionGroup("Data of pixels (AOVs)") {
    private val data by option(
        "--aov",
        help = "Write what is known of each pixel as data: ${NamedValues.list(ids)}; the extension of FILE " +
            "chooses the format, .pfm, .npy, .png (16 bits), .npz, which takes several, AOV,AOV=FILE.npz, or " +
            "all=FILE.npz, or, for object, .json, a list of visible parts with their names; repeat for more files",
    ).output().multiple()

    private val pictures by option(
        "--aov-picture",
        help = "Write a picture of the same data, with colours and a legend, a .png file; repeat for more",
    ).output().multiple()

    /** What the options ask for. */
    val outputs: AovOutputs get() = AovOutputs(data, pictures)

    private fun RawOption.output() = convert("AOV=FILE", Completions.names { ids + ALL }) { text ->
        val file = text.substringAfter('=', "")
        val words = text.substringBefore('=').lowercase()
        if (file.isEmpty() || words.isEmpty()) fail("'$text' is not AOV=FILE, such as depth=depth.png")
        val aovs = if (words == ALL) {
            Aov.entries
        } else {
            val known = words.split(',')
            known.groupBy { it }.values.firstOrNull { it.size > 1 }?.let { fail("'${it[0]}' is named twice: $text") }
            known.map { word ->
                Aov.ofId(word)
                    ?: fail("'$word' is not one of $ALL, ${ids.joinToString()}${EditDistance.hint(word, ids + ALL)}")
            }
        }
        AovOutput(aovs, Path.of(file))
    }

    private companion object {
        const val ALL = "all"
        val ids = Aov.entries.map { it.id }
    }
}
