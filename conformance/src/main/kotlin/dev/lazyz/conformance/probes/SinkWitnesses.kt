package dev.lazyz.conformance.probes

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.judgement.Recorder
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger

/** A sink that checks which thread calls it. Must be created by the expected thread. */
internal class ThreadWitness : RowSink {
    private val caller = Thread.currentThread()
    private val inside = AtomicInteger()

    /** The first violation, or null. */
    @Volatile
    var complaint: String? = null
        private set

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        val others = inside.getAndIncrement()
        val thread = Thread.currentThread()
        when {
            thread !== caller -> complain("row $y is delivered in ${thread.name}, not in the caller's ${caller.name}")
            others > 0 -> complain("row $y is delivered during another call of the sink")
        }
        inside.decrementAndGet()
    }

    private fun complain(what: String) {
        complaint = complaint ?: what
    }
}

/** A sink that copies its rows, checks that they do not change for a while, and then overwrites some or all of them. */
internal class OverwritingSink(private val frame: Frame) : RowSink {
    private val recorder = Recorder(frame.region)
    private var patience = PATIENT_ROWS

    /** The first violation, or null. */
    var complaint: String? = null
        private set

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        recorder.row(y, argb, depth, primitive)
        val arrays = listOf(argb, depth, primitive)
        val copies = arrays.map { it.copyOf(frame.width) }
        if (patience-- > 0) Thread.sleep(1)
        val isSame = arrays.indices.all { i -> (0 until frame.width).all { arrays[i][it] == copies[i][it] } }
        if (!isSame) complaint = complaint ?: "row $y changes while the sink uses it"

        // All of them or one, by turns: a renderer may know by one array what another one has
        for ((i, array) in arrays.withIndex()) if (y % 4 in listOf(3, i)) array.fill(NONSENSE + i, 0, frame.width)
    }

    /** Returns the delivered picture. */
    fun image(counters: Counters): Image = recorder.image(counters)

    private companion object {
        /** Number of rows that are observed for a millisecond each. */
        const val PATIENT_ROWS = 2
        const val NONSENSE = 0x5A5A5A5A
    }
}

/** A sink that calls [render] at the first rows, and copies each row afterwards. */
internal class RenderingSink(frame: Frame, private val render: () -> Unit) : RowSink {
    private val recorder = Recorder(frame.region)
    private var left = RENDERINGS

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        if (left-- > 0) render()
        recorder.row(y, argb, depth, primitive)
    }

    /** Returns the delivered picture. */
    fun image(counters: Counters): Image = recorder.image(counters)

    private companion object {
        const val RENDERINGS = 3
    }
}

/** Records the lowest row for which the primitives of [frame] were queried for spans, depths or colours. */
internal class RowWitness(frame: Frame) {
    private val deepest = AtomicInteger(-1)

    /** The frame with the observed primitives. */
    val frame: Frame = Frame(frame.raster, frame.primitives.map { Queried(it, ::note) }, frame.region)

    /** The lowest row that was queried, or -1. */
    val last: Int get() = deepest.get()

    private fun note(y: Int) {
        deepest.accumulateAndGet(y, ::maxOf)
    }
}

/** The primitive [whole], which passes the row of each query to [onQuery] before it answers. */
internal class Queried(private val whole: Primitive, private val onQuery: (y: Int) -> Unit) : Primitive by whole {
    override fun spans(y: Int, spans: Spans) {
        onQuery(y)
        whole.spans(y, spans)
    }

    override fun cursor(y: Int): SpanCursor {
        onQuery(y)
        val cursor = whole.cursor(y)
        var row = y
        return SpanCursor {
            onQuery(row++)
            cursor.next(it)
        }
    }

    override fun depth(x: Int, y: Int): Int {
        onQuery(y)
        return whole.depth(x, y)
    }

    override fun shade(fragment: Fragment) {
        onQuery(fragment.y)
        whole.shade(fragment)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? {
        onQuery(y)
        return whole.shadingCursor(x, y)
    }
}

// A promise holds however a frame is rendered: with translucent primitives, in part, and with a selector.

/** Returns the frame; in one of two cases partly translucent, if [renderer] blends; and in one of two cases in part. */
internal fun FrameCase.variedFor(renderer: Renderer, random: Random): FrameCase {
    val choice = random.nextInt()
    val isBlending = Capability.TRANSPARENCY in renderer.capabilities
    val case = if (isBlending && random.nextBoolean()) glazed(choice) else this
    return if (random.nextBoolean()) case.withinAny(random) else case
}

/** Returns this renderer; in one of three cases with a selector, if it supports them. */
internal fun Renderer.varied(random: Random): Renderer =
    if (random.nextInt(3) == 0) configured(SELECTING.supportedBy(this)) else this

private val SELECTING = RenderOptions(selector = Selector.blend())
