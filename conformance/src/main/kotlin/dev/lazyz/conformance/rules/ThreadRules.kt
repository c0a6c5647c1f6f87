package dev.lazyz.conformance.rules

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.cases.changed.watched
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.SeveralCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.OneByOne
import dev.lazyz.conformance.probes.OverwritingSink
import dev.lazyz.conformance.probes.RenderingSink
import dev.lazyz.conformance.probes.ThreadWitness
import dev.lazyz.conformance.probes.threads.Crowd
import dev.lazyz.conformance.probes.threads.Interruption
import dev.lazyz.conformance.probes.threads.KindOfWork
import dev.lazyz.conformance.probes.threads.Meeting
import dev.lazyz.conformance.probes.threads.Where
import dev.lazyz.conformance.probes.threads.atOnce
import dev.lazyz.conformance.probes.threads.meshesAreIndependent
import dev.lazyz.conformance.probes.threads.reportsInterrupt
import dev.lazyz.conformance.probes.threads.rightInACrowd
import dev.lazyz.conformance.probes.threads.waitsForNoOther
import dev.lazyz.conformance.probes.ways
import java.util.Random
import net.jqwik.api.ForAll

/** Rules about threads, and about what the sink can rely on. Part of `RendererConformance`. */
public sealed interface ThreadRules : RulesForOne {
    /**
     * Renderings in several threads that query spans and colours at the same time, or draw meshes, do not disturb each
     * other, nor does one wait for another.
     */
    @Rule(
        intent = "Several threads may use a renderer at once, at any moment of their renderings.",
        look =
        "Look for fragments, spans and rows in fields of the renderer, for state shared by all renderings, and " +
            "for long work under a lock.",
        tries = 4,
    )
    public fun rule_7_1_concurrentRenderingsAreIndependent(@ForAll salt: Long) {
        val renderer = renderer()
        val ways = listOfNotNull(renderer, (renderer as? StreamingRenderer)?.let { OneByOne(it) })
        for (way in ways) {
            independent(way, KindOfWork.OPAQUE, salt)
            if (KindOfWork.TRANSLUCENT.isFor(renderer)) independent(way, KindOfWork.TRANSLUCENT, salt)
        }
        val selected = KindOfWork.SELECTED
        if (selected.isFor(renderer)) independent(renderer.configured(selected.options(threads = 1)), selected, salt)
        meshesAreIndependent(renderer, salt)
        waitsForNoOther(renderer, salt)
    }

    private fun independent(way: Renderer, kind: KindOfWork, salt: Long) {
        val meeting = Meeting(Where.ANY_SAMPLE)
        val crowds = List(2) { Crowd(salt + it, Where.ANY_SAMPLE, meeting, kind) }
        atOnce(crowds) { crowd -> rightInACrowd(way, crowd.quiet(), crowd.frame) }
    }

    /** The sink is called on the thread that called the renderer, and never by two calls at the same time. */
    @Rule(
        intent = "A sink needs no locks: it is called on the caller's thread, one row at a time.",
        look = "Deliver rows on the thread that called render; other threads pass their finished rows to that thread.",
        tries = 20,
    )
    public fun rule_7_8_sinkIsCalledOnTheCallersThread(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer().configured(FOUR_THREADS)
        val sink = ThreadWitness()
        renderer.inTime(case.frame, sink)
        sink.complaint?.let { Judgement(renderer, case).fail(it) }
    }

    /** A row does not change while the sink uses it, and what the sink writes into it does not affect later rows. */
    @Rule(
        intent = "During the call the row belongs to the sink: the renderer must not write to it, but the sink may.",
        look = "Overwrite every element of each row, or keep what later rows need in separate arrays.",
        tries = 30,
    )
    public fun rule_7_8_sinkMayOverwriteItsRows(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        val sink = OverwritingSink(case.frame)
        val counters = renderer.inTime(case.frame, sink)
        sink.complaint?.let { Judgement(renderer, case).fail(it) }
        val expected = Recording.of(ReferenceRenderer(), case.frame).image
        val difference = difference(expected, sink.image(counters)) ?: return
        Judgement(renderer, case, "a sink that overwrites its rows").fail("", difference)
    }

    /** What the sink writes into its rows does not affect later ones, even if there is nothing to draw in them. */
    @Rule(
        intent = "A row without primitives has the background, whatever the sink wrote into an earlier row.",
        look = "Look for tiles, bands or rows that are not filled again because they are said to be empty already.",
    )
    public fun rule_7_8_sinkMayOverwriteEmptyRows() {
        for (renderer in listOf(renderer(), renderer().configured(FOUR_THREADS))) {
            for (rows in listOf(0..<0, 300..<500)) {
                val stripe = listOf(Stripe(3..7, rows, 1000)).filter { !rows.isEmpty() }
                val frame = Frame(Raster(EMPTY_COLUMNS, EMPTY_ROWS), stripe)
                val sink = OverwritingSink(frame)
                val counters = renderer.inTime(frame, sink)
                val difference = difference(ReferenceRenderer().render(frame), sink.image(counters)) ?: continue
                fail(renderer, "a sink overwrites its rows, of which only $rows are not empty: $difference")
            }
        }
    }

    /** A sink may render other frames with the same renderer, and its row does not change meanwhile. */
    @Rule(
        intent = "A sink may render: renderings of one thread can be nested, and do not disturb each other.",
        look = "Look for row arrays, buffers or locks that all renderings of a thread share, as in a ThreadLocal.",
        about = [Symptom.AGAIN], tries = 20,
    )
    public fun rule_7_8_sinkMayRender(@ForAll(supplier = SeveralCases::class) cases: List<FrameCase>) {
        val usual = renderer()
        val (outer, other) = cases

        // Buffers may belong to a size, so one of the other frames has the same
        val ofSameSize = outer.watched(outer.frame.keeping { it % 2 == 1 })
        for (renderer in usual.ways() + usual.configured(FOUR_THREADS)) {
            for (inner in listOf(other, ofSameSize)) {
                val sink = RenderingSink(outer.frame) { Judgement(renderer, inner).equalsReference() }
                val counters = renderer.inTime(outer.frame, sink)
                val expected = Recording.of(ReferenceRenderer(), outer.frame).image
                val difference = difference(expected, sink.image(counters)) ?: continue
                Judgement(renderer, outer, "a sink that renders").fail("", difference)
            }
        }
    }

    /**
     * After an interrupt, the caller gets the picture with the interrupt status set, or an exception with it cleared.
     */
    @Rule(
        intent = "An interrupt is never lost: the caller sees it in the interrupt status or as an exception.",
        look = "Where you catch InterruptedException or call Thread.interrupted(), rethrow it or set the status again.",
        tries = 15,
    )
    public fun rule_7_8_interruptIsNotLost(@ForAll(supplier = MixedCases::class) case: FrameCase, @ForAll salt: Long) {
        for (renderer in listOf(renderer(), renderer().configured(SMALL_TILES))) {
            for (moment in Interruption.entries) {
                if (moment.isFor(renderer)) reportsInterrupt(renderer, case, moment, Random(salt))
            }
        }
    }

    private companion object {
        /** Several tiles, and more bands of them than a renderer has in work at a time. */
        const val EMPTY_COLUMNS = 70
        const val EMPTY_ROWS = 1100

        val FOUR_THREADS = RenderOptions(threads = 4, tileSize = 8)
        val SMALL_TILES = RenderOptions(threads = 1, tileSize = 8)
    }
}
