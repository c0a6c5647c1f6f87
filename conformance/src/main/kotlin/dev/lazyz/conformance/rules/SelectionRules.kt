package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.watched
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.ThousandLayersCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.oracle.Selection
import dev.lazyz.conformance.probes.CellWitness
import dev.lazyz.conformance.probes.ShadingWitness
import java.util.Random
import net.jqwik.api.ForAll

/** Rules about selectors. They apply only to renderers that declare `SELECTION`. Part of `RendererConformance`. */
public sealed interface SelectionRules : RulesForOne {
    /** A selector chooses among all fragments of a sample that pass against the background, nearest first. */
    @Rule(
        intent =
        "A renderer with SELECTION shows what the caller's selector chooses among all fragments of a sample; " +
            "without a selector it shows the usual picture.",
        look = "A cell has every fragment that passes against the background, in the order of the depth test.",
        tries = 40,
    )
    public fun rule_7_5_selectorsChooseAmongAllFragments(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer(Capability.SELECTION)
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        val part = (if (isBlending) case.glazed(salt.toInt()) else case).withinAny(Random(salt))
        for ((name, selection) in Selection.all) {
            val options = RenderOptions(threads = 2, tileSize = 8, selector = selection.selector)
            val configured = renderer.configured(options)
            for (shown in listOf(case, part)) {
                Judgement(configured, shown, "selector $name").equalsPicture(selection.of(shown.frame))
            }
            val usual = configured.configured(RenderOptions(threads = 2, tileSize = 8))
            Judgement(usual, case, "no selector after selector $name").equalsReference()
        }
    }

    /**
     * A selector is called once for each sample with a fragment, and for no other sample. The colours that it asks for
     * are shading calls.
     */
    @Rule(
        intent = "A selector may count, and may rely on a first fragment: it is called once for each sample that has " +
            "one.",
        look = "Do not call the selector for samples without fragments, outside the region, or to try a choice.",
        tries = 20,
    )
    public fun rule_7_5_selectorsAreCalledOncePerSample(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val renderer = renderer(Capability.SELECTION)
        val part = case.withinAny(Random(salt))
        val expected = Recording.of(ReferenceRenderer(), part.frame).image
        for (threads in 1..2) {
            val witness = CellWitness(part.frame.region)
            val shading = ShadingWitness(part.frame)
            val configured = renderer.configured(RenderOptions(threads = threads, tileSize = 8, selector = witness))
            val judgement = Judgement(configured, part.watched(shading.frame), "a selector, threads = $threads")
                .equalsPicture(expected)
            witness.complaint(expected)?.let { judgement.fail(it) }
            val counted = judgement.rendering.counters.shadingCalls
            val made = shading.count
            if (counted != made) judgement.fail("$made colours are computed, but $counted are counted")
        }
    }

    /** A selector chooses among a thousand fragments as among a few. */
    @Rule(
        intent = "A sample has any number of fragments, and a selector can use all of them.",
        look = "Look for a limit on the fragments of a cell, and for counts of them in a byte.",
        isSpecial = true, tries = 2,
    )
    public fun rule_7_5_selectorsChooseAmongAThousandFragments(
        @ForAll(supplier = ThousandLayersCases::class) case: FrameCase,
    ) {
        val renderer = renderer(Capability.SELECTION)
        for ((name, selection) in Selection.all) {
            val configured = renderer.configured(RenderOptions(selector = selection.selector))
            Judgement(configured, case, "selector $name").equalsPicture(selection.of(case.frame))
        }
    }
}
