package dev.lazyz.conformance

import dev.lazyz.RenderOptions
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.Property

/** Rules about threads of the renderer's own, and what becomes of their work. Part of [RendererConformance]. */
@Suppress("ktlint:standard:function-naming")
public sealed class WorkerRules : ThreadRules() {
    /** What a primitive throws in a thread of the renderer's own reaches the caller: exceptions and errors. */
    @Rule(
        intent = "A failure is the caller's to see, whichever thread ran into it, errors included.",
        look = "Catch Throwable in each thread, pass the first on in the caller's, and draw nothing that is half done.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_failuresOfItsThreadsReachTheCaller() {
        passesOnFailuresOfWorkers(renderer().configured(FOUR_THREADS))
    }

    /** A caller that is interrupted while the renderer's own threads are at work gets no half of a picture. */
    @Rule(
        intent = "Who is interrupted while it waits for its threads waits on, or throws: half a picture is none.",
        look = "Look at each join, get, await and acquire: after InterruptedException the others' work is not done.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_interruptedCallersGetNoHalfPicture() {
        val renderer = renderer().configured(FOUR_THREADS)
        for (isBefore in listOf(true, false)) heedsWorkersThoughInterrupted(renderer, isBefore)
    }

    private companion object {
        val FOUR_THREADS = RenderOptions(threads = 4, tileSize = 8)
    }
}
