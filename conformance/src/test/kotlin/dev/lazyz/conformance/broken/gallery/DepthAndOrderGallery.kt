package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenDepths
import dev.lazyz.conformance.broken.BrokenManners
import dev.lazyz.conformance.broken.BrokenRenderers
import dev.lazyz.conformance.broken.gallery.RuleNames.background
import dev.lazyz.conformance.broken.gallery.RuleNames.copies
import dev.lazyz.conformance.broken.gallery.RuleNames.counts
import dev.lazyz.conformance.broken.gallery.RuleNames.equal
import dev.lazyz.conformance.broken.gallery.RuleNames.hidden
import dev.lazyz.conformance.broken.gallery.RuleNames.index
import dev.lazyz.conformance.broken.gallery.RuleNames.many
import dev.lazyz.conformance.broken.gallery.RuleNames.nearest
import dev.lazyz.conformance.broken.gallery.RuleNames.order
import dev.lazyz.conformance.broken.gallery.RuleNames.pairs
import dev.lazyz.conformance.broken.gallery.RuleNames.parts
import dev.lazyz.conformance.broken.gallery.RuleNames.scenes
import dev.lazyz.conformance.broken.gallery.RuleNames.tests
import dev.lazyz.conformance.broken.gallery.RuleNames.ties

/** The gallery's part about depth and order. */
internal object DepthAndOrderGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenRenderers::lastWinsTies, "compares with `<=` instead of `<`", ties, tests, pairs),
        Mutant(BrokenRenderers::usualTestOnly, "the usual depth test, whatever the raster says", tests, pairs),
        Mutant(BrokenRenderers::lastSubmittedWins, "the painter's algorithm without its sort", nearest, scenes, order),
        Mutant(
            BrokenDepths::flatPrimitives,
            "whole primitives are sorted by their nearest depths, instead of comparing samples",
            nearest, hidden,
        ),
        Mutant(
            BrokenDepths::staleRejection,
            "a whole primitive is rejected if it is hidden at one sample",
            nearest, order,
        ),
        Mutant(
            BrokenDepths::rejectsByConvention,
            "rejects what is behind the background by the convention, whatever the depth test",
            tests, pairs,
        ),
        Mutant(BrokenRenderers::backgroundAtInfinity, "a background that is always behind everything", background),
        Mutant(BrokenDepths::dropsEqualPrimitives, "a primitive that equals an earlier one is dropped", equal),
        Mutant(BrokenDepths::numbersByEquality, "the index is that of the first primitive that is equal", equal),
        Mutant(
            BrokenRenderers::dropsTheInvisible,
            "primitives that cover nothing get no index, so later primitives have wrong ones",
            index, counts, parts,
        ),
        Mutant(BrokenManners::indexIn16Bits, "indices have 16 bits", many),
        Mutant(
            BrokenManners::indexByIdentity,
            "a primitive that is submitted twice has the index of its first occurrence",
            copies,
        ),
    )
}
