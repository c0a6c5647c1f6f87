package dev.lazyz.strategies.hybrid

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.pipeline.GuardedDrawing
import dev.lazyz.raster.forEachKey
import dev.lazyz.raster.forEachPrimitive
import dev.lazyz.raster.forEachRow
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Spans
import java.io.IOException

/**
 * Scan-converts each primitive as it arrives, and suspends the colours until the end.
 *
 * The memory of suspensions is accounted for. A primitive that is visible somewhere so far holds a record with the
 * runs of samples at which it was visible when it was drawn. If primitives arrive as a stream, the primitive itself is
 * kept as well (see [dev.lazyz.Primitive.heldBytes]). The record is freed when the primitive's last sample is covered
 * by a nearer primitive. Before these bytes would exceed [RenderOptions.memoryBudget], all suspended colours are
 * computed, which frees their records; after that, colours are suspended again. A primitive whose record does not fit
 * into the budget alone is shaded as it is drawn. Any budget, including 0, therefore gives the same picture; with less
 * memory, more shaded samples are covered later. The number of extra shading calls is [Counters.shadingCalls] minus
 * the number of visible samples.
 *
 * Use it when primitives arrive one by one and shading is expensive, and to keep the memory of a rendering within a
 * known limit.
 *
 * Memory: 12 bytes a sample, and suspensions within the budget; in addition, only the current primitive and objects of
 * constant size. Time: proportional to the number of fragments. Thread safe; no state between calls.
 *
 * Source: Steve Hill, "The Lazy Z-Buffer", Information Processing Letters 55 (1995): the hybrid algorithm (eager spine,
 * lazy elements), and the desperate evaluator, which forces suspensions to reclaim memory.
 */
public class HybridRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) :
    StreamingRenderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "hybrid"

    override val summary: String get() = "draws at once and shades at the end, or earlier to keep to a memory budget"

    /** With a memory budget, shading may happen early, so [Capability.SHADES_ONLY_VISIBLE] holds only without one. */
    override val capabilities: Set<Capability>
        get() = if (options.memoryBudget == null) ALWAYS + Capability.SHADES_ONLY_VISIBLE else ALWAYS

    override fun configured(options: RenderOptions): HybridRenderer = HybridRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val cost = if (frame.isStreamed) PrimitiveCost.HELD else PrimitiveCost.NONE
        val samples = SuspendedSamples(frame, options, cost)
        frame.forEachPrimitive(Checkpoint.CALLER) { _, primitive -> samples.draw(primitive) }
        return samples.finish(sink)
    }

    /** Begins an image. A primitive is kept only as long as a suspended colour needs it. */
    override fun begin(raster: Raster, region: Region): Rendering {
        val samples = SuspendedSamples(Frame(raster, emptyList(), region), options, PrimitiveCost.HELD)
        return GuardedDrawing(this, samples::draw, samples::finish)
    }

    override fun toString(): String = "HybridRenderer($options)"

    private companion object {
        val ALWAYS: Set<Capability> =
            setOf(Capability.STREAMS_PRIMITIVES, Capability.MEMORY_BUDGET, Capability.COHERENCE)
    }
}

/**
 * The image: a visibility key and a colour for each sample; the colour may be suspended.
 *
 * Uses exactly 12 bytes a sample, in three int arrays, so that rows can be passed to the sink from these arrays. Each
 * half of a key has 31 bits. The sign bit of the lower half is set if the colour is suspended; the colour's array
 * element then holds the slot of the record that holds the suspension.
 */
internal class SuspendedSamples(private val frame: Frame, options: RenderOptions, cost: PrimitiveCost) {
    private val raster = frame.raster
    private val region = frame.region
    private val width = region.width
    private val test = raster.depthTest
    private val spans = region.spans()
    private val counters = Counters.Builder()

    private val argb: IntArray
    private val uppers: IntArray
    private val lowers: IntArray
    private val suspensions: Suspensions
    private val shading: LateShading

    /** The record of the current primitive, or null. */
    private var record: Record? = null

    /** Whether there is no room for a record of the current primitive, so that its colours cannot be suspended. */
    private var isEager = false

    init {
        require(region.size <= Image.MAX_SAMPLES) {
            "an image holds at most ${Image.MAX_SAMPLES} samples: ${region.size}"
        }
        val size = region.size.toInt()
        argb = IntArray(size)
        uppers = IntArray(size)
        lowers = IntArray(size)
        val background = test.key(raster.backgroundDepth, DepthTest.BACKGROUND)
        argb.fill(raster.background.toArgb())
        uppers.fill((background ushr 32).toInt())
        lowers.fill(background.toInt())

        // The state of incremental shading is part of the budget; without room for it, shade directly
        val budget = options.memoryBudget ?: Long.MAX_VALUE
        val isStepping = options.coherence != Coherence.DIRECT && budget >= CHAIN_BYTES
        suspensions = Suspensions(budget, if (isStepping) CHAIN_BYTES else 0, cost)
        val coherence = if (isStepping) options.coherence else Coherence.DIRECT
        shading = LateShading(frame, coherence, counters, Checkpoint.CALLER)
    }

    fun draw(primitive: Primitive) {
        val index = counters.primitives++.toInt()
        record = null
        isEager = false
        primitive.forEachRow(region, spans) { y ->
            shading.beginRow()
            for (i in 0 until spans.count) drawSpan(primitive, index, y, spans.start(i), spans.end(i))
        }
        record = null
    }

    private fun drawSpan(primitive: Primitive, index: Int, y: Int, start: Int, end: Int) {
        counters.fragments += end - start
        counters.depthEvaluations += end - start
        val offset = (y - region.rowStart) * width - region.columnStart
        var run = start
        primitive.forEachKey(index, test, y, start, end) { x, key ->
            if (isNearer(key, offset + x)) {
                if (run == x) beginRun(primitive, index)
                replace(primitive, x, y, offset + x, key)
            } else {
                if (run < x) record?.add(offset + run, x - run)
                run = x + 1
            }
        }
        if (run < end) record?.add(offset + run, end - run)
    }

    private fun isNearer(key: Long, at: Int): Boolean {
        val upper = (key ushr 32).toInt()
        return upper < uppers[at] || (upper == uppers[at] && key.toInt() < (lowers[at] and SUSPENDED.inv()))
    }

    /** Ensures that there is a record with room for one more run, or that nothing is suspended. */
    private fun beginRun(primitive: Primitive, index: Int) {
        if (isEager) return
        val present = record ?: suspensions.open(primitive, index).also { record = it }
        if (present != null && suspensions.makeRoom(present)) return

        // A primitive that would not fit even alone is shaded as it is drawn
        isEager = !suspensions.couldOpen(primitive)
        if (isEager && present == null) return

        // Desperate evaluation: compute all suspended colours, then continue to suspend
        forceAll()
        record = if (isEager) null else suspensions.open(primitive, index)
    }

    /** Replaces the fragment at [at] with a nearer one. */
    private fun replace(primitive: Primitive, x: Int, y: Int, at: Int, key: Long) {
        counters.depthPasses++
        if (lowers[at] < 0) suspensions.drop(argb[at])
        uppers[at] = (key ushr 32).toInt()
        val holder = record
        if (holder != null) {
            lowers[at] = key.toInt() or SUSPENDED
            argb[at] = holder.slot
            suspensions.suspend(holder)
        } else {
            lowers[at] = key.toInt()
            argb[at] = shading.shaded(x, y, test.indexOf(key), primitive).toArgb()
        }
    }

    /** Computes all suspended colours, record by record, and frees the records. */
    private fun forceAll() {
        suspensions.forEach { record ->
            var row = -1
            for (run in 0 until record.runCount) {
                // Incremental shading does not continue beyond a row of its primitive
                val start = record.runStart(run)
                if (start / width != row) shading.beginRow()
                row = start / width
                for (at in start until start + record.runLength(run)) {
                    if (lowers[at] >= 0 || argb[at] != record.slot) continue
                    val x = region.columnStart + at - row * width
                    argb[at] = shading.shaded(x, region.rowStart + row, record.index, record.primitive).toArgb()
                    lowers[at] = lowers[at] and SUSPENDED.inv()
                }
            }
            shading.beginRow()
        }
        suspensions.clear()
    }

    /** Computes the suspended colours and passes the rows to [sink]. */
    fun finish(sink: RowSink): Counters {
        forceAll()
        counters.peakSuspensions = suspensions.peakAlive
        counters.peakBytes = argb.bytes + uppers.bytes + lowers.bytes + suspensions.peakBytes
        for (row in 0 until region.height) {
            endIfInterrupted()

            // Decode the row into the front of the arrays, which holds only rows that the sink has already received
            val from = row * width
            for (i in 0 until width) {
                val key = uppers[from + i].toLong() shl 32 or lowers[from + i].toLong()
                argb[i] = argb[from + i]
                uppers[i] = test.depthOf(key)
                lowers[i] = test.indexOf(key)
            }
            sink.row(region.rowStart + row, argb, uppers, lowers)
        }
        return counters.build()
    }

    private companion object {
        /** The sign bit of a key's lower half. */
        const val SUSPENDED = 1 shl 31

        /** A hash map with its table, and the state of one incremental evaluation: at most one exists at a time. */
        const val CHAIN_BYTES = 512L
    }
}
