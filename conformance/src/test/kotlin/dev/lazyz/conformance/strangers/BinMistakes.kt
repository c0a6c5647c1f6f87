package dev.lazyz.conformance.strangers

import dev.lazyz.Frame
import dev.lazyz.Region

/** Which primitives come to which tile, band or part of a buffer. */
internal val binMistakes: List<Stranger> = listOf(
    Stranger(
        "tile-places-in-short",
        "the samples that are to be shaded are listed as Short; shows in tiles of 256 and more, below row 127",
        setOf("7.5"),
    ) {
        tiles { frame, size -> ShortPlaces(frame, size) }
    },
    Stranger(
        "four-spans-a-row",
        "a row of a primitive has room for four spans; shows on concave polygons and masks with more",
        setOf("2.3", "2.7"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun draw(entry: Entry, y: Int) {
                    entry.cursor.next(spans)
                    for (i in 0 until minOf(spans.count, 4)) {
                        drawSpan(entry.primitive, entry.index, y, spans.start(i), spans.end(i))
                    }
                }
            }
        }
    },
)

/** Lists the samples of a tile that have a primitive as Short, and forgets those whose place is negative. */
private class ShortPlaces(frame: Frame, tileSize: Int) : TileDrawing(frame, tileSize) {
    override fun drawTile(tile: Region, bin: IntArray) {
        super.drawTile(tile, bin)
        for (y in tile.rowStart until tile.rowEnd) {
            for (x in tile.columnStart until tile.columnEnd) {
                val place = ((y - tile.rowStart) * tileSize + x - tile.columnStart).toShort()
                if (place < 0) keys[at(x, y)] = backgroundKey()
            }
        }
    }
}
