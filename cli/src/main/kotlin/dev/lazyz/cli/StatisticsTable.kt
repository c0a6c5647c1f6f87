package dev.lazyz.cli

import com.github.ajalt.mordant.rendering.AnsiLevel
import com.github.ajalt.mordant.rendering.BorderType
import com.github.ajalt.mordant.rendering.TextAlign
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.table
import com.github.ajalt.mordant.terminal.Terminal

/** Lays [Statistics] out for people. The only place that loads Mordant. */
internal object StatisticsTable {
    private const val WIDTH = 100

    fun of(statistics: Statistics): String {
        val table = table {
            borderType = BorderType.ASCII
            cellBorders = Borders.LEFT_RIGHT
            tableBorders = Borders.ALL
            column(1) { align = TextAlign.RIGHT }
            body { statistics.entries.forEach { (key, value) -> row(key, readable(key, value)) } }
        }
        return Terminal(ansiLevel = AnsiLevel.NONE, width = WIDTH).render(table).trimEnd() + "\n"
    }

    private fun readable(key: String, value: Any): String = when {
        key == "peakBytes" -> Bytes.readable(value as Long)
        key == "coverage" -> "%.2f %%".format(null, 100 * value as Double)
        value is Long -> "%,d".format(null, value)
        value is Double -> "%.2f".format(null, value)
        else -> value.toString()
    }
}
