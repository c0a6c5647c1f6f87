package dev.lazyz.conformance.strangers

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region

/** Which primitives come to which tile, band or part of a buffer. */
internal val binMistakes: List<Stranger> = listOf(
    Stranger(
        "bin-by-width",
        "a primitive is put into as many tiles as its width takes; shows where it crosses one border more",
        setOf("7.5", "5.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun touches(primitive: Primitive, tile: Region): Boolean {
                    val left = maxOf(primitive.columnStart, region.columnStart)
                    val first = (left - region.columnStart) / tileSize
                    val count = (minOf(primitive.columnEnd, region.columnEnd) - left + tileSize - 1) / tileSize
                    return (tile.columnStart - region.columnStart) / tileSize in first until first + count
                }
            }
        }
    },
    Stranger(
        "bin-of-raster",
        "tiles are counted from the raster's first column, but drawn from the region's; shows on regions whose first " +
            "column is no multiple of the tile size",
        setOf("7.4", "7.5"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun touches(primitive: Primitive, tile: Region): Boolean {
                    val number = tile.columnStart / tileSize
                    return number in maxOf(primitive.columnStart, 0) / tileSize..(primitive.columnEnd - 1) / tileSize
                }
            }
        }
    },
    Stranger(
        "bin-without-one-column",
        "a primitive that reaches one column into a tile is not put there; shows at any border of tiles",
        setOf("7.5", "2.3"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun touches(primitive: Primitive, tile: Region): Boolean = super.touches(primitive, tile) &&
                    (tile.columnStart == region.columnStart || primitive.columnEnd > tile.columnStart + 1)
            }
        }
    },
    Stranger(
        "bin-rounds-up-with-overflow",
        "the last row of bounds is rounded up to a band; bounds near 2^31-1, which a user's primitive may have, wrap",
        setOf("2.8"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun bin(top: Int, bottom: Int): IntArray =
                    super.bin(top, bottom).filter { (primitives[it].rowEnd + tileSize - 1) / tileSize > 0 }.toIntArray()
            }
        }
    },
    Stranger(
        "bin-of-256",
        "a bin holds 256 primitives, and the last place is used again; shows from 257 on in a band",
        setOf("5.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun bin(top: Int, bottom: Int): IntArray {
                    val all = super.bin(top, bottom)
                    return if (all.size <= 256) all else all.copyOf(255) + all.last()
                }
            }
        }
    },
    Stranger(
        "bin-rows-of-last-band",
        "a primitive that ends on the first row of a band is not put there; shows at borders of bands",
        setOf("7.5", "2.3"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun bin(top: Int, bottom: Int): IntArray = super.bin(top, bottom)
                    .filter { top == region.rowStart || primitives[it].rowEnd - 1 > top }.toIntArray()
            }
        }
    },
    Stranger(
        "tile-of-one-column",
        "the rest of a region that is one column wide gets no tile; shows on widths of a multiple of the " +
            "tile size plus 1",
        setOf("7.5", "9.6"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun drawTile(tile: Region, bin: IntArray) {
                    if (tile.width > 1 || region.width == 1) super.drawTile(tile, bin)
                }
            }
        }
    },
    Stranger(
        "tile-places-in-short",
        "the samples that are to be shaded are listed as Short; shows in tiles of 256 and more, below row 127",
        setOf("7.5"),
    ) {
        tiles { frame, size -> ShortPlaces(frame, size) }
    },
    Stranger(
        "column-in-short",
        "spans are packed into two Shorts; columns from 32,768 on turn negative and are dropped",
        setOf("1.1", "2.3"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
                    val packed = start shl 16 or (end - 1 and 0xFFFF)
                    val first = packed shr 16
                    val last = packed.toShort().toInt()
                    if (first in 0..last) super.drawSpan(primitive, index, y, first, last + 1)
                }
            }
        }
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
    Stranger(
        "convex-by-ends",
        "rows of a primitive without a depth form are filled from the first span's start to the " +
            "last one's end; shows " +
            "on primitives of the user's own with a gap",
        setOf("2.8"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun draw(entry: Entry, y: Int) {
                    entry.cursor.next(spans)
                    if (spans.count == 0) return
                    if (entry.primitive.depthForm == null) {
                        drawSpan(entry.primitive, entry.index, y, spans.start(0), spans.end(spans.count - 1))
                    } else {
                        for (i in 0 until spans.count) {
                            drawSpan(entry.primitive, entry.index, y, spans.start(i), spans.end(i))
                        }
                    }
                }
            }
        }
    },
    Stranger(
        "index-by-equality",
        "the index of a primitive is looked up in the list; shows where one object is submitted twice",
        setOf("5.3", "9.4"),
    ) {
        plain {
            object : PlainDrawing(it) {
                private val numbers = HashMap<Primitive, Int>()

                override fun draw(primitive: Primitive, index: Int) =
                    super.draw(primitive, numbers.getOrPut(primitive) { index })
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
