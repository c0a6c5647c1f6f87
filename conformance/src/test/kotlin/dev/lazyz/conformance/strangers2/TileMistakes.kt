package dev.lazyz.conformance.strangers2

import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Spans
import dev.lazyz.conformance.strangers.Stranger

private fun wrongTiles(id: String, what: String, vararg chapters: String, steps: () -> TileSteps): Stranger =
    Stranger(id, what, chapters.toSet()) { Tiles(steps(), RenderOptions()) }

/** Mistakes of a renderer with tiles and threads. */
internal fun tileMistakes(): List<Stranger> = listOf(
    wrongTiles("tiles-of-the-raster", "counts tile columns by the raster's grid, both ends rounded up", "7.4", "7.3") {
        object : TileSteps() {
            override fun tileCount(start: Int, end: Int, size: Int): Int =
                maxOf((end + size - 1) / size - (start + size - 1) / size, 1)
        }
    },
    wrongTiles("primitives-a-thread", "each thread counts all primitives", "7.6", "8.1") {
        object : TileSteps() {
            override fun primitives(pass: TilePass, threads: Int): Long = super.primitives(pass, threads) * threads
        }
    },
    wrongTiles("lost-error", "an error (no exception) on another thread leaves its tiles unfinished", "7.1") {
        object : TileSteps() {
            override fun failed(pass: TilePass, number: Int, failure: Throwable) {
                if (number == 0 || failure is Exception) super.failed(pass, number, failure)
            }
        }
    },
    wrongTiles("goes-on-interrupted", "interrupted, it hands out what the other threads have done so far", "7.1") {
        object : TileSteps() {
            override fun await(pass: TilePass, workers: List<Thread>) = try {
                for (worker in workers) worker.join()
            } catch (_: InterruptedException) {
                Thread.currentThread().interrupt()
            }
        }
    },
    wrongTiles("corners-cover", "what covers the corners of a tile is taken to cover the tile", "5.1", "2.4") {
        object : CoveringTiles() {
            override fun covers(tile: TileDrawing, primitive: Primitive): Boolean =
                listOf(tile.rows.first, tile.rows.last).all { y ->
                    listOf(tile.columns.first, tile.columns.last).all { x ->
                        val sample = Spans(x, x + 1)
                        primitive.spans(y, sample)
                        sample.count > 0
                    }
                }
        }
    },
    wrongTiles("place-of-16-bits", "16 bits for a sample's place in a tile: too few for tiles of 512", "7.5", "8.2") {
        object : TileSteps() {
            override fun shade(tile: TileDrawing) {
                val size = tile.pass.size
                for (y in tile.rows) {
                    for (x in tile.columns) {
                        val place = (y - tile.rows.first) * size + (x - tile.columns.first) and 0xFFFF
                        tile.shade(tile.columns.first + place % size, tile.rows.first + place / size)
                    }
                }
            }
        }
    },
    wrongTiles("bin-of-512", "a tile has room for 512 primitives; those behind are dropped", "5.1") {
        object : TileSteps() {
            override fun farthest(tile: TileDrawing, primitive: Primitive, index: Int, old: Long, place: Int): Long =
                if (place >= 511) Long.MIN_VALUE else super.farthest(tile, primitive, index, old, place)
        }
    },
    wrongTiles("one-sample-is-covered", "what has bounds of one sample is taken to cover it", "2.8", "2.2") {
        object : TileSteps() {
            override fun drawSmall(tile: TileDrawing, primitive: Primitive, index: Int): Boolean {
                val isSmall = primitive.columnEnd - primitive.columnStart == 1 &&
                    primitive.rowEnd - primitive.rowStart == 1
                if (isSmall) tile.merge(primitive, index, primitive.columnStart, primitive.rowStart)
                return isSmall
            }
        }
    },
    wrongTiles("hidden-at-a-tie", "what is at best as deep as the farthest sample of a tile is hidden", "5.2", "5.3") {
        object : TileSteps() {
            override fun isHidden(tile: TileDrawing, primitive: Primitive, index: Int, farthest: Long): Boolean =
                orderKey(tile.pass, primitive, index) ushr 32 >= farthest ushr 32
        }
    },
    wrongTiles("tiles-left-over", "each thread gets as many tiles; the remainder goes to none", "7.5", "7.6") {
        object : TileSteps() {
            override fun share(pass: TilePass, number: Int, threads: Int): IntProgression {
                val each = pass.bins.size / threads
                return number * each until (number + 1) * each
            }
        }
    },
)

/** A tile's farthest key is lowered by each primitive that covers the tile. */
private abstract class CoveringTiles : TileSteps() {
    abstract fun covers(tile: TileDrawing, primitive: Primitive): Boolean

    override fun farthest(tile: TileDrawing, primitive: Primitive, index: Int, old: Long, place: Int): Long {
        val isInBounds = primitive.columnStart <= tile.columns.first && tile.columns.last < primitive.columnEnd &&
            primitive.rowStart <= tile.rows.first && tile.rows.last < primitive.rowEnd
        val bound = if (tile.pass.isReversed) primitive.leastDepth else primitive.greatestDepth
        val key = tile.pass.test.key(bound, index)
        return if (isInBounds && covers(tile, primitive)) minOf(old, key) else old
    }
}
