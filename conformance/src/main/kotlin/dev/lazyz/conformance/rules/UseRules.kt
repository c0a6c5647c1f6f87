package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.halves
import dev.lazyz.conformance.cases.changed.within
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.SeveralCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.OutsideWitness
import dev.lazyz.conformance.probes.Planted
import dev.lazyz.conformance.probes.Question
import dev.lazyz.conformance.probes.Trap
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.changed
import dev.lazyz.conformance.probes.failsAsPlanned
import dev.lazyz.conformance.probes.failsWithItsSelector
import dev.lazyz.conformance.probes.fromAllSides
import dev.lazyz.conformance.probes.leavesNothingBehind
import dev.lazyz.conformance.probes.memory.keepsNothing
import dev.lazyz.conformance.probes.memory.leavesNoObjects
import dev.lazyz.conformance.probes.memory.leavesNoSizes
import dev.lazyz.conformance.probes.tallMeshes
import dev.lazyz.conformance.probes.threads.atOnce
import dev.lazyz.conformance.probes.threads.endsInterrupted
import dev.lazyz.conformance.probes.threads.endsSoon
import dev.lazyz.strategies.lists.ListsRenderer
import java.util.Random
import net.jqwik.api.ForAll

/**
 * Rules about how a renderer is used: again, by several threads, interrupted, by callers that fail. Part of
 * `RendererConformance`.
 */
public sealed interface UseRules : RulesForOne {
    /** A renderer that renders a frame again, after other frames or another part of it, gives the same bits. */
    @Rule(
        intent = "A renderer has no memory of earlier calls: the same frame always gives the same bits.",
        look = "Look for buffers that the renderer keeps without clearing them, or that are too small for this frame.",
        about = [Symptom.AGAIN], tries = 50,
    )
    public fun rule_7_1_repeatedRenderingsAreIdentical(@ForAll(supplier = SeveralCases::class) cases: List<FrameCase>) {
        val renderer = renderer()

        // Parts first: what is kept of a whole frame can serve its parts, but not what is kept of another part
        val frames = cases.flatMap { it.halves() } + cases

        // What is wrong without any frame before it is not a matter of memory
        for (case in frames) Judgement(renderer(), case).equalsReference()
        for (case in frames + frames) Judgement(renderer, case).equalsReference().equalsItsImage()
    }

    /**
     * A renderer that renders frames of many sizes one after the other, by two threads, renders each correctly, and so
     * it does with the same meshes from other sides.
     */
    @Rule(
        intent = "What a renderer keeps for its next frame, such as arrays, has no effect on the picture.",
        look = "Look for arrays that go back to a pool twice, or while they are still in use, for old contents, and " +
            "for what is kept of a mesh by some of its arrays, or depends on the camera.",
        about = [Symptom.AGAIN], tries = 3,
    )
    public fun rule_7_1_framesOfManySizesAreIndependent(@ForAll salt: Long) {
        val options = RenderOptions(threads = 2)
        val renderer = renderer().configured(options)
        for (case in tallMeshes(salt) + fromAllSides(salt)) Judgement(renderer, case, "$options").equalsReference()
    }

    /** Frames on which rules have failed before, and the user's own frames, are correct. */
    @Rule(
        intent = "Past failures stay fixed, and the user's own frames and meshes are rendered as correctly as the " +
            "suite's.",
        look = "The message names the file: find out how that frame differs from the suite's frames.",
    )
    public fun rule_7_1_userFramesAreDrawnCorrectly() {
        for (case in TryUnderWay.current?.ownCases.orEmpty() + frames()) framesAreRight(renderer(), case)
    }

    /** A renderer that several threads use at once, each for another frame, gives the same bits. */
    @Rule(
        intent = "Several threads may use a renderer at once, each with its own frame.",
        look = "Look for fields of the renderer that a rendering writes; keep such state local to the call.",
        tries = 25,
    )
    public fun rule_7_1_renderingsFromSeveralThreadsAreIdentical(
        @ForAll(supplier = SeveralCases::class) cases: List<FrameCase>,
    ) {
        val renderer = renderer()
        atOnce(cases) { case -> repeat(3) { Judgement(renderer, case).equalsReference() } }
    }

    /** A rendered frame and its sink can be garbage collected while the renderer is still in use. */
    @Rule(
        intent = "A renderer keeps nothing between calls, so that the memory of a released frame can be reclaimed.",
        look = "Look for fields, caches and thread locals that hold the last frame, its primitives or its sink.",
    )
    public fun rule_7_1_nothingIsKeptBetweenCalls() {
        keepsNothing(renderer())
    }

    /** An exception thrown by a primitive reaches the caller unchanged, and does not affect later renderings. */
    @Rule(
        intent = "A failure of the caller's code reaches the caller unchanged, and leaves no trace in the renderer.",
        look = "Look for catch blocks, for threads whose failures are never checked, and for state after a failure.",
        tries = 60,
    )
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
        if (Capability.SELECTION in renderer.capabilities) {
            failsWithItsSelector(renderer, case, random.nextInt(MOST_CALLS), Planted.EXCEPTION.make())
        }
        Judgement(renderer, case).equalsReference()
    }

    /** An interrupted thread soon gets the whole picture or an InterruptedException. */
    @Rule(
        intent = "Interrupting the calling thread causes neither a hang nor a wrong picture.",
        look = "Look for waits that are repeated after an interrupt, and for rows that are delivered half finished.",
        tries = 10,
    )
    public fun rule_7_1_interruptedThreadsEnd(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        endsInterrupted(renderer, case)
        Judgement(renderer, case).equalsReference()
    }

    /** A thread that is interrupted while it draws very many triangles soon ends, or draws all of them. */
    @Rule(
        intent = "An interrupt ends a long rendering: an InterruptedException after most of the work is no use.",
        look = "Look for loops over triangles, samples or nodes that do not check whether the thread is interrupted.",
        isSpecial = true,
    )
    public fun rule_7_1_interruptedRenderingsEndSoon() {
        endsSoon(renderer())
    }

    /** An exception thrown by the sink reaches the caller unchanged, and the sink gets no further row. */
    @Rule(
        intent = "A sink may stop the rendering by throwing: the exception is not swallowed, and no row follows.",
        look = "Call the sink outside of try blocks, on the calling thread, and end all threads before you rethrow.",
        tries = 50,
    )
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
            renderer.inTime(case.frame) { _, _, _, _ -> if (rows++ >= last) throw planted }
        }
        val judgement = Judgement(renderer, case)
        changed(planted, answer)?.let { judgement.fail("the sink throws $it", answer) }
        if (rows != last + 1) judgement.fail("the sink threw at call number ${last + 1}, but was called $rows times")
        judgement.equalsReference()
    }

    /** Rows are delivered from top to bottom, each once. */
    @Rule(
        intent = "Sinks write files and feed encoders, so each row is delivered once, from the top.",
        look = "Look at the order in which blocks, tiles or threads finish, and at the last rows, which do not fill " +
            "a block.",
        about = [Symptom.ROWS], tries = 50,
    )
    public fun rule_7_3_rowsArriveInOrderEachOnce(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case).rowsInOrder()
    }

    /** A primitive wholly outside the region is asked for its bounds, and for nothing else. */
    @Rule(
        level = Level.SHOULD,
        intent = "The cost of rendering a region depends on what is in the region, not on what is outside.",
        look = "Compare a primitive's bounds with the region before you ask it for spans, a cursor or a depth.",
        tries = 50,
    )
    public fun rule_7_7_primitivesOutsideTheRegionAreNotQueried(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        val part = case.withinAny(Random(salt))
        val witness = OutsideWitness(part.frame)
        renderer.inTime(witness.frame) { _, _, _, _ -> }
        val asked = witness.asked ?: return
        val judgement = Judgement(renderer, part)
        judgement.fail("primitive $asked lies outside the region, but is queried for more than its bounds")
    }

    private companion object {
        /** Exclusive limit of the number of calls that a primitive answers before it throws. */
        const val MOST_CALLS = 20
    }
}

/** Fails unless [renderer] renders [own] and its inner part correctly, both row by row and into memory. */
internal fun framesAreRight(renderer: Renderer, own: FrameCase) {
    val case = if (Capability.TRANSPARENCY in renderer.capabilities) own else own.opaque()
    for (part in listOf(case, case.within(inner(case.frame)))) {
        Judgement(renderer, part).equalsPictureOf(oracle(part.frame)).equalsItsImage().rowsInOrder()
    }
}

private fun FrameCase.opaque(): FrameCase = if (frame.hasTranslucency) asOpaque() else this

/** Returns the region without a quarter on each side, but at least one sample. */
private fun inner(frame: Frame): Region = with(frame.region) {
    val column = columnStart + width / 4
    val row = rowStart + height / 4
    Region(column, row, column + (width + 1) / 2, row + (height + 1) / 2)
}

/** Returns the reference renderer or, if that would take minutes, a renderer that is tested against it. */
private fun oracle(frame: Frame): Renderer =
    if (frame.region.size * frame.primitives.size <= MOST_FRAGMENTS) ReferenceRenderer() else ListsRenderer()

private const val MOST_FRAGMENTS = 20_000_000L

/** Rules about side effects of a rendering. Part of `RendererConformance`. */
public sealed interface TidyRules : RulesForOne {
    /** A rendering leaves no output, no thread, no file and no changed global state. */
    @Rule(
        intent = "A library runs in its caller's process, and leaves nothing behind there.",
        look = "Look for print statements, executors that are never shut down, temporary files and global settings.",
    )
    public fun rule_7_9_renderingsLeaveNothingBehind() {
        leavesNothingBehind { renderer() }
        for (options in VARIED) leavesNothingBehind { renderer().let { it.configured(options.supportedBy(it)) } }
    }

    /** However often a renderer renders, and pictures of however many sizes, it holds no more memory. */
    @Rule(
        intent = "A renderer may be used a million times in a process, so not even a few bytes may remain each time.",
        look = "Look for static collections, listeners, shutdown hooks and caches to which each rendering adds, " +
            "and for pools of arrays by their length.",
    )
    public fun rule_7_9_renderingsHoldNoMoreMemory() {
        val renderer = renderer()
        for (options in VARIED) leavesNoObjects(renderer, options.supportedBy(renderer))
        leavesNoSizes(renderer, VARIED.first().supportedBy(renderer))
    }

    private companion object {
        /** With several threads; and without any memory budget, where renderers take other code paths. */
        val VARIED = listOf(
            RenderOptions(threads = 2, tileSize = 8),
            RenderOptions(Coherence.ADAPTIVE, 0L, threads = 2, tileSize = 8),
        )
    }
}
