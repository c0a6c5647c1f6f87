package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.probes.threads.Crowd
import dev.lazyz.conformance.probes.threads.KindOfWork
import dev.lazyz.conformance.probes.threads.Where
import dev.lazyz.conformance.probes.threads.completesOrThrowsIfInterrupted
import dev.lazyz.conformance.probes.threads.countsEachTileOnce
import dev.lazyz.conformance.probes.threads.countsInACrowd
import dev.lazyz.conformance.probes.threads.finishesIfWorkersAreInterrupted
import dev.lazyz.conformance.probes.threads.leavesNoInterrupt
import dev.lazyz.conformance.probes.threads.makesNoLateQueries
import dev.lazyz.conformance.probes.threads.passesOnFailuresOfWorkers
import dev.lazyz.conformance.probes.threads.rightInACrowd
import dev.lazyz.conformance.probes.threads.whileTheyMeet
import net.jqwik.api.ForAll

/** Rules about the renderer's own threads and the results of their work. Part of `RendererConformance`. */
public sealed interface WorkerRules : RulesForOne {
    /** What a primitive throws in one of the renderer's own threads reaches the caller: exceptions and errors. */
    @Rule(
        intent = "A failure in any thread reaches the caller, including errors.",
        look = "Catch Throwable in each thread, rethrow the first in the caller's thread, and deliver no " +
            "half-finished row.",
        isSpecial = true,
    )
    public fun rule_7_1_failuresInThreadsReachTheCaller() {
        passesOnFailuresOfWorkers(renderer().configured(FOUR_THREADS))
    }

    /** After a rendering has failed, its threads make no more calls. */
    @Rule(
        intent = "When a rendering has ended, the caller may close the resources that its frame uses.",
        look = "Wait for all threads before you rethrow a failure of the caller's own part or of the sink.",
    )
    public fun rule_7_1_primitivesAreNotCalledAfterTheEnd() {
        makesNoLateQueries(renderer().configured(FOUR_THREADS))
    }

    /** A caller that is interrupted while the renderer's own threads are working never gets half a picture. */
    @Rule(
        intent = "A caller interrupted while it waits for worker threads keeps waiting or throws: half a picture is " +
            "wrong.",
        look = "Look at each join, get, await and acquire: after InterruptedException the other threads are not " +
            "finished.",
        isSpecial = true,
    )
    public fun rule_7_1_interruptedCallersGetNoHalfPicture() {
        val renderer = renderer().configured(FOUR_THREADS)
        for (isBefore in listOf(true, false)) completesOrThrowsIfInterrupted(renderer, isBefore)
    }

    /** The renderer's own threads may be interrupted, for example by the code of a primitive, without any effect. */
    @Rule(
        intent = "An interrupt of a thread that works for the renderer is not the caller's, and changes nothing.",
        look = "Look for loops of worker threads that end when the thread is interrupted, and for waits that do.",
        isSpecial = true,
    )
    public fun rule_7_8_interruptedWorkersFinishTheirWork() {
        finishesIfWorkersAreInterrupted(renderer().configured(FOUR_THREADS))
    }

    /** Threads of the caller's executor are not interrupted when their task has ended. */
    @Rule(
        intent = "A thread of an executor belongs to its owner: after a task it is as it was before.",
        look = "If a failed rendering interrupts its workers, clear the status of each when its work has ended.",
    )
    public fun rule_7_9_threadsOfAnExecutorAreNotLeftInterrupted() {
        leavesNoInterrupt(renderer())
    }

    /** Threads of one rendering that work on the same sample, or query at the same time, lose nothing. */
    @Rule(
        intent = "Any number of threads gives the same bits, however their work is interleaved.",
        look = "Look for keys that are read, compared and written without a lock, and for rows, spans and fragments " +
            "that threads share.",
        isSpecial = true, tries = 2,
    )
    public fun rule_7_5_concurrentThreadsLoseNoFragments(@ForAll salt: Long) {
        val renderer = renderer()
        for (kind in KindOfWork.entries) {
            if (!kind.isFor(renderer)) continue
            val configured = renderer.configured(kind.options(threads = 4))
            for (where in Where.entries) {
                whileTheyMeet(where) { meeting, round ->
                    val crowd = Crowd(salt + round, where, meeting, kind)
                    rightInACrowd(configured, crowd.quiet(), crowd.frame)
                }
            }
        }
    }

    /** Threads of one rendering that count at the same time count everything. */
    @Rule(
        intent = "Counters are exact, however many threads count.",
        look = "Give each thread its own counters and add them up at the end; an increment is a read and a write.",
        about = [Symptom.COUNTERS],
        isSpecial = true, tries = 1,
    )
    public fun rule_8_1_concurrentThreadsLoseNoCounts(@ForAll salt: Long) {
        for (where in Where.entries) {
            whileTheyMeet(where) { meeting, round ->
                val crowd = Crowd(salt + round, where, meeting)
                countsInACrowd(renderer(), crowd.quiet(), crowd)
            }
        }
        if (Capability.PARALLEL in renderer().capabilities) countsEachTileOnce(renderer())
    }

    private companion object {
        val FOUR_THREADS = RenderOptions(threads = 4, tileSize = 8)
    }
}
