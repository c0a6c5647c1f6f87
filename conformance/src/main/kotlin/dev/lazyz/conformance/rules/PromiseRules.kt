package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Rendering
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.requireDeclared
import dev.lazyz.conformance.judgement.withoutMemory
import dev.lazyz.conformance.oracle.Selection
import dev.lazyz.conformance.probes.RowWitness
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.memory.budgetOnTheHeap
import dev.lazyz.conformance.probes.memory.constantMemory
import dev.lazyz.conformance.probes.memory.constantMemoryInPrimitives
import dev.lazyz.conformance.probes.threads.notTooManyThreads
import dev.lazyz.conformance.probes.threads.severalThreads
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about [Capability]s: who declares one is held to it, nobody else is. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface PromiseRules : RulesForOne {
    /** Working memory is the same for few and for many rows, by the counters and by the heap. */
    @Rule(
        intent = "Who promises CONSTANT_MEMORY can render pictures larger than memory.",
        look = "Look for arrays by the height of the region, and for rows that are kept after they are handed out.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_3_promiseOfConstantMemoryIsKept() {
        val renderer = renderer()
        requireDeclared(renderer, Capability.CONSTANT_MEMORY)
        constantMemory(renderer)
    }

    /** When a row arrives, no primitive has been asked about a row further down. */
    @Rule(
        intent = "Who promises STREAMS_ROWS hands out a row before later rows are begun, so the first one comes soon.",
        look = "Hand a row out at the end of its turn; ask a primitive for spans when its row has come, not before.",
    )
    @Property(tries = 100, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_3_promiseToStreamRowsIsKept(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.STREAMS_ROWS)
        val witness = RowWitness(case.frame)
        var early: String? = null
        renderer.render(witness.frame) { y, _, _, _ ->
            if (witness.last > y) early = early ?: "row $y arrives after questions about row ${witness.last}"
        }
        early?.let { Judgement(renderer, case).fail(it) }
    }

    /** Whoever stops after some rows has not paid for those below. */
    @Rule(
        intent = "Who promises STREAMS_ROWS does the work of the rows that are taken, and no more.",
        look = "When the sink throws, let it pass at once: no row is finished, begun or fetched in a finally block.",
    )
    @Property(tries = 50, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_3_rowsThatAreNotPulledCostNothing(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Int,
    ) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.STREAMS_ROWS)
        val witness = RowWitness(case.frame)
        val last = Math.floorMod(salt, case.frame.height)
        answer { renderer.render(witness.frame) { y, _, _, _ -> check(y < last) { "enough" } } }
        if (witness.last <= last) return
        Judgement(renderer, case).fail("rows are taken up to $last, a primitive is asked about row ${witness.last}")
    }

    /** A selector chooses among all fragments of a sample that pass against the background, nearest first. */
    @Rule(
        intent =
        "Who promises SELECTION shows what the caller's selector chooses among all fragments of a sample, and the " +
            "usual without one.",
        look = "A cell has every fragment that passes against the background, in the order of the depth test.",
    )
    @Property(tries = 40, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_5_selectorsChooseAmongAllFragments(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.SELECTION)
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        val part = (if (isBlending) case.glazed(salt.toInt()) else case).withinAny(Random(salt))
        for ((name, selection) in Selection.all) {
            val options = RenderOptions(threads = 2, tileSize = 8, selector = selection.selector)
            val configured = renderer.configured(options)
            for (shown in listOf(case, part)) {
                val judgement = Judgement(configured, shown, "selector $name")
                difference(selection.of(shown.frame), judgement.rendering.image)?.let { judgement.fail("", it) }
            }
            val usual = configured.configured(RenderOptions(threads = 2, tileSize = 8))
            Judgement(usual, case, "no selector after selector $name").equalsReference()
        }
    }

    /** Several threads are at work on a picture that is large enough. */
    @Rule(
        intent = "Who promises PARALLEL uses the threads it is given, and no more of them at the same time.",
        look = "Several threads must ask primitives or shade; count those that work, the caller included.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_7_5_promiseToWorkInParallelIsKept() {
        val renderer = renderer()
        requireDeclared(renderer, Capability.PARALLEL)
        severalThreads(renderer)
        notTooManyThreads(renderer)
    }

    /** Counters are the same for any number of threads, but for the peak of memory. */
    @Rule(
        intent = "Who promises PARALLEL does the same work with any number of threads, so counters compare.",
        look = "Look for work that depends on which thread was first, and for counters that threads share.",
    )
    @Property(tries = 25, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_countersDoNotDependOnThreads(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.PARALLEL)
        val judgements = listOf(1, 2, 5).map { threads ->
            val options = RenderOptions(Coherence.INCREMENTAL, threads = threads, tileSize = 8)
            Judgement(renderer.configured(options), case, "$options").equalsReference()
        }
        val counters = judgements.map { it.rendering.counters.withoutMemory() }
        for (i in 1 until counters.size) {
            if (counters[i] == counters[0]) continue
            judgements[i].fail("one thread counts ${counters[0]}, several ${counters[i]}")
        }
    }

    /** Suspensions take no more memory than the budget allows, and any budget gives the same picture. */
    @Rule(
        intent = "Who promises MEMORY_BUDGET keeps to it: working memory besides the image's is within the budget.",
        look = "Free before you allocate, count what is about to be held, and do without where nothing fits.",
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_promiseToKeepToTheBudgetIsKept(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.MEMORY_BUDGET)
        var least = Long.MAX_VALUE
        for (budget in listOf(0L, 100L, 400L, 700L, 1000L, 1500L, 10_000L, Long.MAX_VALUE)) {
            val configured = renderer.configured(RenderOptions(memoryBudget = budget, threads = 1))
            val judgement = Judgement(configured, case, "a budget of $budget").equalsReference()

            // The image is no more than what a frame without primitives takes, nor than what is held without a budget
            val empty = Rendering.of(configured, Frame(case.frame.raster, emptyList(), case.frame.region))
            least = minOf(least, empty.counters.peakBytes, judgement.rendering.counters.peakBytes)
            val held = judgement.rendering.counters.peakBytes - least
            if (held > budget) judgement.fail("$held bytes are held besides the image's, which are at most $least")
        }
    }

    /** What the garbage collector leaves is within the budget, too. */
    @Rule(
        intent = "Who promises MEMORY_BUDGET keeps to it on the heap, not only by its own count.",
        look = "Look for what is held and not counted: objects, lists of suspended colours, arrays that only grow.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_heapKeepsToTheBudget() {
        val renderer = renderer()
        requireDeclared(renderer, Capability.MEMORY_BUDGET)
        budgetOnTheHeap(renderer)
    }

    /** Hidden primitives, however many, take no memory. */
    @Rule(
        intent = "Who promises STREAMS_PRIMITIVES does not keep them: memory does not grow with their number.",
        look = "Look for lists, bins or arrays of all primitives, and for records of those that are hidden.",
    )
    @Property(tries = 1, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_8_1_promiseToStreamPrimitivesIsKept() {
        val renderer = renderer()
        requireDeclared(renderer, Capability.STREAMS_PRIMITIVES)
        constantMemoryInPrimitives(renderer)
    }
}
