package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.spi.Spans

/** Keys of a band of tiles; each tile rejects what is behind all its samples; shades once the band is done. */
internal open class TileDrawing(frame: Frame, val tileSize: Int) : Drawing(frame) {
    val bandRows = minOf(tileSize, maxOf(1, MOST_SAMPLES / width))
    val keys = LongArray(bandRows * width)
    var bandTop = 0

    /** The greatest key of the tile when it was last looked for. */
    var farthest = 0L
    var changes = 0

    override fun run(sink: RowSink): Counters {
        counters.primitives = primitives.size.toLong()
        for (top in region.rowStart until region.rowEnd step bandRows) {
            bandTop = top
            val bottom = minOf(top + bandRows, region.rowEnd)
            drawBand(top, bottom)
            val before = counters.shadingCalls
            for (y in top until bottom) finishRow(keys, (y - top) * width, y, sink)
            counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - before)
        }
        return counters.build()
    }

    open fun drawBand(top: Int, bottom: Int) {
        clear()
        val bin = bin(top, bottom)
        counters.peakBytes = maxOf(counters.peakBytes, 8L * keys.size + 12L * width + 4L * bin.size)
        for (left in region.columnStart until region.columnEnd step tileSize) {
            drawTile(Region(left, top, minOf(left + tileSize, region.columnEnd), bottom), bin)
        }
    }

    open fun clear() = keys.fill(backgroundKey())

    /** The primitives that may cover something of the band. */
    open fun bin(top: Int, bottom: Int): IntArray = primitives.indices.filter {
        reaches(primitives[it]) && primitives[it].rowStart < bottom && primitives[it].rowEnd > top
    }.toIntArray()

    open fun touches(primitive: Primitive, tile: Region): Boolean =
        primitive.columnStart < tile.columnEnd && primitive.columnEnd > tile.columnStart

    open fun begin(tile: Region) {
        farthest = farthest(tile)
        changes = 0
    }

    open fun drawTile(tile: Region, bin: IntArray) {
        begin(tile)
        val spans = tile.spans()
        for (index in bin) {
            val primitive = primitives[index]
            if (!touches(primitive, tile) || isHidden(primitive, index)) continue
            for (y in maxOf(primitive.rowStart, tile.rowStart) until minOf(primitive.rowEnd, tile.rowEnd)) {
                spans.clear()
                primitive.spans(y, spans)
                for (i in 0 until spans.count) drawSpan(primitive, index, y, spans.start(i), spans.end(i))
            }

            // Look for the farthest sample again after some change
            if (changes >= tile.size / 4) {
                farthest = farthest(tile)
                changes = 0
            }
        }
    }

    open fun isHidden(primitive: Primitive, index: Int): Boolean = nearestKey(primitive, index) > farthest

    open fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        count(start, end)
        walk(primitive, y, start, end)
        lower(keys, at(start, y), index, end - start)
        changes += end - start
    }

    fun at(x: Int, y: Int): Int = (y - bandTop) * width + x - region.columnStart

    open fun farthest(tile: Region): Long {
        var most = Long.MIN_VALUE
        for (y in tile.rowStart until tile.rowEnd) {
            for (x in tile.columnStart until tile.columnEnd) most = maxOf(most, keys[at(x, y)])
        }
        return most
    }

    private companion object {
        const val MOST_SAMPLES = 1 shl 18
    }
}

internal val TILE_PROMISES = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY)

internal fun tiles(drawing: (Frame, Int) -> TileDrawing): Renderer =
    Workbench("tiles", { TILE_PROMISES }) { frame: Frame, options: RenderOptions -> drawing(frame, options.tileSize) }
