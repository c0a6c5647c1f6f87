package dev.lazyz.conformance.rules

import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Rendering
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.OverwritingSink
import dev.lazyz.conformance.probes.ThreadWitness
import dev.lazyz.conformance.probes.threads.Crowd
import dev.lazyz.conformance.probes.threads.Interruption
import dev.lazyz.conformance.probes.threads.Meeting
import dev.lazyz.conformance.probes.threads.Where
import dev.lazyz.conformance.probes.threads.atOnce
import dev.lazyz.conformance.probes.threads.rightInACrowd
import dev.lazyz.conformance.probes.threads.tellsOfInterrupt
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about threads, and what the sink may rely on. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface ThreadRules : RulesForOne {
    /** Renderings of several threads that ask for spans and colours at the same time do not disturb each other. */
    @Rule(
        intent = "A renderer may be used by several threads at once, at any moment of their renderings.",
        look = "Look for fragments, spans and rows in fields of the renderer, or where all renderings share them.",
    )
    @Property(tries = 4, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_renderingsThatMeetDoNotDisturbEachOther(@ForAll salt: Long) {
        val renderer = renderer()
        val meeting = Meeting(Where.ANY_SAMPLE)
        atOnce(List(2) { Crowd.quiet(salt + it, Where.ANY_SAMPLE) }.withIndex().toList()) { (number, quiet) ->
            rightInACrowd(renderer, quiet, Crowd(salt + number, Where.ANY_SAMPLE, meeting))
        }
    }

    /** The sink is called on the thread that called the renderer, and never while it is at work. */
    @Rule(
        intent = "A sink needs no locks: it is called on the caller's thread, one row at a time.",
        look = "Hand rows out where render was called; other threads leave finished rows to that one.",
    )
    @Property(tries = 20, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_8_sinkIsCalledOnTheCallersThread(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer().configured(FOUR_THREADS)
        val sink = ThreadWitness()
        renderer.render(case.frame, sink)
        sink.complaint?.let { Judgement(renderer, case).fail(it) }
    }

    /** Rows hold still while the sink has them, and what it writes into them changes nothing in later rows. */
    @Rule(
        intent = "A row is the sink's during the call: nobody else writes there, and the sink may.",
        look = "Fill every element of a row anew, or keep what later rows build on in arrays of your own.",
    )
    @Property(tries = 30, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_8_sinkMayOverwriteItsRows(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val sink = OverwritingSink(case.frame)
        val counters = renderer.render(case.frame, sink)
        sink.complaint?.let { Judgement(renderer, case).fail(it) }
        val expected = Rendering.of(ReferenceRenderer(), case.frame).image
        val difference = difference(expected, sink.image(counters)) ?: return
        Judgement(renderer, case, "a sink that overwrites its rows").fail("", difference)
    }

    /** Who is interrupted gets the picture with the interrupt status still set, or an exception with it cleared. */
    @Rule(
        intent = "An interrupt is never lost: the caller learns of it by the status or by the exception.",
        look = "Where InterruptedException is caught or Thread.interrupted() called: throw it on, or set the status.",
    )
    @Property(tries = 15, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_8_interruptIsNotLost(@ForAll(supplier = MixedCases::class) case: FrameCase, @ForAll salt: Long) {
        val renderer = renderer()
        for (moment in Interruption.entries) tellsOfInterrupt(renderer, case, moment, Random(salt))
    }

    private companion object {
        val FOUR_THREADS = RenderOptions(threads = 4, tileSize = 8)
    }
}
