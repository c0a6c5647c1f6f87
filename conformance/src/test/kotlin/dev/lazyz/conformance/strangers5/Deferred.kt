package dev.lazyz.conformance.strangers5

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink

/**
 * A deferred renderer: bands of rows, each a buffer of keys with linked lists of translucent fragments, decided first
 * and shaded afterwards, column by column. Several threads take bands; the caller takes part, and hands out finished
 * bands in order.
 */
internal class Deferred(private val options: RenderOptions = RenderOptions(), private val mistake: Mistake? = null) :
    Renderer {
    private var cached: DeferredBands? = null

    override val id: String get() = "deferred5"
    override val summary: String get() = "bands of keys and lists on several threads, shaded by columns"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.PARALLEL, Capability.TRANSPARENCY,
        )

    override fun configured(options: RenderOptions): Renderer = Deferred(options.requireSupportedBy(this), mistake)

    @Throws(InterruptedException::class)
    override fun render(frame: Frame, sink: RowSink): Counters =
        DeferredCrew(frame, bands(frame), options.threads, mistake).run(sink)

    private fun bands(frame: Frame): DeferredBands {
        val height = maxOf(1, options.tileSize / ROWS)
        if (mistake != Mistake.DEFERRED_CACHED_BANDS) return DeferredBands(frame, height, mistake)
        val old = cached
        if (old != null && old.primitives === frame.primitives && old.region.height == frame.height) return old
        return DeferredBands(frame, height, mistake).also { cached = it }
    }

    private companion object {
        /** Rows of a band for each so many of a tile. */
        const val ROWS = 8
    }
}

/** Which primitives reach which bands of [height] rows, from the region's first row on. */
internal class DeferredBands(frame: Frame, val height: Int, mistake: Mistake?) {
    val region = frame.region
    val primitives = frame.primitives

    /** Number of bands. */
    val count: Int = (region.height + height - 1) / height

    /** Submission indices of primitives, and the first and the last band that each reaches. */
    val indices: IntArray
    private val firsts: IntArray
    private val lasts: IntArray

    init {
        var found = IntArray(8)
        var size = 0
        for ((index, primitive) in primitives.withIndex()) {
            if (!primitive.meets(region)) continue
            if (size == found.size) found = found.copyOf(2 * size)
            found[size++] = index
        }
        indices = found.copyOf(size)
        val origin = if (mistake == Mistake.DEFERRED_BANDS_OF_RASTER) {
            region.rowStart / height * height
        } else {
            region.rowStart
        }
        firsts = IntArray(size) { (maxOf(primitives[indices[it]].rowStart, region.rowStart) - origin) / height }
        lasts = IntArray(size) { (minOf(primitives[indices[it]].rowEnd, region.rowEnd) - 1 - origin) / height }
    }

    /** Whether number [i] of [indices] reaches a [band]. */
    fun reaches(i: Int, band: Int): Boolean = firsts[i] <= band && band <= lasts[i]

    /** Bytes held. */
    val bytes: Long get() = 12L * indices.size
}
