package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenColours
import dev.lazyz.conformance.broken.BrokenDepths
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
import dev.lazyz.conformance.broken.gallery.RuleNames.refuseHidden
import dev.lazyz.conformance.broken.gallery.RuleNames.scenes
import dev.lazyz.conformance.broken.gallery.RuleNames.showing
import dev.lazyz.conformance.broken.gallery.RuleNames.tests
import dev.lazyz.conformance.broken.gallery.RuleNames.ties

/** The gallery's part about colour. */
internal object ColourGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(
            BrokenRenderers::colourOfTheLoser,
            "right indices and depths, on ties the other one's colour",
            ties, tests,
        ),
        Mutant(BrokenRenderers::shadesTheNeighbour, "shades the sample to the left", nearest, own),
        Mutant(BrokenColours::constantColour, "shades a column once, in the primitive's first row", nearest, own),
        Mutant(
            BrokenColours::fillsBetweenEqualEnds,
            "shows the colour of both neighbours where they have the same",
            flecks,
        ),
        Mutant(
            BrokenColours::oneColourWithoutCursor,
            "shades every eighth column of primitives without a shading cursor",
            flecks,
        ),
        Mutant(BrokenColours::premultiplied, "hands out colours multiplied by alpha", nearest),
        Mutant(BrokenColours::alphaLost, "hands out opaque colours", nearest),
        Mutant(BrokenDepths::mergesEqualColours, "neighbours of one colour get one depth", scenes),
        Mutant(BrokenColours::oneStepShort, "a stepped colour is one step short", options),
        Mutant(BrokenColours::oneStepTooMany, "a stepped colour is one step too far", options),
        Mutant(BrokenRenderers::blendsAsSubmitted, "blends in the order of submission", blend, pointsBlend),
        Mutant(BrokenRenderers::blendsFromTheBack, "blends from the back, which rounds differently", blend),
        Mutant(BrokenRenderers::blendsInEightBits, "blends into 8 bits a component, over and over", blend),
        Mutant(BrokenRenderers::blendsBehindTheBackdrop, "blends what lies behind an opaque fragment, too", blend),
        Mutant(BrokenRenderers::depthOfTheBackdrop, "blends right, and tells the depth of what is farthest", blend),
        Mutant(BrokenGlass::zeroTimesInfinity, "adds what has alpha 0, so that infinite light is NaN", extremes),
        Mutant(BrokenGlass::nothingIsBlack, "where all alphas are 0 the backdrop's light is lost", extremes),
        Mutant(BrokenGlass::nanIsWhite, "what is no number is packed as white", packed),
        Mutant(BrokenGlass::shadesAhead, "shades all translucent fragments before it blends", showing),
        Mutant(BrokenGlass::refusesInSight, "refuses what is translucent only within the region", refuseHidden),
        Mutant(BrokenRenderers::takesGlassForOpaque, "takes what is translucent for opaque, without a word", refuse),
    )
}
