package dev.lazyz.conformance.strangers2

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.Spans

/** What one thread of [Tiles] does with its tiles. */
internal class TileDrawing(val pass: TilePass, val counters: Counters.Builder, val fragment: Fragment) {
    private val region = pass.region
    private val steps = pass.steps
    private val primitives = pass.frame.primitives
    var columns = IntRange.EMPTY
        private set
    var rows = IntRange.EMPTY
        private set

    fun at(x: Int, y: Int): Int = (y - region.rowStart) * region.width + x - region.columnStart

    fun draw(tile: Int) {
        val left = region.columnStart + tile % pass.tileColumns * pass.size
        val top = region.rowStart + tile / pass.tileColumns * pass.size
        columns = left until minOf(left + pass.size, region.columnEnd)
        rows = top until minOf(top + pass.size, region.rowEnd)
        val bin = pass.bins[tile]
        var farthest = pass.backgroundKey
        val spans = Spans(columns.first, columns.last + 1)
        for (i in 0 until bin.count) {
            if (pass.isStopped.get() || pass.failure.get() != null) return
            val index = bin.items[i]
            val primitive = primitives[index]
            if (steps.isHidden(this, primitive, index, farthest)) break
            drawOne(primitive, index, spans)
            farthest = steps.farthest(this, primitive, index, farthest, i)
            steps.drawn(this, i)
        }
        steps.shade(this)
    }

    private fun drawOne(primitive: Primitive, index: Int, spans: Spans) {
        if (steps.drawSmall(this, primitive, index)) return
        for (y in maxOf(primitive.rowStart, rows.first)..minOf(primitive.rowEnd - 1, rows.last)) {
            spans.clear()
            primitive.spans(y, spans)
            for (i in 0 until spans.count) {
                for (x in spans.start(i) until spans.end(i)) merge(primitive, index, x, y)
            }
        }
    }

    fun merge(primitive: Primitive, index: Int, x: Int, y: Int) {
        counters.fragments++
        counters.depthEvaluations++
        val key = pass.test.key(primitive.depth(x, y), index)
        val at = at(x, y)
        if (key >= pass.keys[at]) return
        pass.keys[at] = key
        counters.depthPasses++
    }

    fun shade(x: Int, y: Int) {
        val at = at(x, y)
        val index = pass.test.indexOf(pass.keys[at])
        if (index == DepthTest.BACKGROUND) return
        counters.shadingCalls++
        counters.shadingStarts++
        fragment.moveTo(x, y)
        primitives[index].shade(fragment)
        pass.argb[at] = fragment.toArgb()
    }

    /** The farthest key in the tile. */
    fun farthestKey(): Long {
        var most = Long.MIN_VALUE
        for (y in rows) for (x in columns) most = maxOf(most, pass.keys[at(x, y)])
        return most
    }
}

/** What [Tiles] does, step by step; mistakes replace single steps. */
internal open class TileSteps {
    open fun tileCount(start: Int, end: Int, size: Int): Int = (end - start + size - 1) / size

    open fun threads(pass: TilePass, most: Int): Int = most

    open fun primitives(pass: TilePass, threads: Int): Long = pass.frame.primitives.size.toLong()

    open fun fragment(pass: TilePass): Fragment = Fragment()

    open fun share(pass: TilePass, number: Int, threads: Int): IntProgression =
        number until pass.bins.size step threads

    /** Ends all threads; throws if the caller was interrupted meanwhile. */
    open fun await(pass: TilePass, workers: List<Thread>) {
        var interruption: InterruptedException? = null
        for (worker in workers) {
            while (worker.isAlive) {
                try {
                    worker.join()
                } catch (e: InterruptedException) {
                    interruption = e
                    pass.isStopped.set(true)
                }
            }
        }
        if (interruption != null && pass.failure.get() == null) throw interruption
    }

    open fun failed(pass: TilePass, number: Int, failure: Throwable) {
        pass.failure.compareAndSet(null, failure)
    }

    open fun cause(pass: TilePass, failure: Throwable): Throwable = failure

    /** A key that no fragment is before. */
    open fun orderKey(pass: TilePass, primitive: Primitive, index: Int): Long =
        pass.test.key(if (pass.isReversed) primitive.greatestDepth else primitive.leastDepth, index)

    /** Whether this primitive, and so all behind it in the bin, are hidden in the tile. */
    open fun isHidden(tile: TileDrawing, primitive: Primitive, index: Int, farthest: Long): Boolean =
        orderKey(tile.pass, primitive, index) > farthest

    open fun farthest(tile: TileDrawing, primitive: Primitive, index: Int, old: Long, place: Int): Long =
        if (place % 8 == 7) tile.farthestKey() else old

    open fun drawSmall(tile: TileDrawing, primitive: Primitive, index: Int): Boolean = false

    open fun drawn(tile: TileDrawing, place: Int) = Unit

    open fun shade(tile: TileDrawing) {
        for (y in tile.rows) for (x in tile.columns) tile.shade(x, y)
    }
}
