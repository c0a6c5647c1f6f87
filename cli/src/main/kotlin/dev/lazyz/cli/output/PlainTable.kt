package dev.lazyz.cli.output

import com.github.ajalt.mordant.rendering.AnsiLevel
import com.github.ajalt.mordant.rendering.BorderType
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.TableBuilder
import com.github.ajalt.mordant.table.table
import com.github.ajalt.mordant.terminal.Terminal

/** Draws tables with ASCII characters, one line per row. The only class that loads Mordant. */
internal object PlainTable {
    private const val WIDTH = 120

    fun of(content: TableBuilder.() -> Unit): String {
        val table = table {
            borderType = BorderType.ASCII
            cellBorders = Borders.LEFT_RIGHT
            tableBorders = Borders.ALL
            content()
        }
        return Terminal(ansiLevel = AnsiLevel.NONE, width = WIDTH).render(table).trimEnd() + "\n"
    }
}
