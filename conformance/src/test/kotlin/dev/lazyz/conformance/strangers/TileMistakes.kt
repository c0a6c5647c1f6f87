package dev.lazyz.conformance.strangers

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
