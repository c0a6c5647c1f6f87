package dev.lazyz.conformance.strangers

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region

/** What is rejected by its bounds in depth, and tiles that are left as they were. */
internal val tileMistakes: List<Stranger> = listOf(
    Stranger(
        "reject-equal-depth",
        "rejects what is as deep as the farthest sample; shows where a full tile loses a tie that the later one wins",
        setOf("5.3", "5.2"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun isHidden(primitive: Primitive, index: Int): Boolean =
                    nearestKey(primitive, index) ushr 32 >= farthest ushr 32 && isCovered()

                private fun isCovered(): Boolean = test.indexOf(farthest) >= 0
            }
        }
    },
    Stranger(
        "reject-equal-depth-near-to-far",
        "stops at what is as deep as the farthest sample; shows on ties, because nearest first is not first first",
        setOf("5.2"),
    ) {
        nearToFar {
            object : NearToFarDrawing(it) {
                override fun isBehind(primitive: Primitive, index: Int, farthest: Long): Boolean =
                    nearestKey(primitive, index) ushr 32 >= farthest ushr 32
            }
        }
    },
    Stranger("reject-by-least-depth", "rejects by the least depth under every test; shows with GREATER", setOf("5.3")) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun nearestKey(primitive: Primitive, index: Int): Long = test.key(primitive.leastDepth, index)
            }
        }
    },
    Stranger(
        "reject-by-farthest",
        "rejects what has some sample behind all of the tile; shows on sloping primitives through a full tile",
        setOf("5.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun nearestKey(primitive: Primitive, index: Int): Long =
                    maxOf(test.key(primitive.leastDepth, index), test.key(primitive.greatestDepth, index))

                override fun isHidden(primitive: Primitive, index: Int): Boolean =
                    test.indexOf(farthest) >= 0 && super.isHidden(primitive, index)
            }
        }
    },
    Stranger(
        "reject-float",
        "rejects by bounds rounded to Float, ties too; shows on depths that nearly touch",
        setOf("5.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun isHidden(primitive: Primitive, index: Int): Boolean = test.indexOf(farthest) >= 0 &&
                    (nearestKey(primitive, index) ushr 32).toFloat() >= (farthest ushr 32).toFloat()
            }
        }
    },
    Stranger(
        "farthest-of-last-tile",
        "a tile begins with the farthest key of the tile on its left; shows where a full tile is beside an empty one",
        setOf("5.1", "7.5"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun begin(tile: Region) {
                    if (tile.columnStart == region.columnStart) super.begin(tile)
                    changes = 0
                }
            }
        }
    },
    Stranger(
        "farthest-of-corners",
        "the farthest sample of a tile is looked for at its corners; shows where a tile has a hole or a dent inside",
        setOf("5.1", "7.5"),
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
    Stranger(
        "farthest-without-last-column",
        "the last column of a tile is left out of its farthest key; shows where only that column is open",
        setOf("5.1", "7.5"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun farthest(tile: Region): Long = if (tile.width == 1) {
                    super.farthest(tile)
                } else {
                    super.farthest(Region(tile.columnStart, tile.rowStart, tile.columnEnd - 1, tile.rowEnd))
                }
            }
        }
    },
    Stranger(
        "farthest-mask-of-64",
        "a row's covered samples are bits of a Long; columns 64 apart share a bit, so tiles of 128 " +
            "and more look full " +
            "when they are not",
        setOf("7.5", "5.1"),
    ) {
        tiles { frame, size -> MaskedTiles(frame, size) }
    },
    Stranger(
        "clear-one-row-less",
        "the last row of a band is not cleared; shows from the second band on",
        setOf("4.3", "7.5"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun clear() {
                    val until = if (bandTop == region.rowStart) keys.size else keys.size - width
                    keys.fill(backgroundKey(), 0, until)
                }
            }
        }
    },
    Stranger(
        "clear-only-full-bands",
        "a band that is cut off by the region's lower border is not cleared; shows where it is not the first",
        setOf("4.3", "7.5"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun clear() {
                    if (bandTop == region.rowStart || bandTop + bandRows <= region.rowEnd) super.clear()
                }
            }
        }
    },
    Stranger(
        "span-ends-behind",
        "a span that is behind one primitive at both ends is dropped; shows where that one has a gap in between",
        setOf("5.1", "2.4"),
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

/** Takes a tile for full when every bit of its rows' masks is set. */
private class MaskedTiles(frame: Frame, tileSize: Int) : TileDrawing(frame, tileSize) {
    override fun farthest(tile: Region): Long {
        var most = Long.MIN_VALUE
        for (y in tile.rowStart until tile.rowEnd) {
            var mask = 0L
            for (x in tile.columnStart until tile.columnEnd) {
                val key = keys[at(x, y)]
                if (test.indexOf(key) < 0) continue
                mask = mask or (1L shl x - tile.columnStart)
                most = maxOf(most, key)
            }
            val full = if (tile.width >= 64) -1L else (1L shl tile.width) - 1
            if (mask != full) return super.farthest(tile)
        }
        return most
    }
}
