package dev.lazyz.conformance.mutants

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.conformance.probes.answer
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans

/**
 * State of the threads of a [Crew]. Each thread has its own, if these functions create new instances.
 *
 * @property isLocked whether samples are compared and written under a lock
 * @property isPatient whether the caller waits for its threads even if it is interrupted
 * @property isHasty whether an interrupted caller throws at once, and does not wait for its threads
 * @property isComplete whether the failures of all threads reach the caller, as suppressed exceptions of the first
 * @property isPassedOn which failures of the threads reach the caller
 */
internal class Tools(
    val isLocked: Boolean = true,
    val isPatient: Boolean = true,
    val isHasty: Boolean = false,
    val isComplete: Boolean = false,
    val isPassedOn: (Throwable) -> Boolean = { true },
    val counters: () -> Counters.Builder = { Counters.Builder() },
    val spans: () -> Spans = { Spans() },
    val fragment: () -> Fragment = { Fragment() },
    val row: (width: Int) -> IntArray = { IntArray(it) },
)

/** A plain renderer with its own [threads], which process primitives and then rows in turn. Used once. */
internal class Crew(private val frame: Frame, private val threads: Int, private val tools: Tools) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val background = frame.raster.background.toArgb()
    private val keys = LongArray(region.size.toInt()) { test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND) }
    private val argb = IntArray(keys.size)

    fun render(): Image {
        require(!frame.hasTranslucency) { "does not blend: make it opaque" }
        val counters = List(threads) { tools.counters() }
        together { number ->
            val spans = tools.spans()
            for (index in number until frame.primitives.size step threads) draw(index, spans, counters[number])
        }
        together { number ->
            val fragment = tools.fragment()
            val row = tools.row(region.width)
            for (y in number until region.height step threads) shade(y, row, fragment, counters[number])
        }
        val sum = counters.distinct().fold(Counters.Builder()) { sum, part -> sum.add(part.build()) }
        sum.primitives = frame.primitives.size.toLong()
        sum.peakBytes = 12 * region.size
        return Image(region, argb, IntArray(keys.size) { test.depthOf(keys[it]) }, indices(), sum.build())
    }

    private fun indices() = IntArray(keys.size) { test.indexOf(keys[it]) }

    private fun draw(index: Int, spans: Spans, counters: Counters.Builder) {
        val primitive = frame.primitives[index]
        if (maxOf(primitive.columnStart, region.columnStart) >= minOf(primitive.columnEnd, region.columnEnd)) return
        for (y in maxOf(primitive.rowStart, region.rowStart) until minOf(primitive.rowEnd, region.rowEnd)) {
            spans.clear()
            primitive.spans(y, spans)
            for (i in 0 until spans.count) {
                val from = maxOf(spans.start(i), region.columnStart)
                for (x in from until minOf(spans.end(i), region.columnEnd)) {
                    val key = test.key(primitive.depth(x, y), index)
                    counters.fragments++
                    counters.depthEvaluations++
                    val at = (y - region.rowStart) * region.width + x - region.columnStart
                    if (tools.isLocked) synchronized(keys) { merge(at, key, counters) } else merge(at, key, counters)
                }
            }
        }
    }

    private fun merge(at: Int, key: Long, counters: Counters.Builder) {
        if (key >= keys[at]) return
        keys[at] = key
        counters.depthPasses++
    }

    private fun shade(y: Int, row: IntArray, fragment: Fragment, counters: Counters.Builder) {
        for (x in 0 until region.width) {
            val index = test.indexOf(keys[y * region.width + x])
            row[x] = background
            if (index == DepthTest.BACKGROUND) continue
            fragment.moveTo(region.columnStart + x, region.rowStart + y)
            frame.primitives[index].shade(fragment)
            counters.shadingCalls++
            row[x] = fragment.toArgb()
        }
        row.copyInto(argb, y * region.width, 0, region.width)
    }

    /** Runs [work] in all threads, and passes on an exception that one of them throws, and an interrupt. */
    private fun together(work: (Int) -> Unit) {
        val thrown = arrayOfNulls<Throwable>(threads)
        val workers = List(threads) { number ->
            Thread { thrown[number] = answer { work(number) }?.takeIf(tools.isPassedOn) }
        }
        workers.forEach { it.start() }
        var isInterrupted = false
        for (worker in workers) {
            while (worker.isAlive) {
                try {
                    worker.join()
                } catch (e: InterruptedException) {
                    if (tools.isHasty) throw e
                    isInterrupted = true
                    if (!tools.isPatient) break
                }
            }
        }
        if (isInterrupted) Thread.currentThread().interrupt()
        val failures = thrown.filterNotNull()
        if (tools.isComplete) failures.drop(1).forEach { failures[0].addSuppressed(it) }
        failures.firstOrNull()?.let { throw it }
    }
}
