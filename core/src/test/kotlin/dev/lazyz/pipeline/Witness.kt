package dev.lazyz.pipeline

import dev.lazyz.Depth
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans

/** A rectangle of samples with constant depth and colour; counts the calls. */
internal class Pane(
    private val region: Region,
    private val depth: Int,
    private val color: Rgba,
    override val heldBytes: Long = 256,
) : Primitive {
    var shadingCalls = 0
        private set
    var lastRow = -1
        private set

    override val rowStart: Int get() = region.rowStart
    override val rowEnd: Int get() = region.rowEnd
    override val columnStart: Int get() = region.columnStart
    override val columnEnd: Int get() = region.columnEnd
    override val isTranslucent: Boolean get() = color.alpha < 1f
    override val depthForm: LinearForm get() = LinearForm.constant(depth)

    override fun spans(y: Int, spans: Spans) {
        lastRow = maxOf(lastRow, y)
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment) {
        shadingCalls++
        fragment.setColor(color.red, color.green, color.blue, color.alpha)
    }
}

/** A rectangle of constant depth that records the calls. */
internal class Witness(private val region: Region, private val depth: Int, private val onRow: (Int) -> Unit = {}) :
    Primitive {
    /** Rows at which cursors began. */
    val cursors = ArrayList<Int>()

    /** Rows whose spans were requested. */
    val rows = ArrayList<Int>()

    /** Samples whose depth was requested. */
    var depths = 0

    /** Samples whose colour was requested, x and y. */
    val shaded = ArrayList<Pair<Int, Int>>()

    override val rowStart: Int get() = region.rowStart
    override val rowEnd: Int get() = region.rowEnd
    override val columnStart: Int get() = region.columnStart
    override val columnEnd: Int get() = region.columnEnd

    override fun cursor(y: Int): SpanCursor {
        synchronized(this) { cursors += y }
        return super.cursor(y)
    }

    override fun spans(y: Int, spans: Spans) {
        synchronized(this) { rows += y }
        onRow(y)
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int {
        depths++
        return depth
    }

    override fun shade(fragment: Fragment) {
        synchronized(this) { shaded += Pair(fragment.x, fragment.y) }
        fragment.setColor(depth / 1e9f, fragment.x / 64f, fragment.y / 64f)
    }
}

/** Scenes that make the guarantees of the pipelines measurable. */
internal object PipelineScenes {
    /** [count] layers that cover all of [raster]; the nearest comes last. */
    fun layers(raster: Raster, count: Int, onRow: (index: Int, y: Int) -> Unit = { _, _ -> }): List<Witness> =
        List(count) { index -> Witness(raster.region, Depth.FAR - index) { y -> onRow(index, y) } }

    /** A staircase: a new tile starts every [step] rows and is [alive] steps high, so [alive] tiles cover any row. */
    fun staircase(raster: Raster, step: Int, alive: Int): Frame {
        val builder = FrameBuilder(raster)
        val right = raster.width.toDouble()
        for (top in 0 until raster.height step step) {
            val bottom = minOf(top + step * alive, raster.height).toDouble()
            val z = 0.5 + 0.4 * (top % 97) / 97
            builder.polygon(
                Rgba(0.5f, (top % 7) / 7f, 0.5f),
                doubleArrayOf(0.0, top.toDouble(), z, right, top.toDouble(), z, right, bottom, z, 0.0, bottom, z),
            )
        }
        return builder.build()
    }

    /** [count] triangles that all cover the only column of a raster of [rows] rows. */
    fun crowd(count: Int, rows: Int): Frame {
        val builder = FrameBuilder(Raster(1, rows))
        for (i in 0 until count) {
            val z = 0.1 + 0.8 * (i * 7919L % count) / count
            builder.polygon(Rgba.BLACK, doubleArrayOf(0.0, -1.0, z, 3.0 * rows, -1.0, z, 0.0, 3.0 * rows, z))
        }
        return builder.build()
    }

    /** Runs [block] on a thread with a stack of 128 kilobytes, and rethrows its exceptions. */
    fun <T> onASmallStack(block: () -> T): T {
        var result: Result<T>? = null
        val thread = Thread(null, { result = runCatching(block) }, "small stack", 128L shl 10)
        thread.start()
        thread.join()
        return result!!.getOrThrow()
    }

    /** Bytes in use after a garbage collection. */
    fun usedBytes(): Long {
        repeat(3) { System.gc() }
        val runtime = Runtime.getRuntime()
        return runtime.totalMemory() - runtime.freeMemory()
    }
}
