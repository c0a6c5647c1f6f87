package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenManners
import dev.lazyz.conformance.broken.BrokenRenderers
import dev.lazyz.conformance.broken.BrokenReuse
import dev.lazyz.conformance.broken.gallery.RuleNames.accidents
import dev.lazyz.conformance.broken.gallery.RuleNames.again
import dev.lazyz.conformance.broken.gallery.RuleNames.empty
import dev.lazyz.conformance.broken.gallery.RuleNames.frames
import dev.lazyz.conformance.broken.gallery.RuleNames.interrupts
import dev.lazyz.conformance.broken.gallery.RuleNames.nearest
import dev.lazyz.conformance.broken.gallery.RuleNames.options
import dev.lazyz.conformance.broken.gallery.RuleNames.outside
import dev.lazyz.conformance.broken.gallery.RuleNames.region
import dev.lazyz.conformance.broken.gallery.RuleNames.rows
import dev.lazyz.conformance.broken.gallery.RuleNames.sinks
import dev.lazyz.conformance.broken.gallery.RuleNames.threads

/** The gallery's part about how renderers are used. */
internal object UseGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenRenderers::bottomUp, "rows from the bottom", rows),
        Mutant(BrokenRenderers::firstRowTwice, "the first row two times", rows),
        Mutant(BrokenRenderers::lastRowMissing, "all rows but the last", rows, nearest, empty),
        Mutant(BrokenRenderers::ignoresTheRegion, "the whole raster, whatever the region", region),
        Mutant(BrokenManners::regionOffsetTwice, "rows are numbered from the region's start, twice", region),
        Mutant(BrokenManners::looksOutsideTheRegion, "asks for the spans of all, and then for the region's", outside),
        Mutant(BrokenRenderers::remembersTheLastFrame, "the background shows the frame before", again, threads),
        Mutant(
            BrokenReuse::rowsOfTheFirstTallFrame,
            "arrays are made for the first frame of several bands, and not made longer for a later one",
            RuleNames.sizes,
        ),
        Mutant(
            BrokenRenderers::oneThreadOnly,
            "the frame is in a field, so that concurrent calls render each other's frames",
            threads,
        ),
        Mutant(BrokenManners::widthOf97, "one width is wrong, which only a user's frame has", frames),
        Mutant(BrokenManners::configuresItself, "`configured` sets the options of the renderer itself", options),
        Mutant(BrokenManners::addsToExceptions, "adds to what a primitive or the sink throws", accidents, sinks),
        Mutant(BrokenManners::failsAfterAFailure, "after one failure, every later call fails", accidents, sinks),
        Mutant(BrokenManners::interruptedHalfWay, "an interrupted thread gets an empty picture", interrupts),
        Mutant(BrokenManners::failsWhenInterrupted, "an interrupted thread gets an unrelated exception", interrupts),
    )
}
