package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.halfHeavyAndDark
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.judgement.requireDeclared
import dev.lazyz.conformance.judgement.withoutMemory
import dev.lazyz.conformance.oracle.Selection
import dev.lazyz.conformance.probes.OneByOne
import dev.lazyz.conformance.probes.RowWitness
import dev.lazyz.conformance.probes.answer
import dev.lazyz.conformance.probes.memory.budgetOnTheHeap
import dev.lazyz.conformance.probes.memory.constantMemory
import dev.lazyz.conformance.probes.memory.constantMemoryInPrimitives
import dev.lazyz.conformance.probes.threads.KindOfWork
import dev.lazyz.conformance.probes.threads.notTooManyThreads
import dev.lazyz.conformance.probes.threads.severalThreads
import dev.lazyz.conformance.probes.varied
import dev.lazyz.conformance.probes.variedFor
import java.util.Random
import net.jqwik.api.ForAll

/**
 * Rules about [Capability]s. They apply only to renderers that declare the capability. Part of `RendererConformance`.
 */
public sealed interface PromiseRules : RulesForOne {
    /** Working memory is the same for few and for many rows, according to the counters and to the heap. */
    @Rule(
        intent = "A renderer with CONSTANT_MEMORY can render pictures larger than memory.",
        look = "Look for arrays sized by the height of the region, and for rows that are kept after they are " +
            "delivered.",
    )
    public fun rule_7_3_promiseOfConstantMemoryIsKept() {
        val renderer = renderer(Capability.CONSTANT_MEMORY)
        constantMemory(renderer)
    }

    /** When a row is delivered, no primitive has been queried about a lower row. */
    @Rule(
        intent = "A renderer with STREAMS_ROWS delivers a row before it starts later rows, so that the first one " +
            "arrives soon.",
        look = "Deliver a row as soon as it is finished; query a primitive's spans for a row when that row is " +
            "rendered.",
    )
    public fun rule_7_3_promiseToStreamRowsIsKept(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val random = Random(salt)
        val renderer = renderer().varied(random)
        requireDeclared(renderer, Capability.STREAMS_ROWS)
        val varied = case.variedFor(renderer, random)
        val witness = RowWitness(varied.frame)
        var early: String? = null
        renderer.inTime(witness.frame) { y, _, _, _ ->
            if (witness.last > y) early = early ?: "row $y is delivered after queries about row ${witness.last}"
        }
        early?.let { Judgement(renderer, varied).fail(it) }
    }

    /** Stopping after some rows avoids the cost of the rows below. */
    @Rule(
        intent = "A renderer with STREAMS_ROWS does the work of the rows that the sink accepts, and no more.",
        look = "When the sink throws, rethrow at once: do not finish, start or fetch a row in a finally block.",
        tries = 50,
    )
    public fun rule_7_3_rowsAfterTheSinkStopsAreNotRendered(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val random = Random(salt)
        val renderer = renderer().varied(random)
        requireDeclared(renderer, Capability.STREAMS_ROWS)
        val varied = case.variedFor(renderer, random)
        val witness = RowWitness(varied.frame)
        val last = varied.frame.region.rowStart + random.nextInt(varied.frame.height)
        answer { renderer.inTime(witness.frame) { y, _, _, _ -> check(y < last) { "enough" } } }
        if (witness.last <= last) return
        val what = "the sink stops at row $last, a primitive is queried about row ${witness.last}"
        Judgement(renderer, varied).fail(what)
    }

    /** Options are refused if the renderer lacks the capability that they need. */
    @Rule(
        intent = "An option is supported or refused, never ignored, because its user relies on it.",
        look = "Call RenderOptions.requireSupportedBy in configured(); do not override it if there is nothing to " +
            "configure.",
    )
    public fun rule_7_5_optionsThatAreNotSupportedAreRefused() {
        val usual = RenderOptions()
        val options = Coherence.entries.map { usual.withCoherence(it) } +
            listOf(usual, usual.withMemoryBudget(0L), usual.withMemoryBudget(Long.MAX_VALUE)) +
            Selection.all.values.map { usual.withSelector(it.selector) }
        for (option in options) {
            val renderer = renderer()
            val missing = option.needs - renderer.capabilities
            val thrown = answer { renderer.configured(option) }
            if (missing.isEmpty() && thrown != null) fail(renderer, "it throws $thrown for $option")
            if (missing.isNotEmpty() && thrown !is IllegalArgumentException) {
                fail(renderer, "it does not declare $missing, and answers $option with ${thrown ?: "no exception"}")
            }
        }
    }

    /** Several threads work on a picture that is large enough. */
    @Rule(
        intent = "A renderer with PARALLEL uses the threads that it is given, and never more of them at the same time.",
        look = "Several threads must query primitives or shade; count those that work, including the caller.",
    )
    public fun rule_7_5_promiseToWorkInParallelIsKept() {
        val renderer = renderer(Capability.PARALLEL)
        for (kind in KindOfWork.entries) {
            if (!kind.isFor(renderer)) continue
            severalThreads(renderer, kind)
            notTooManyThreads(renderer, kind)
        }
    }

    /** Counters are the same for any number of threads, except peak memory. */
    @Rule(
        intent = "A renderer with PARALLEL does the same work with any number of threads, so counters are comparable.",
        look = "Look for work that depends on which thread comes first, and for counters that threads share.",
        tries = 25,
    )
    public fun rule_8_1_countersDoNotDependOnThreads(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer(Capability.PARALLEL)
        val varied = case.variedFor(renderer, Random(salt))
        val judgements = listOf(1, 2, 5).map { threads ->
            val options = RenderOptions(Coherence.INCREMENTAL, threads = threads, tileSize = 8).supportedBy(renderer)
            Judgement(renderer.configured(options), varied, "$options").equalsReference()
        }
        val counters = judgements.map { it.rendering.counters.withoutMemory() }
        for (i in 1 until counters.size) {
            if (counters[i] == counters[0]) continue
            judgements[i].fail("one thread counts ${counters[0]}, but several count ${counters[i]}")
        }
    }

    /** Suspended shading takes no more memory than the budget allows, and every budget gives the same picture. */
    @Rule(
        intent = "A renderer with MEMORY_BUDGET holds no more than the budget, in addition to the image's memory.",
        look = "Free before you allocate, count memory before you hold it, and do without it where nothing fits.",
        tries = 60,
    )
    public fun rule_8_1_promiseToStayWithinTheBudgetIsKept(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll choice: Int,
    ) {
        val renderer = renderer(Capability.MEMORY_BUDGET)
        val coherence = Coherence.entries[Math.floorMod(choice, Coherence.entries.size)]
        var least = Long.MAX_VALUE
        for (budget in listOf(0L, 100L, 400L, 700L, 1000L, 1500L, 10_000L, Long.MAX_VALUE)) {
            val options = RenderOptions(coherence, budget, threads = 1).supportedBy(renderer)
            val configured = renderer.configured(options)
            val how = "a budget of $budget, ${options.coherence}"
            val judgement = Judgement(configured, case, how).equalsReference()

            // Of primitives that come one by one, those that hold more than the budget are shaded at once
            if (configured is StreamingRenderer) {
                val heavy = case.halfHeavyAndDark()
                Judgement(OneByOne(configured), heavy, "$how, primitives one by one").equalsReference()
            }

            // The image's memory is at most what a frame without primitives takes, and at most what is held with any
            // budget
            val empty = Recording.of(configured, Frame(case.frame.raster, emptyList(), case.frame.region))
            least = minOf(least, empty.counters.peakBytes, judgement.rendering.counters.peakBytes)
            val held = judgement.rendering.counters.peakBytes - least
            if (held > budget) judgement.fail("$held bytes are held in addition to the image's, at most $least")
            requireAtMost(judgement, budget)
        }
    }

    /** Fails if more is held than the image, the [budget] and some rows take. */
    private fun requireAtMost(judgement: Judgement, budget: Long) {
        val image = judgement.rendering.image
        val most = IMAGE_BYTES * image.width * (image.height + SOME_ROWS) + FEW_BYTES
        val held = judgement.rendering.counters.peakBytes
        if (held - most <= budget) return
        judgement.fail("$held bytes are held; the image and some rows take at most $most")
    }

    /** The memory that remains after garbage collection is within the budget, too. */
    @Rule(
        intent = "A renderer with MEMORY_BUDGET keeps to the budget on the heap, not only according to its counters.",
        look = "Look for memory that is held but not counted: objects, lists of suspended colours, arrays that only " +
            "grow.",
    )
    public fun rule_8_1_heapStaysWithinTheBudget() {
        val renderer = renderer(Capability.MEMORY_BUDGET)
        budgetOnTheHeap(renderer)
    }

    /** Hidden primitives take no memory, however many there are. */
    @Rule(
        intent = "A renderer with STREAMS_PRIMITIVES does not store primitives: memory does not grow with their " +
            "number.",
        look = "Look for lists, bins or arrays of all primitives, and for records of hidden ones.",
    )
    public fun rule_8_1_promiseToStreamPrimitivesIsKept() {
        val renderer = renderer(Capability.STREAMS_PRIMITIVES)
        constantMemoryInPrimitives(renderer)
    }

    private companion object {
        /** Bytes that an image takes for a sample, see rule 7.6. */
        const val IMAGE_BYTES = 12L

        /** How many rows a renderer may hold besides, whatever the budget, and how many bytes for what is small. */
        const val SOME_ROWS = 8
        const val FEW_BYTES = 2048
    }
}
