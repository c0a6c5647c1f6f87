package dev.lazyz.conformance.rules

import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.halves
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.SeveralCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.probes.OutsideWitness
import dev.lazyz.conformance.probes.Planted
import dev.lazyz.conformance.probes.Question
import dev.lazyz.conformance.probes.Trap
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.failsAsPlanned
import dev.lazyz.conformance.probes.framesAreRight
import dev.lazyz.conformance.probes.memory.keepsNothing
import dev.lazyz.conformance.probes.threads.atOnce
import dev.lazyz.conformance.probes.threads.endsInterrupted
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about use: again, at once, interrupted, by callers that fail. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface UseRules : RulesForOne {
    /** A renderer that renders a frame again after others, or another part of it, gives the same bits. */
    @Rule(
        intent = "A renderer has no memory: the same frame gives the same bits, whatever came in between.",
        look = "Look for buffers that are kept in the renderer, and are not cleared, or not as large as this frame.",
        about = [Symptom.AGAIN],
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_sameBitsAgain(@ForAll(supplier = SeveralCases::class) cases: List<FrameCase>) {
        val renderer = renderer()
        val parts = cases.flatMap { it.halves() }
        for (case in cases + parts + cases) Judgement(renderer, case).equalsReference().equalsItsImage()
    }

    /** Frames that rules have failed on before, and those of the user's own, are right. */
    @Rule(
        intent = "What was wrong once stays right, and a user's own frames and meshes are as good as the suite's.",
        look = "The message names the file: it says what the frame is like that the suite's own do not have.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_framesOfOnesOwnAreRight() {
        for (case in TryUnderWay.current?.ownCases.orEmpty() + frames()) framesAreRight(renderer(), case)
    }

    /** A renderer that several threads use at once, each for another frame, gives the same bits. */
    @Rule(
        intent = "A renderer may be used from several threads at once, each with a frame of its own.",
        look = "Look for fields of the renderer that a rendering writes: state belongs to the call.",
    )
    @Property(tries = 25, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_sameBitsFromSeveralThreads(@ForAll(supplier = SeveralCases::class) cases: List<FrameCase>) {
        val renderer = renderer()
        atOnce(cases) { case -> repeat(3) { Judgement(renderer, case).equalsReference() } }
    }

    /** A frame that has been rendered, and its sink, can be collected as garbage though the renderer is in use. */
    @Rule(
        intent = "A renderer keeps nothing between calls: who lets go of a frame gets its memory back.",
        look = "Look for fields, caches and thread locals that hold the last frame, its primitives or its sink.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_nothingIsKeptBetweenCalls() {
        keepsNothing(renderer())
    }

    /** What a primitive throws reaches the caller, as it is, and does no harm to later renderings. */
    @Rule(
        intent = "A failure of the caller's code is the caller's to see, as it is, and leaves no trace.",
        look = "Look for catch blocks, for threads whose failures nobody asks for, and for state after a failure.",
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_exceptionsOfPrimitivesReachTheCaller(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val random = Random(salt)
        for (question in Question.entries) {
            val planted = Planted.entries[random.nextInt(Planted.entries.size)].make()
            val trap = Trap(case.frame, question, random.nextInt(MOST_CALLS), planted)
            failsAsPlanned(renderer, case, trap)
        }
        Judgement(renderer, case).equalsReference()
    }

    /** A thread that is interrupted gets the whole picture or an InterruptedException, soon. */
    @Rule(
        intent = "Interrupting the calling thread never hangs and never gives a wrong picture.",
        look = "Look for waiting that is repeated when it is interrupted, and for rows that are handed out half done.",
    )
    @Property(tries = 10, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_1_interruptedThreadsEnd(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        endsInterrupted(renderer, case)
        Judgement(renderer, case).equalsReference()
    }

    /** What the sink throws reaches the caller, as it is, and the sink gets no further row. */
    @Rule(
        intent = "Who takes the rows may stop by throwing: nothing is swallowed, and no row comes after.",
        look = "Call the sink outside of try blocks, on the calling thread, and end all threads before passing it on.",
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_3_exceptionsOfTheSinkReachTheCaller(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val random = Random(salt)
        val planted = Planted.entries[random.nextInt(Planted.entries.size)].make()
        val last = random.nextInt(case.frame.height)
        var rows = 0
        val answer = answer {
            renderer.render(case.frame) { _, _, _, _ -> if (rows++ >= last) throw planted }
        }
        val judgement = Judgement(renderer, case)
        if (answer !== planted) judgement.fail("the sink threw $planted, the caller got $answer", answer)
        if (rows != last + 1) judgement.fail("the sink threw at row number ${last + 1}, and was called $rows times")
        judgement.equalsReference()
    }

    /** Rows arrive from the top to the bottom, each once. */
    @Rule(
        intent = "Sinks write files and feed encoders: each row once, from the top.",
        look = "Look at the order in which blocks, tiles or threads finish, and at the last rows, which fill no block.",
        about = [Symptom.ROWS],
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_3_rowsArriveInOrderEachOnce(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case).rowsInOrder()
    }

    /** What lies wholly outside the region is asked for its bounds, and for nothing else. */
    @Rule(
        level = Level.SHOULD,
        intent = "The picture of a region costs what is in the region: what lies outside is left alone.",
        look = "Compare a primitive's bounds with the region before it is asked for spans, a cursor or a depth.",
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_7_whatIsOutsideTheRegionIsLeftAlone(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val part = case.withinAny(Random(salt))
        val witness = OutsideWitness(part.frame)
        renderer.render(witness.frame) { _, _, _, _ -> }
        val asked = witness.asked ?: return
        val judgement = Judgement(renderer, part)
        judgement.fail("primitive $asked lies outside the region, and is asked for more than its bounds")
    }

    private companion object {
        /** A primitive throws before it has answered as many questions. */
        const val MOST_CALLS = 20
    }
}
