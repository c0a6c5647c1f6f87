package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenColours
import dev.lazyz.conformance.broken.BrokenGlass
import dev.lazyz.conformance.broken.BrokenRenderers
import dev.lazyz.conformance.broken.gallery.RuleNames.blend
import dev.lazyz.conformance.broken.gallery.RuleNames.extremes
import dev.lazyz.conformance.broken.gallery.RuleNames.flecks
import dev.lazyz.conformance.broken.gallery.RuleNames.nearest
import dev.lazyz.conformance.broken.gallery.RuleNames.options
import dev.lazyz.conformance.broken.gallery.RuleNames.own
import dev.lazyz.conformance.broken.gallery.RuleNames.packed
import dev.lazyz.conformance.broken.gallery.RuleNames.pointsBlend
import dev.lazyz.conformance.broken.gallery.RuleNames.refuse
import dev.lazyz.conformance.broken.gallery.RuleNames.rounded
import dev.lazyz.conformance.broken.gallery.RuleNames.showing
import dev.lazyz.conformance.broken.gallery.RuleNames.tests
import dev.lazyz.conformance.broken.gallery.RuleNames.ties
import dev.lazyz.conformance.broken.gallery.RuleNames.unset

/** The gallery's part about colour. */
internal object ColourGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(
            BrokenRenderers::colourOfTheLoser,
            "on ties, index and depth are right, but the colour is that of the other fragment",
            ties, tests,
        ),
        Mutant(
            BrokenColours::keepsAttributes,
            "a surface without texture coordinates has those of another one",
            RuleNames.oneShader,
        ),
        Mutant(BrokenRenderers::shadesTheNeighbour, "shades the sample to the left", nearest, own, flecks),
        Mutant(
            BrokenColours::constantColour,
            "shades a column once, in the primitive's first row",
            nearest, own, flecks,
        ),
        Mutant(
            BrokenColours::fillsBetweenEqualEnds,
            "shows the colour of both neighbours where they have the same",
            flecks,
        ),
        Mutant(
            BrokenColours::keepsColours,
            "shows the colour of the fragment shaded before where a primitive sets no colour",
            unset,
        ),
        Mutant(BrokenColours::oneStepShort, "a stepped colour is one step short", options),
        Mutant(BrokenRenderers::blendsAsSubmitted, "blends in the order of submission", blend, pointsBlend),
        Mutant(BrokenRenderers::blendsFromTheBack, "blends from the back, which rounds differently", blend),
        Mutant(
            BrokenGlass::zeroTimesInfinity,
            "adds fragments with alpha 0, so that infinite light becomes NaN",
            extremes,
        ),
        Mutant(BrokenGlass::stopsEarly, "stops blending at a transmittance of 1e-7", rounded),
        Mutant(BrokenGlass::multipliesByTheReciprocal, "multiplies sums by the reciprocal of the weights", rounded),
        Mutant(BrokenGlass::nanIsWhite, "NaN is packed as white", packed),
        Mutant(BrokenGlass::shadesAhead, "shades all translucent fragments before it blends", showing),
        Mutant(
            BrokenRenderers::translucentAsOpaque,
            "draws translucent primitives as if they were opaque, without an error",
            refuse,
        ),
    )
}
