package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.conformance.mutants.Mistake

/** What is rejected by its bounds in depth, and tiles that are left as they were. */
internal val tileMistakes: List<Mistake> = listOf(
    Mistake(
        "reject-equal-depth",
        "rejects what is as deep as the farthest sample; shows where a full tile loses a tie that the later one wins",
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun isHidden(primitive: Primitive, index: Int): Boolean =
                    nearestKey(primitive, index) ushr 32 >= farthest ushr 32 && isCovered()

                private fun isCovered(): Boolean = test.indexOf(farthest) >= 0
            }
        }
    },
    Mistake(
        "farthest-of-corners",
        "the farthest sample of a tile is looked for at its corners; shows where a tile has a hole or a dent inside",
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun farthest(tile: Region): Long = maxOf(
                    maxOf(keys[at(tile.columnStart, tile.rowStart)], keys[at(tile.columnEnd - 1, tile.rowStart)]),
                    maxOf(keys[at(tile.columnStart, tile.rowEnd - 1)], keys[at(tile.columnEnd - 1, tile.rowEnd - 1)]),
                )
            }
        }
    },
    Mistake(
        "span-ends-behind",
        "a span that is behind one primitive at both ends is dropped; shows where that one has a gap in between",
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
                    val last = count - 1
                    val isOne = test.indexOf(keys[at]) >= 0 && test.indexOf(keys[at]) == test.indexOf(keys[at + last])
                    val isBehind = key(spanDepths[0], index) > keys[at] &&
                        key(spanDepths[last], index) > keys[at + last]
                    if (!(isOne && isBehind)) super.lower(keys, at, index, count)
                }
            }
        }
    },
)

/** Which primitives come to which tile, band or part of a buffer. */
internal val binMistakes: List<Mistake> = listOf(
    Mistake(
        "tile-places-in-short",
        "the samples that are to be shaded are listed as Short; shows in tiles of 256 and more, below row 127",
    ) {
        tiles { frame, size -> ShortPlaces(frame, size) }
    },
    Mistake(
        "four-spans-a-row",
        "a row of a primitive has room for four spans; shows on concave polygons and masks with more",
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
