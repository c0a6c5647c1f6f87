package dev.lazyz.cli.output

import com.github.ajalt.mordant.rendering.TextAlign

/** Formats [Statistics] as a table. */
internal object StatisticsTable {
    fun of(statistics: Statistics): String = PlainTable.of {
        column(1) { align = TextAlign.RIGHT }
        body { statistics.entries.forEach { (key, value) -> row(key, readable(key, value)) } }
    }

    /** Returns a value of the statistics with its unit and with separators. */
    fun readable(key: String, value: Any): String = when {
        key == "peakBytes" -> Bytes.readable(value as Long)
        key == "coverage" -> "%.2f %%".format(null, 100 * value as Double)
        value is Long -> "%,d".format(null, value)
        value is Double -> "%.2f".format(null, value)
        else -> value.toString()
    }
}
