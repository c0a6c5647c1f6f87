package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.ShadingRate
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.dazzling
import dev.lazyz.conformance.cases.changed.flecked
import dev.lazyz.conformance.cases.changed.partlyColoured
import dev.lazyz.conformance.cases.veils
import dev.lazyz.conformance.frames.BackFaceCases
import dev.lazyz.conformance.frames.BlendedCases
import dev.lazyz.conformance.frames.LongRowCases
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.probes.Pixelated
import dev.lazyz.conformance.probes.surfacesOfOneShader
import dev.lazyz.conformance.probes.textured
import net.jqwik.api.ForAll

/** Rules about colours: scenes with light, normals, textures and blended materials. Part of `RendererConformance`. */
public sealed interface ShadingRules : RulesForOne {
    /** Blended materials show what is behind them; made opaque, they are like any other material. */
    @Rule(
        intent = "Alpha of materials, textures and vertex colours blends, for both sides of a face.",
        look = "Sort a sample's fragments by key and blend as rule 5.5 defines; otherwise render Frame.asOpaque() " +
            "unchanged.",
        tries = 60,
    )
    public fun rule_5_5_translucentMaterialsBlendInOrderOfDepth(
        @ForAll(supplier = BlendedCases::class) case: FrameCase,
    ) {
        val renderer = renderer()
        val isBlending = Capability.TRANSPARENCY in renderer.capabilities
        Judgement(renderer, if (isBlending) case else case.asOpaque()).equalsReference()
    }

    /** Alpha of exactly 0 or 1, and light without limits, blend as defined. */
    @Rule(
        intent = "Fragments with alpha 0 are skipped, whatever their light; where all have alpha 0, the backdrop is " +
            "unchanged.",
        look = "Skip alpha 0 before multiplying, stop at transmittance 0, and do not divide by a sum of weights that " +
            "is 0.",
        about = [Symptom.TRANSLUCENT],
        isSpecial = true, tries = 60,
    )
    public fun rule_5_5_extremesOfLightAndAlphaBlend(@ForAll(supplier = TranslucentCases::class) case: FrameCase) {
        val renderer = renderer(Capability.TRANSPARENCY)
        Judgement(renderer, case.dazzling()).equalsReference()
    }

    /** Where the least change of a sum changes the picture, all layers are added in single precision, in order. */
    @Rule(
        intent = "Blending is rounded as defined at every step, however little light a layer lets through.",
        look = "Add in single precision, from near to far, until transmittance is exactly 0; divide once, at the end.",
        about = [Symptom.TRANSLUCENT],
        isSpecial = true, tries = 4,
    )
    public fun rule_5_5_sumsAreRoundedAsDefined(@ForAll salt: Long) {
        val renderer = renderer(Capability.TRANSPARENCY)
        val case = veils(salt)
        Judgement(renderer, case).equalsReference()

        // With several threads, and without any memory budget, renderers take other code paths
        val options = RenderOptions(memoryBudget = 0L, threads = 2, tileSize = 8).supportedBy(renderer)
        Judgement(renderer.configured(options), case, "$options").equalsReference()
    }

    /** Pixels are the means of their samples, whether a renderer adds them up itself or its rows are filtered. */
    @Rule(
        intent = "Several samples a pixel give the same pixels, whichever way the renderer takes.",
        look =
        "If the renderer overrides renderPixels: sums in linear light, weighted by alpha, for all samples of the " +
            "pixel; depth and primitive of its nearest sample.",
        about = [Symptom.COLOR],
        isSpecial = true, tries = 30,
    )
    public fun rule_6_12_pixelsAreTheMeansOfTheirSamples(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        val renderer = renderer()
        for ((side, rate) in listOf(2 to ShadingRate.SAMPLE, 3 to ShadingRate.PIXEL, 4 to ShadingRate.AUTO)) {
            Judgement(Pixelated(renderer, side, rate), case, "$side x $side samples a pixel, rate $rate")
                .equalsPictureOf(Pixelated(ReferenceRenderer(), side, rate))
        }
    }

    /** Surfaces with nearly the same colour everywhere are shaded at every sample, with or without a shading cursor. */
    @Rule(
        intent = "Each sample has its own colour, even where all its neighbours have the same colour.",
        look = "Look for one colour used for a run, a row or a primitive, and for runs filled because both ends are " +
            "equal.",
        about = [Symptom.COLOR], tries = 40,
    )
    public fun rule_6_1_everySampleIsShadedSeparately(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case.flecked()).equalsReference()
    }

    /** Primitives and shaders that set a colour at some of their samples only are black at the others. */
    @Rule(
        intent = "A colour that a primitive does not set is opaque black, not that of the sample shaded before.",
        look = "Call Fragment.moveTo before each primitive and sample that is shaded; it resets the colour.",
        about = [Symptom.COLOR],
        isSpecial = true, tries = 60,
    )
    public fun rule_6_1_coloursThatAreNotSetAreBlack(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case.partlyColoured()).equalsReference()
    }

    /** Surfaces that have one shader, but different attributes. */
    @Rule(
        intent = "An attribute that a surface does not have is 0 for its shader, whatever was shaded before.",
        look = "Look for fragments that are shaded together because their shader is the same: their attributes may " +
            "not be.",
        about = [Symptom.COLOR], tries = 3,
    )
    public fun rule_6_2_surfacesOfOneShaderHaveTheirOwnAttributes(@ForAll salt: Long) {
        Judgement(renderer(), surfacesOfOneShader(salt)).equalsReference()
    }

    /** Infinite, negative or NaN light is packed as defined. */
    @Rule(
        intent = "A component is clamped to 0..1 and NaN becomes 0, whatever a shader computes.",
        look = "Pack with Fragment.toArgb, or compare so that NaN fails; casts and tables do not handle NaN.",
        about = [Symptom.COLOR],
        isSpecial = true, tries = 40,
    )
    public fun rule_6_4_coloursOfAnyBrightnessArePacked(@ForAll(supplier = MixedCases::class) case: FrameCase) {
        Judgement(renderer(), case.dazzling()).equalsReference()
    }

    /** Faces seen from behind are lit as the viewer sees them (shading of back faces). */
    @Rule(
        intent = "Shading of back faces: normals are turned to the viewer, whether or not they are equal at all " +
            "vertices.",
        look = "Look for a fast path, for equal normals or for long rows of samples, that does not turn the normal.",
        tries = 60,
    )
    public fun rule_6_5_normalsOfBackFacesAreTurnedToTheViewer(
        @ForAll(supplier = BackFaceCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference()
    }

    /**
     * Light, highlights, emission, vertex colours, maps with their filters, metallic-roughness materials and tone
     * mapping are correct at every sample of long rows.
     */
    @Rule(
        intent = "A sample's light, maps and vertex colours do not depend on how many samples are shaded at once.",
        look = "Compare the attributes of the sample that differs with Primitive.shade: weights, normal, tangent, " +
            "both texture coordinates and their derivatives.",
        about = [Symptom.COLOR], tries = 60,
    )
    public fun rule_6_5_litAndTexturedScenesAreShadedCorrectly(
        @ForAll(supplier = LongRowCases::class) case: FrameCase,
    ) {
        Judgement(renderer(), case).equalsReference()
    }

    /** Textures with and without mip filters on meshes of small and of large triangles. */
    @Rule(
        intent = "A texture with a mip filter is read with the footprint of its own sample, however small its " +
            "triangle is.",
        look = "Compare the derivatives of the texture coordinates with those of Primitive.shade, also where many " +
            "triangles are shaded together.",
        about = [Symptom.COLOR], tries = 8,
    )
    public fun rule_6_6_texturesAreReadWithTheirOwnFootprints(@ForAll salt: Long) {
        Judgement(renderer(), textured(salt)).equalsReference()
    }
}
