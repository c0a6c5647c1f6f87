package dev.lazyz.cli.batch

import dev.lazyz.cli.input.Input
import dev.lazyz.cli.output.printable
import java.nio.file.Path
import kotlin.io.path.name

/**
 * What the [inputs] are called in labels and messages: the names of their files, without extension. Those that would be
 * the same get what tells them apart, the extension or so many folders as are necessary.
 */
internal class InputLabels(private val inputs: List<String>) {
    private val labels: List<String> = inputs.map { label(it, 0, false) }.toMutableList().also { all ->
        val levels = inputs.maxOfOrNull { Path.of(it).nameCount } ?: 0
        for (same in all.indices.groupBy { all[it] }.values.filter { it.size > 1 }) {
            val ways = (0 until levels).asSequence().flatMap { listOf(it to false, it to true) }
            val others = same.map { inputs[it] }.distinct()
            val (folders, isWhole) = ways.firstOrNull { (folders, isWhole) ->
                others.map { label(it, folders, isWhole) }.distinct().size == others.size
            } ?: continue
            for (number in same) all[number] = label(inputs[number], folders, isWhole)
        }
    }

    /** Returns the label of the input with this number. */
    operator fun get(number: Int): String = labels[number]

    /** Returns a label of [word] with so many [folders], and with its extension if it [isWhole]. */
    private fun label(word: String, folders: Int, isWhole: Boolean): String {
        val input = Input(word, null)
        val base = input.baseName ?: return printable(input.name)
        val path = input.file ?: return base
        val above = (path.parent?.map { "$it" }.orEmpty()).takeLast(folders)
        return printable((above + if (isWhole) path.name else base).joinToString("/"))
    }
}
