package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Counters
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Crew
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.Tools
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import kotlin.concurrent.thread

/** Renderers with mistakes in the use of threads and of the sink. */
internal object ThreadMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::sharesARow, "threads fill one row, and copy it when it is full"),
        Mistake(::sharesAFragment, "threads of one rendering share a fragment"),
        Mistake(::losesUpdates, "threads compare and write the key of a sample without a lock"),
        Mistake(::sharesCounters, "threads count in the same counters without a lock"),
        Mistake(::losesErrors, "an Error that is not an Exception ends its thread and is not reported"),
        Mistake(::callsAfterTheEnd, "when the caller's thread has failed, another thread continues to call primitives"),
        Mistake(::deliversHalfPictures, "an interrupted caller delivers what its threads have finished so far"),
        Mistake(::leavesItsThreads, "an interrupted caller throws, and its threads continue"),
        Mistake(::addsTheOthers, "when several threads fail, the others' exceptions are added to the first"),
        Mistake(::keepsRowsByWidth, "the arrays of a row are in a thread local, for all pictures of a width"),
        Mistake(::keepsAFragment, "the fragment is in a field, for all renderings"),
        Mistake(::keepsSpans, "the spans are in a field, for all renderings"),
        Mistake(::keepsDepthsOfPlanes, "the depths of planes are in a field, for all renderings"),
        Mistake(::rendersOneAtATime, "a lock lets one rendering run at a time"),
        Mistake(::endsAfterAll, "InterruptedException is thrown when the picture is ready"),
        Mistake(::looksTwice, "whether the thread is interrupted is looked at before the primitives, and after them"),
        Mistake(::callsFromAThread, "the sink is called by a thread of the renderer's own"),
        Mistake(::callsAtOnce, "several threads call the sink, each with its row"),
        Mistake(::writesOnlyChanges, "an element of a row is written only if it differs from the row before"),
        Mistake(::fillsRowsLater, "the next row is written into the arrays that the sink still has"),
        Mistake(::keepsRowsInAThread, "the arrays of a row are in a thread local, for all renderings"),
        Mistake(::losesTheInterrupt, "the interrupt status is cleared, and the picture is made all the same"),
        Mistake(::interruptsTwice, "InterruptedException is thrown with the status still set"),
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
            ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
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
            ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
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
        ZBufferRenderer().render(frame, sink).also { helper.join() }
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

    /** A first pass finds depths, and a second one colours. Threads do not meet in planes, such as those of meshes. */
    private fun keepsDepthsOfPlanes(): BrokenRenderer {
        val depths = IntArray(1 shl 16)
        return BrokenRenderer("keeps-depths-of-planes") { frame, sink ->
            val isKept = frame.region.size <= depths.size && frame.primitives.all { it.depthForm != null }
            if (isKept) ZBufferRenderer().render(frame).depth.copyInto(depths)
            ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
                val at = (y - frame.region.rowStart) * frame.width
                if (isKept) depths.copyInto(depth, 0, at, at + frame.width)
                sink.row(y, argb, depth, primitive)
            }
        }
    }

    private fun rendersOneAtATime(): BrokenRenderer {
        val lock = Any()
        return BrokenRenderer("renders-one-at-a-time") { frame, sink ->
            synchronized(lock) { ZBufferRenderer().render(frame, sink) }
        }
    }

    private fun endsAfterAll() = interruptible("ends-after-all", isFirst = false)

    private fun looksTwice() = interruptible("looks-twice", isFirst = true)

    /** A renderer that looks at the interrupt status at the end, and, if [isFirst], at the begin. */
    private fun interruptible(id: String, isFirst: Boolean) = BrokenRenderer(id) { frame, sink ->
        fun look() {
            if (Thread.interrupted()) throw InterruptedException()
        }
        if (isFirst) look()
        val image = Recording.of(ReferenceRenderer(), frame).image
        look()
        emit(image, sink)
    }

    private fun callsFromAThread() = BrokenRenderer("calls-from-a-thread") { frame, sink ->
        val image = ZBufferRenderer().render(frame)
        thread { emit(image, sink) }.join()
        image.counters
    }

    private fun callsAtOnce() = BrokenRenderer("calls-at-once") { frame, sink ->
        val image = ZBufferRenderer().render(frame)
        (0 until image.height).map { row -> thread { emit(image, sink, listOf(row)) } }.forEach { it.join() }
        image.counters
    }

    private fun writesOnlyChanges() = BrokenRenderer("writes-only-changes") { frame, sink ->
        val image = ZBufferRenderer().render(frame)
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
        ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
            val next = thread { depth.fill(y) }
            sink.row(y, argb, depth, primitive)
            next.join()
        }
    }

    private fun losesTheInterrupt() = BrokenRenderer("loses-the-interrupt") { frame, sink ->
        Thread.interrupted()
        ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
            sink.row(y, argb, depth, primitive)
            Thread.interrupted()
        }
    }

    private fun interruptsTwice() = BrokenRenderer("interrupts-twice") { frame, sink ->
        try {
            ZBufferRenderer().render(frame, sink)
        } catch (e: InterruptedException) {
            Thread.currentThread().interrupt()
            throw e
        }
    }
}
