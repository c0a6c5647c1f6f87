package dev.lazyz.conformance.strangers5

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import java.util.concurrent.atomic.AtomicReference

/**
 * Depth peeling within a budget: an image of keys for what is opaque, and then layer after layer of what is translucent
 * before it, for pieces of the image that are as large as the budget allows.
 */
internal class Peeler(private val options: RenderOptions = RenderOptions(), private val mistake: Mistake? = null) :
    Renderer {
    private val pool = AtomicReference<PeelerArrays?>()

    override val id: String get() = "peeler5"
    override val summary: String get() = "peels layers of depth, piece by piece, within a budget"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.STREAMS_PRIMITIVES,
            Capability.TRANSPARENCY,
            Capability.MEMORY_BUDGET,
        )

    override fun configured(options: RenderOptions): Renderer = Peeler(options.requireSupportedBy(this), mistake)

    @Throws(InterruptedException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        if (mistake != Mistake.PEELER_DIRTY_POOL) return render(frame, PeelerImage(frame, mistake, null), sink)
        val image = PeelerImage(frame, mistake, pool.getAndSet(null))
        try {
            return render(frame, image, sink)
        } finally {
            pool.set(image.arrays)
        }
    }

    private fun render(frame: Frame, image: PeelerImage, sink: RowSink): Counters {
        val counters = image.counters
        for ((index, primitive) in frame.primitives.withIndex()) {
            image.checkInterrupt()
            if (primitive.meets(frame.region) && !primitive.isTranslucent) image.draw(primitive, index)
        }
        counters.primitives = frame.primitives.size.toLong()
        counters.peakBytes = 12L * image.size
        if (frame.hasTranslucency) {
            val length = pieceLength(image.size)
            val layers = PeelerLayers(frame, image, length, mistake)

            // A single sample's state is as a few local variables, and does not count
            if (length > 1) counters.peakBytes += PeelerLayers.BYTES * length
            for (start in 0 until image.size step length) layers.peel(start, minOf(start + length, image.size))
        } else {
            for (at in 0 until image.size) image.color(at)
        }
        image.handOut(sink)
        return counters.build()
    }

    private fun pieceLength(size: Int): Int {
        val budget = options.memoryBudget ?: (MOST * PeelerLayers.BYTES)
        val least = if (mistake == Mistake.PEELER_LEAST_PIECE) 4096L else 1L
        return (budget / PeelerLayers.BYTES).coerceIn(least, maxOf(MOST, least)).coerceAtMost(size.toLong()).toInt()
    }

    private companion object {
        const val MOST = 65536L
    }
}

/** Colours and keys of a region, 12 bytes a sample. */
internal class PeelerImage(private val frame: Frame, private val mistake: Mistake?, pooled: PeelerArrays?) {
    private val region = frame.region
    private val width = region.width
    private val test = frame.raster.depthTest
    private val background = frame.raster.background.toArgb()
    private val fragment = Fragment()
    private val rows = PeelerRows(frame, mistake)

    /** What the rendering took so far. */
    val counters = Counters.Builder()

    /** Number of samples. */
    val size: Int = Math.multiplyExact(width, region.height)
    private val empty = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)

    /** The arrays, which may be used again for as many samples. */
    val arrays: PeelerArrays = pooled?.takeIf { it.argb.size == size } ?: PeelerArrays(size)
    private val argb = arrays.argb
    private val uppers = arrays.uppers
    private val lowers = arrays.lowers

    init {
        if (mistake != Mistake.PEELER_DIRTY_POOL || arrays.filling != empty) fill()
    }

    private fun fill() {
        uppers.fill((empty ushr 32).toInt())
        lowers.fill(empty.toInt())
        arrays.filling = empty
    }

    /** Throws if the thread is interrupted. */
    fun checkInterrupt() {
        if (Thread.interrupted()) throw InterruptedException("interrupted while peeling")
    }

    /** Draws an opaque primitive. */
    fun draw(primitive: dev.lazyz.Primitive, index: Int) {
        for (y in maxOf(primitive.rowStart, region.rowStart) until minOf(primitive.rowEnd, region.rowEnd)) {
            rows.forEach(primitive, y, region.columnStart, region.columnEnd) { x, depth ->
                counters.fragments++
                counters.depthEvaluations++
                val key = test.key(depth, index)
                val at = (y - region.rowStart) * width + x - region.columnStart
                val upper = (key ushr 32).toInt()
                if (upper < uppers[at] || (upper == uppers[at] && key.toInt() < lowers[at])) {
                    counters.depthPasses++
                    set(at, key)
                }
            }
        }
    }

    /** Returns the key at a sample. */
    fun key(at: Int): Long = uppers[at].toLong() shl 32 or lowers[at].toLong()

    /** Sets the key at a sample. */
    fun set(at: Int, key: Long) {
        uppers[at] = (key ushr 32).toInt()
        lowers[at] = key.toInt()
    }

    /** Sets the colour at a sample. */
    fun setColor(at: Int, color: Int) {
        argb[at] = color
    }

    /** Colours a sample where nothing is before its key. */
    fun color(at: Int) {
        val index = test.indexOf(key(at))
        argb[at] = if (index == DepthTest.BACKGROUND) background else shade(at, index).toArgb()
    }

    /** Shades the primitive [index] at a sample. */
    fun shade(at: Int, index: Int): Fragment {
        counters.shadingCalls++
        counters.shadingStarts++
        counters.peakSuspensions = size.toLong()
        fragment.moveTo(region.columnStart + at % width, region.rowStart + at / width)
        frame.primitives[index].shade(fragment)
        return fragment
    }

    /**
     * Hands out all rows, out of the image's own arrays: each is moved to their beginning, where a row has gone
     * already.
     */
    fun handOut(sink: RowSink) {
        for (row in 0 until region.height) {
            checkInterrupt()
            val from = row * width
            for (i in 0 until width) {
                val key = key(from + i)
                argb[i] = argb[from + i]
                uppers[i] = test.depthOf(key)
                lowers[i] = test.indexOf(key)
            }
            sink.row(region.rowStart + row, argb, uppers, lowers)
        }
        if (mistake == Mistake.PEELER_DIRTY_POOL) fill()
    }
}

/** Colours and keys of [size] samples, and with what keys they were filled last. */
internal class PeelerArrays(size: Int) {
    val argb = IntArray(size)
    val uppers = IntArray(size)
    val lowers = IntArray(size)
    var filling = -1L
}
