package dev.lazyz.conformance.broken.gallery

import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Spans
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.BrokenRenderer
import dev.lazyz.conformance.broken.BrokenReuse
import dev.lazyz.conformance.broken.Crew
import dev.lazyz.conformance.broken.Tools
import dev.lazyz.conformance.broken.emit
import dev.lazyz.conformance.broken.gallery.RuleNames.caller
import dev.lazyz.conformance.broken.gallery.RuleNames.finish
import dev.lazyz.conformance.broken.gallery.RuleNames.halfDone
import dev.lazyz.conformance.broken.gallery.RuleNames.late
import dev.lazyz.conformance.broken.gallery.RuleNames.lost
import dev.lazyz.conformance.broken.gallery.RuleNames.lostCounts
import dev.lazyz.conformance.broken.gallery.RuleNames.meets
import dev.lazyz.conformance.broken.gallery.RuleNames.nested
import dev.lazyz.conformance.broken.gallery.RuleNames.overwrites
import dev.lazyz.conformance.broken.gallery.RuleNames.status
import dev.lazyz.conformance.broken.gallery.RuleNames.workers
import dev.lazyz.strategies.zbuffer.ZBuffer
import kotlin.concurrent.thread

/** The gallery's part about threads and the sink. */
internal object ThreadGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(::sharesARow, "threads fill one row, and copy it when it is full", lost),
        Mutant(::sharesAFragment, "threads of one rendering share a fragment", lost),
        Mutant(::losesUpdates, "threads compare and write the key of a sample without a lock", lost),
        Mutant(::sharesCounters, "threads count in the same counters without a lock", lostCounts),
        Mutant(::losesErrors, "an Error that is not an Exception ends its thread and is not reported", workers),
        Mutant(
            ::callsAfterTheEnd,
            "when the caller's thread has failed, another thread continues to call primitives",
            late,
        ),
        Mutant(
            ::deliversHalfPictures,
            "an interrupted caller delivers what its threads have finished so far",
            halfDone,
        ),
        Mutant(::leavesItsThreads, "an interrupted caller throws, and its threads continue", halfDone),
        Mutant(::addsTheOthers, "when several threads fail, the others' exceptions are added to the first", workers),
        Mutant(BrokenFailures::stopsInterruptedWorkers, "a worker that is interrupted leaves its rows", finish),
        Mutant(BrokenFailures::claimsTilesTwice, "sometimes two threads draw the same tile", lostCounts),
        Mutant(::keepsRowsByWidth, "the arrays of a row are in a thread local, for all pictures of a width", nested),
        Mutant(::keepsAFragment, "the fragment is in a field, for all renderings", meets),
        Mutant(::keepsSpans, "the spans are in a field, for all renderings", meets),
        Mutant(::callsFromAThread, "the sink is called by a thread of the renderer's own", caller),
        Mutant(::callsAtOnce, "several threads call the sink, each with its row", caller),
        Mutant(
            ::writesOnlyChanges,
            "an element of a row is written only if it differs from the row before",
            overwrites,
        ),
        Mutant(
            BrokenReuse::fillsEmptyBandsOnce,
            "a band of rows without primitives is not filled again after another such band",
            RuleNames.emptyRows,
        ),
        Mutant(::fillsRowsLater, "the next row is written into the arrays that the sink still has", overwrites),
        Mutant(::keepsRowsInAThread, "the arrays of a row are in a thread local, for all renderings", nested),
        Mutant(::losesTheInterrupt, "the interrupt status is cleared, and the picture is made all the same", status),
        Mutant(::interruptsTwice, "InterruptedException is thrown with the status still set", status),
    )

    private fun crew(id: String, threads: Int, tools: () -> Tools) = BrokenRenderer(id) { frame, sink ->
        emit(Crew(frame, threads, tools()).render(), sink)
    }

    private fun leavesItsThreads() = crew("leaves-its-threads", 2) { Tools(isHasty = true) }

    private fun addsTheOthers() = crew("adds-the-others", 2) { Tools(isComplete = true) }

    private fun keepsRowsByWidth(): BrokenRenderer {
        val rows = ThreadLocal.withInitial { HashMap<Int, List<IntArray>>() }
        return BrokenRenderer("keeps-rows-by-width") { frame, sink ->
            val own = rows.get().getOrPut(frame.width) { List(3) { IntArray(frame.width) } }
            ZBuffer().render(frame) { y, argb, depth, primitive ->
                for ((from, to) in listOf(argb, depth, primitive).zip(own)) from.copyInto(to, 0, 0, frame.width)
                sink.row(y, own[0], own[1], own[2])
            }
        }
    }

    private fun keepsRowsInAThread(): BrokenRenderer {
        val rows = ThreadLocal.withInitial { List(3) { IntArray(0) } }
        return BrokenRenderer("keeps-rows-in-a-thread") { frame, sink ->
            if (rows.get()[0].size < frame.width) rows.set(List(3) { IntArray(frame.width) })
            val own = rows.get()
            ZBuffer().render(frame) { y, argb, depth, primitive ->
                for ((from, to) in listOf(argb, depth, primitive).zip(own)) from.copyInto(to, 0, 0, frame.width)
                sink.row(y, own[0], own[1], own[2])
            }
        }
    }

    private fun callsAfterTheEnd() = BrokenRenderer("calls-after-the-end") { frame, sink ->
        val helper = thread(isDaemon = true) {
            val spans = Spans()
            try {
                for (y in frame.region.rowStart until frame.region.rowEnd) {
                    frame.primitives.forEach {
                        it.spans(y, spans.apply { clear() })
                    }
                }
            } catch (_: Exception) {
                // The caller takes part, too
            }
        }
        ZBuffer().render(frame, sink).also { helper.join() }
    }

    private fun sharesARow() = crew("shares-a-row", 4) {
        var row: IntArray? = null
        Tools(row = { width -> synchronized(this) { row ?: IntArray(width).also { row = it } } })
    }

    private fun sharesAFragment() = crew("shares-a-fragment", 4) {
        val fragment = Fragment()
        Tools(fragment = { fragment })
    }

    private fun losesUpdates() = crew("loses-updates", 4) { Tools(isLocked = false) }

    private fun sharesCounters() = crew("shares-counters", 4) {
        val counters = Counters.Builder()
        Tools(counters = { counters })
    }

    private fun losesErrors() = crew("loses-errors", 4) { Tools(isPassedOn = { it !is Error }) }

    private fun deliversHalfPictures() = crew("delivers-half-pictures", 4) { Tools(isPatient = false) }

    private fun keepsAFragment(): BrokenRenderer {
        val fragment = Fragment()
        return crew("keeps-a-fragment", 1) { Tools(fragment = { fragment }) }
    }

    private fun keepsSpans(): BrokenRenderer {
        val spans = Spans()
        return crew("keeps-spans", 1) { Tools(spans = { spans }) }
    }

    private fun callsFromAThread() = BrokenRenderer("calls-from-a-thread") { frame, sink ->
        val image = ZBuffer().render(frame)
        thread { emit(image, sink) }.join()
        image.counters
    }

    private fun callsAtOnce() = BrokenRenderer("calls-at-once") { frame, sink ->
        val image = ZBuffer().render(frame)
        (0 until image.height).map { row -> thread { emit(image, sink, listOf(row)) } }.forEach { it.join() }
        image.counters
    }

    private fun writesOnlyChanges() = BrokenRenderer("writes-only-changes") { frame, sink ->
        val image = ZBuffer().render(frame)
        val rows = List(3) { IntArray(image.width) }
        for (y in 0 until image.height) {
            listOf(image.argb, image.depth, image.primitive).forEachIndexed { i, all ->
                for (x in 0 until image.width) {
                    val at = y * image.width + x
                    if (y == 0 || all[at] != all[at - image.width]) rows[i][x] = all[at]
                }
            }
            sink.row(image.region.rowStart + y, rows[0], rows[1], rows[2])
        }
        image.counters
    }

    private fun fillsRowsLater() = BrokenRenderer("fills-rows-later") { frame, sink ->
        ZBuffer().render(frame) { y, argb, depth, primitive ->
            val next = thread { depth.fill(y) }
            sink.row(y, argb, depth, primitive)
            next.join()
        }
    }

    private fun losesTheInterrupt() = BrokenRenderer("loses-the-interrupt") { frame, sink ->
        Thread.interrupted()
        ZBuffer().render(frame) { y, argb, depth, primitive ->
            sink.row(y, argb, depth, primitive)
            Thread.interrupted()
        }
    }

    private fun interruptsTwice() = BrokenRenderer("interrupts-twice") { frame, sink ->
        try {
            ZBuffer().render(frame, sink)
        } catch (e: InterruptedException) {
            Thread.currentThread().interrupt()
            throw e
        }
    }
}
