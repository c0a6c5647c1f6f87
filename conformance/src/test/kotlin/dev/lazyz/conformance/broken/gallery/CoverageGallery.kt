package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenCoverage
import dev.lazyz.conformance.broken.BrokenRenderers
import dev.lazyz.conformance.broken.gallery.RuleNames.empty
import dev.lazyz.conformance.broken.gallery.RuleNames.halves
import dev.lazyz.conformance.broken.gallery.RuleNames.lines
import dev.lazyz.conformance.broken.gallery.RuleNames.moved
import dev.lazyz.conformance.broken.gallery.RuleNames.narrow
import dev.lazyz.conformance.broken.gallery.RuleNames.nearest
import dev.lazyz.conformance.broken.gallery.RuleNames.own
import dev.lazyz.conformance.broken.gallery.RuleNames.points
import dev.lazyz.conformance.broken.gallery.RuleNames.scenes

/** The gallery's part about coverage. */
internal object CoverageGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenRenderers::spanEndsEarly, "every span lacks its last column", nearest, scenes, narrow, points),
        Mutant(BrokenCoverage::spansStartLate, "every span lacks its first column", nearest, halves),
        Mutant(BrokenRenderers::gapsFilled, "one span a row, from the first start to the last end", nearest, own),
        Mutant(
            BrokenCoverage::tileColumnMissing,
            "the last column of each tile of 8 x 8 samples is not drawn",
            nearest, moved,
        ),
        Mutant(
            BrokenCoverage::tileRowMissing,
            "the last row of each tile of 8 x 8 samples is not drawn",
            nearest, moved,
        ),
        Mutant(BrokenCoverage::lateActivation, "primitives become active a row late", nearest, halves),
        Mutant(BrokenCoverage::earlyRetirement, "primitives end a row early", nearest, halves),
        Mutant(BrokenRenderers::linearFormsOnly, "primitives without a linear form are not drawn", own, lines),
        Mutant(
            BrokenCoverage::singleSamplesLost,
            "rows in which a primitive has a single sample are lost",
            points, lines,
        ),
        Mutant(BrokenCoverage::losesHugeBounds, "the number of columns of a primitive overflows", RuleNames.bounds),
        Mutant(BrokenRenderers::needsAPrimitive, "fails without primitives", empty),
        Mutant(BrokenRenderers::needsTwoColumns, "fails on rasters of a single column", narrow),
    )
}
