package dev.lazyz.conformance.strangers2

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicReference

/** Tiles that threads share out among themselves; within a tile primitives are drawn nearest first. */
internal class Tiles(private val steps: TileSteps, private val options: RenderOptions) : Renderer {
    override val id: String get() = "tiles"
    override val summary: String get() = "a base of the second gallery"
    override val capabilities: Set<Capability> get() = setOf(Capability.PARALLEL, Capability.SHADES_ONLY_VISIBLE)

    override fun configured(options: RenderOptions): Renderer = Tiles(steps, options.requireSupportedBy(this))

    override fun render(frame: Frame, sink: RowSink): Counters {
        refuseTranslucent(frame, id)
        return TilePass(frame, options, steps).run(sink)
    }
}

/** One rendering of [Tiles]. */
internal class TilePass(val frame: Frame, val options: RenderOptions, val steps: TileSteps) {
    val region = frame.region
    val test = frame.raster.depthTest
    val isReversed = test.key(1, 0) < test.key(0, 0)
    val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    val size = options.tileSize
    val tileColumns = steps.tileCount(region.columnStart, region.columnEnd, size)
    val tileRows = (region.height + size - 1) / size
    val failure = AtomicReference<Throwable?>()
    val isStopped = AtomicBoolean()
    val keys = LongArray(frame.width * frame.height) { backgroundKey }
    val argb = IntArray(keys.size) { frame.raster.background.toArgb() }

    /** Indices of primitives by tile, nearest first. */
    val bins = Array(tileColumns * tileRows) { IntList() }

    fun run(sink: RowSink): Counters {
        bin()
        val threads = steps.threads(this, minOf(options.threads, bins.size))
        val parts = Array(threads) { Counters.Builder() }
        val workers = (1 until threads).map { number -> Thread { guarded(number, threads, parts[number]) } }
        for (worker in workers) worker.start()
        guarded(0, threads, parts[0])
        steps.await(this, workers)
        failure.get()?.let { throw steps.cause(this, it) }
        val counters = parts.fold(Counters.Builder()) { sum, part -> sum.add(part.build()) }
        counters.primitives = steps.primitives(this, threads)
        counters.peakBytes = 12L * keys.size + bins.sumOf { 4L * it.items.size }
        handOut(sink)
        return counters.build()
    }

    private fun guarded(number: Int, threads: Int, counters: Counters.Builder) {
        try {
            val tiles = TileDrawing(this, counters, steps.fragment(this))
            for (tile in steps.share(this, number, threads)) tiles.draw(tile)
        } catch (e: Throwable) {
            steps.failed(this, number, e)
        }
    }

    private fun bin() {
        val order = LongArray(frame.primitives.size)
        for ((index, primitive) in frame.primitives.withIndex()) {
            order[index] = steps.orderKey(this, primitive, index)
        }
        order.sort()
        for (key in order) {
            val index = test.indexOf(key)
            val primitive = frame.primitives[index]
            val rows = region.rowStart until region.rowEnd
            if (!overlaps(primitive, region.columnStart until region.columnEnd, rows)) continue
            val left = tile(primitive.columnStart, region.columnStart)
            val right = minOf(tile(primitive.columnEnd - 1, region.columnStart), tileColumns - 1)
            val bottom = minOf(tile(primitive.rowEnd - 1, region.rowStart), tileRows - 1)
            for (row in tile(primitive.rowStart, region.rowStart)..bottom) {
                for (column in left..right) bins[row * tileColumns + column].add(index)
            }
        }
    }

    private fun tile(position: Int, start: Int): Int = maxOf(position - start, 0) / size

    private fun handOut(sink: RowSink) {
        val width = frame.width
        val colors = IntArray(width)
        val depths = IntArray(width)
        val indices = IntArray(width)
        for (row in 0 until frame.height) {
            argb.copyInto(colors, 0, row * width, (row + 1) * width)
            for (i in 0 until width) {
                depths[i] = test.depthOf(keys[row * width + i])
                indices[i] = test.indexOf(keys[row * width + i])
            }
            sink.row(region.rowStart + row, colors, depths, indices)
        }
    }
}

/** A list of numbers. */
internal class IntList {
    var items = IntArray(4)
    var count = 0

    fun add(item: Int) {
        if (count == items.size) items = items.copyOf(2 * count)
        items[count++] = item
    }
}
