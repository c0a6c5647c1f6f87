package dev.lazyz.cli.compare

import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RowSink
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject

/** One pixel of a picture. */
internal class Pixel(private val argb: Int, private val depth: Int, private val primitive: Int) {
    private val color: String get() = "#%06x%02x".format(argb and 0xFFFFFF, argb ushr 24)

    /** This pixel as JSON. */
    fun toJson(): JsonObject = buildJsonObject {
        put("color", color)
        put("depth", depth)
        put("primitive", primitive)
    }

    override fun toString(): String {
        val seen = if (primitive == DepthTest.BACKGROUND) "background" else "primitive $primitive"
        return "colour $color, depth $depth, $seen"
    }
}

/**
 * The difference between a picture and the expected one.
 *
 * @property pixels number of pixels that differ in colour, depth or primitive
 * @property x column of the first of them, from the top, on the whole raster
 * @property y its row
 */
internal class Difference(val pixels: Long, val x: Int, val y: Int, val expected: Pixel, val actual: Pixel) {
    /** Adds this difference to a JSON object. */
    fun addTo(json: JsonObjectBuilder) {
        json.put("differingPixels", pixels)
        json.putJsonObject("firstDifference") {
            put("x", x)
            put("y", y)
            put("expected", expected.toJson())
            put("actual", actual.toJson())
        }
    }
}

/** Compares each row with that of a [reference] when it arrives, so that no second picture is kept in memory. */
internal class RowComparison(private val reference: Image) : RowSink {
    private val region = reference.region
    private var pixels = 0L
    private var first: Difference? = null

    /** The difference in the rows so far, or null if there is none. */
    val difference: Difference? get() = first?.let { Difference(pixels, it.x, it.y, it.expected, it.actual) }

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val row = (y - region.rowStart) * region.width
        for (x in 0 until region.width) {
            val at = row + x
            val isSame = argb[x] == reference.argb[at] && depth[x] == reference.depth[at] &&
                primitive[x] == reference.primitive[at]
            if (isSame) continue
            pixels++
            if (first != null) continue
            val expected = Pixel(reference.argb[at], reference.depth[at], reference.primitive[at])
            first = Difference(1, region.columnStart + x, y, expected, Pixel(argb[x], depth[x], primitive[x]))
        }
    }
}

/** Checks that each row of [region] arrives exactly once, from top to bottom (contract rule 7.3). */
internal class CompleteRows(private val region: Region, private val sink: RowSink) : RowSink {
    private var next = region.rowStart

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        check(y == next && y < region.rowEnd) {
            if (next < region.rowEnd) "row $y arrived instead of row $next" else "row $y arrived after the last row"
        }
        next++
        sink.row(y, argb, depth, primitive)
    }

    /** Checks that all rows have arrived. Call it after the rendering. */
    fun requireComplete() {
        check(next == region.rowEnd) { "${next - region.rowStart} of ${region.height} rows arrived" }
    }
}
