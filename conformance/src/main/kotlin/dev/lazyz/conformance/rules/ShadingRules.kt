package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.dazzling
import dev.lazyz.conformance.cases.changed.flecked
import dev.lazyz.conformance.frames.BackFaceCases
import dev.lazyz.conformance.frames.BlendedCases
import dev.lazyz.conformance.frames.LongRowCases
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.requireDeclared
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property

/** Rules about colours: scenes with light, normals, textures and blended materials. Part of `RendererConformance`. */
@Suppress("ktlint:standard:function-naming")
public sealed interface ShadingRules : RulesForOne {
    /** Materials that blend show what lies behind; made opaque, they are materials like any other. */
    @Rule(
        intent = "Alpha of materials, of textures and of vertex colours blends, whichever side of a face is seen.",
        look = "Sort a sample's fragments by key and blend as rule 5.5 says; else render Frame.asOpaque() as it is.",
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_5_translucentMaterialsBlendInOrderOfDepth(
        @ForAll(supplier = BlendedCases::class) case: FrameCase,
    ) {
        val renderer = renderer()
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        Judgement(renderer, if (isBlending) case else case.asOpaque()).equalsReference()
    }

    /** Alpha of exactly 0 and exactly 1, and light without bounds, blend as they are defined. */
    @Rule(
        intent = "What has alpha 0 is passed over, whatever its light; where all has, the backdrop is shown as it is.",
        look = "Skip alpha 0 before multiplying, stop at transmittance 0, and do not divide by a sum of weights of 0.",
        about = [Symptom.TRANSLUCENT],
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_5_5_extremesOfLightAndAlphaBlend(@ForAll(supplier = TranslucentCases::class) case: FrameCase) {
        val renderer = renderer()
        requireDeclared(renderer, Capability.TRANSPARENCY)
        Judgement(renderer, case.dazzling()).equalsReference()
    }

    /** What has nearly the same colour everywhere is shaded sample by sample, with a shading cursor or without. */
    @Rule(
        intent = "A colour belongs to its sample: that neighbours have another, or the same, says nothing about it.",
        look = "Look for a colour found once for a run, a row or a primitive, and for runs filled between equal ends.",
        about = [Symptom.COLOR],
    )
    @Property(tries = 40, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_6_1_everySampleHasItsOwnColour(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case.flecked()).equalsReference()
    }

    /** Light that is infinite, negative or no number is packed as any other. */
    @Rule(
        intent = "A component is clamped to 0..1 and NaN is 0, whatever a shader computes.",
        look = "Pack by Fragment.toArgb, or compare so that NaN fails: neither casts nor tables know what it is.",
        about = [Symptom.COLOR],
    )
    @Property(tries = 40, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_6_4_lightOfAnyStrengthIsPacked(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case.dazzling()).equalsReference()
    }

    /** Faces seen from behind are lit as the viewer sees them: shading of back faces. */
    @Rule(
        intent = "Shading of back faces: normals are turned to the viewer, be they equal at the vertices or not.",
        look = "Look for a shortcut, for equal normals or for long rows of samples, that forgets to turn the normal.",
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_6_5_normalsOfBackFacesAreTurnedToTheViewer(
        @ForAll(supplier = BackFaceCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Light, highlights, emission, vertex colours and textures are right at every sample of long rows. */
    @Rule(
        intent = "A sample's light, texture and vertex colours are the same however many are shaded at once.",
        look = "Compare the attributes of the sample that differs with Primitive.shade: weights, normal, u and v.",
        about = [Symptom.COLOR],
    )
    @Property(tries = 60, seed = FIXED, edgeCases = EdgeCasesMode.NONE)
    public fun rule_6_5_litAndTexturedScenesAreShadedRight(@ForAll(supplier = LongRowCases::class) case: FrameCase) {
        Judgement(renderer(), case).equalsReference()
    }
}
