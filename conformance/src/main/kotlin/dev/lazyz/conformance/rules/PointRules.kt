package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.frames.BlendedPointCases
import dev.lazyz.conformance.frames.LineCases
import dev.lazyz.conformance.frames.PointCases
import dev.lazyz.conformance.judgement.Judgement
import net.jqwik.api.ForAll

/** Rules about points and lines, which have a size in pixels. Part of `RendererConformance`. */
public sealed interface PointRules : RulesForOne {
    /** Clouds of points, most of which cover one or a few samples. */
    @Rule(
        intent = "A point is a primitive that covers one sample or a square of samples, at one depth.",
        look = "Look for primitives of one sample or one row that are lost, and for colours taken from a neighbour.",
        about = [Symptom.IN_SPACE],
        isSpecial = true,
    )
    public fun rule_2_9_pointsAreDrawnCorrectly(@ForAll(supplier = PointCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Lines of any width, most of them thin. */
    @Rule(
        intent = "A line is a primitive with one span per row and a depth that is not a linear form.",
        look = "Call Primitive.depth where depthForm is null, and expect rows of a single sample.",
        about = [Symptom.IN_SPACE],
        isSpecial = true,
    )
    public fun rule_2_10_linesAreDrawnCorrectly(@ForAll(supplier = LineCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Translucent points and lines. */
    @Rule(
        intent = "Translucent points and lines blend as polygons do.",
        look = "Sort a sample's fragments by their keys, regardless of the kind of primitive.",
        about = [Symptom.TRANSLUCENT],
        isSpecial = true, tries = 60,
    )
    public fun rule_5_5_pointsAndLinesBlend(@ForAll(supplier = BlendedPointCases::class) case: FrameCase) {
        val renderer = renderer(Capability.TRANSPARENCY)
        Judgement(renderer, case).equalsReference()
    }
}
