package dev.lazyz.conformance.probes

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.RowSink
import dev.lazyz.conformance.judgement.Recorder
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

/** A sink that copies its rows, checks that they do not change for a while, and then overwrites them. */
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
        for ((i, array) in arrays.withIndex()) array.fill(NONSENSE + i, 0, frame.width)
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
