package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.probes.Combination
import dev.lazyz.conformance.probes.Concurrency
import dev.lazyz.conformance.probes.Trap
import dev.lazyz.conformance.probes.failsAsPlanned
import dev.lazyz.conformance.probes.threads.atOnce
import net.jqwik.api.ForAll

/** The rule that combines everything. Part of `RendererConformance`. */
public sealed interface CombinationRules : RulesForOne {
    /** Renders larger frames of all kinds, whole or in parts, with options, glass, selectors, failures and threads. */
    @Rule(
        intent = "Features that work alone work together: regions, options, depth tests, blending, selectors, reuse, " +
            "threads.",
        look = "The message lists all settings that are not the default; the more the frame was reduced, the more " +
            "they matter.",
        isSpecial = true,
    )
    public fun rule_7_5_combinationsAreRight(
        @ForAll(supplier = Combination.Cases::class) cases: List<FrameCase>,
        @ForAll(supplier = Combination.Choices::class) choices: List<Int>,
    ) {
        val combination = Combination(cases, choices)
        val renderer = renderer()
        val options = combination.options.supportedBy(renderer)
        val usual = renderer.configured(options)
        when (combination.turns) {
            Concurrency.ONE_BY_ONE -> combination.steps.forEach { judge(renderer, usual, options, it) }

            Concurrency.AT_ONCE -> {
                val capabilities = renderer.capabilities
                val how = "$options, ${combination.steps.size} frames at once"
                atOnce(combination.steps) {
                    Judgement(it.way(usual), it.caseFor(capabilities), how).equalsReference()
                }
            }
        }
    }

    /** Renders [step] with [usual], which is configured with [options], or with a renderer that also has a selector. */
    private fun judge(renderer: Renderer, usual: Renderer, options: RenderOptions, step: Combination.Step) {
        val case = step.caseFor(renderer.capabilities)
        val selection = step.selectionFor(renderer.capabilities)
        if (selection != null) {
            val chosen = renderer.configured(options.withSelector(selection.selector))
            Judgement(chosen, case, "$options, selector ${step.selection}").equalsPicture(selection.of(case.frame))
            return
        }
        step.failing?.let { failsAsPlanned(usual, case, Trap(case.frame, it, step.answers)) }
        val way = step.way(usual)
        val judgement = try {
            Judgement(way, case, "$options").equalsReference().rowsInOrder()
        } catch (e: Violation) {
            throw explained(e, step.way(renderer().configured(options)), options, case)
        }
        counts(judgement, case, renderer.capabilities, options, isWhole = way === usual)
    }

    /**
     * Returns the violation that [fresh], a new renderer, shows for [case], or, if it is correct, [found] with a
     * message that says that the failure comes from the renderer's earlier use.
     */
    private fun explained(found: Violation, fresh: Renderer, options: RenderOptions, case: FrameCase): Violation {
        try {
            Judgement(fresh, case, "$options").equalsReference().rowsInOrder()
        } catch (e: Violation) {
            return e
        }
        return Violation(
            "wrong only after other frames or a failure, not with a new renderer: ${found.message}",
            case,
            found.expected,
            found.actual,
            found.cause,
        )
    }

    /** Checks the counters. Without the [isWhole] frame a renderer may shade what later primitives hide. */
    private fun counts(
        judgement: Judgement,
        case: FrameCase,
        capabilities: Set<Capability>,
        options: RenderOptions,
        isWhole: Boolean,
    ) {
        val counters = judgement.rendering.counters
        val visible = judgement.rendering.image.visible
        val isExact = Capability.SHADES_ONLY_VISIBLE in capabilities && options.memoryBudget == null &&
            !case.frame.hasTranslucency && isWhole
        val isRight = counters.primitives == case.frame.primitives.size.toLong() &&
            (if (isExact) counters.shadingCalls == visible.toLong() else counters.shadingCalls >= visible)
        if (!isRight) {
            val size = case.frame.primitives.size
            judgement.fail("$size primitives submitted, $visible samples visible, but the counters are $counters")
        }
    }
}
