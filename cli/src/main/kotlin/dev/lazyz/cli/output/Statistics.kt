package dev.lazyz.cli.output

import com.github.ajalt.mordant.rendering.AnsiLevel
import com.github.ajalt.mordant.rendering.BorderType
import com.github.ajalt.mordant.rendering.TextAlign
import com.github.ajalt.mordant.table.Borders
import com.github.ajalt.mordant.table.TableBuilder
import com.github.ajalt.mordant.table.table
import com.github.ajalt.mordant.terminal.Terminal
import dev.lazyz.Counters
import dev.lazyz.Image.PixelHash
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.VisibleRows
import dev.lazyz.strategies.tiled.TiledRenderer
import kotlinx.serialization.json.JsonObject

/**
 * The statistics of a rendering, by name, in the order of the output. Scripts depend on the names.
 *
 * @param picture the pixels that were rendered
 * @param shot the picture that was set up
 * @param place which of several pictures this is
 */
internal class Statistics(
    input: String,
    strategy: Renderer,
    picture: Region,
    shot: PictureFrame,
    counters: Counters,
    tally: Tally,
    warnings: Int,
    nanoseconds: Long,
    place: Map<String, Any> = emptyMap(),
) {
    val entries: Map<String, Any> = mapOf<String, Any>("input" to input) + place + mapOf(
        "strategy" to strategy.id,
    ) + (if (strategy is TiledRenderer) mapOf("kernel" to strategy.kernel) else emptyMap()) + mapOf(
        "width" to picture.width,
        "height" to picture.height,
        "aa" to shot.factor,
    ) + counted(counters, picture, shot.factor) + mapOf(
        "visible" to tally.visible,
        "coverage" to tally.visible.toDouble() / picture.size,
        "blank" to (tally.blank != null),
        "cropped" to shot.isCropped,
        "warnings" to warnings,
        "millis" to millis(nanoseconds),
        "pixelHash" to tally.hash(),
    )

    /** Returns a JSON object in one line, with the [comparison] with a reference, if there is one. */
    fun toJson(comparison: JsonObject? = null): String {
        val values = entries.mapValues { Json.primitive(it.value) }
        return Json.of(JsonObject(if (comparison == null) values else values + ("reference" to comparison)))
    }

    companion object {
        /** Returns the entries that derive from [counters], for [picture] with [aa] x [aa] samples a pixel. */
        fun counted(counters: Counters, picture: Region, aa: Int): Map<String, Any> = mapOf(
            "primitives" to counters.primitives,
            "fragments" to counters.fragments,
            "overdraw" to counters.fragments.toDouble() / (picture.size * aa * aa),
            "depthEvaluations" to counters.depthEvaluations,
            "depthPasses" to counters.depthPasses,
            "shadingCalls" to counters.shadingCalls,
            "shadingStarts" to counters.shadingStarts,
            "shadingSteps" to counters.shadingSteps,
            "longestChain" to counters.longestChain,
            "peakSuspensions" to counters.peakSuspensions,
            "peakBytes" to counters.peakBytes,
        )

        /** Returns [nanoseconds] in milliseconds with one decimal. */
        fun millis(nanoseconds: Long): Double = nanoseconds / 100_000 / 10.0
    }
}

/** Counts the visible samples of the rows, compares their colours, and computes the hash of the picture. */
internal class Tally(private val width: Int, isHashed: Boolean) : RowSink {
    private val hash = if (isHashed) PixelHash() else null

    private val rows = VisibleRows(width)

    /** Number of samples so far at which a primitive is visible. */
    val visible: Long get() = rows.visible

    /** Why there is nothing to see so far, or null if there is something. */
    val blank: String? get() = BlankPictures.reason(rows.blank)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        rows.row(y, argb, depth, primitive)
        hash?.add(argb, width)
    }

    /** Returns [dev.lazyz.Image.pixelHash] of the rows. Call it once, after the last row. */
    fun hash(): String = checkNotNull(hash) { "no hash was requested" }.digest()
}

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
