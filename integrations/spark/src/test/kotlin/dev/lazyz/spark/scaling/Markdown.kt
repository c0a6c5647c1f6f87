package dev.lazyz.spark.scaling

import java.util.Locale
import kotlin.math.log10

/** The word for a split in tables. */
internal fun Split.label(): String = if (this == Split.RANGES) "near" else "mixed"

/** Formats as in English, whatever the locale. */
internal fun String.form(vararg values: Any): String = format(Locale.ROOT, *values)

/** A number with about three digits. */
internal fun Double.form(): String = when {
    this >= 100 -> "%,.0f".form(this)
    this >= 1 -> "%.1f".form(this)
    else -> "%.3f".form(this)
}

/** A share as percents. */
internal fun percent(share: Double): String = "%.0f%%".form(100 * share)

/** By how much a model is above what was measured. */
internal fun deviation(model: Double, measured: Double): String = "%+.0f%%".form(100 * (model / measured - 1))

/** A power of ten. */
internal fun power(triangles: Double): String = "10^" + "%.0f".form(log10(triangles))

/** Bytes in millions. */
internal fun Long.megabytes(): String = "%.1f".form(this / 1e6)

/** Rows of a table. */
internal class Rows(private val text: StringBuilder) {
    /** Adds a row. */
    fun row(vararg cells: String) {
        text.append(cells.joinToString(" | ", "| ", " |\n"))
    }
}

/** Returns a table with the rows that [fill] adds. */
internal fun table(vararg heads: String, fill: Rows.() -> Unit): String = buildString {
    Rows(this).run {
        row(*heads)
        row(*Array(heads.size) { "---" })
        fill()
    }
}
