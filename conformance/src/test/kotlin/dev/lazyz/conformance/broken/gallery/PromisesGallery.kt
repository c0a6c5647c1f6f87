package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenColours
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.BrokenPromises
import dev.lazyz.conformance.broken.BrokenRenderers
import dev.lazyz.conformance.broken.BrokenStreams
import dev.lazyz.conformance.broken.gallery.RuleNames.among
import dev.lazyz.conformance.broken.gallery.RuleNames.arrivals
import dev.lazyz.conformance.broken.gallery.RuleNames.budget
import dev.lazyz.conformance.broken.gallery.RuleNames.counts
import dev.lazyz.conformance.broken.gallery.RuleNames.empty
import dev.lazyz.conformance.broken.gallery.RuleNames.ended
import dev.lazyz.conformance.broken.gallery.RuleNames.fragments
import dev.lazyz.conformance.broken.gallery.RuleNames.held
import dev.lazyz.conformance.broken.gallery.RuleNames.memory
import dev.lazyz.conformance.broken.gallery.RuleNames.memoryReport
import dev.lazyz.conformance.broken.gallery.RuleNames.oneByOne
import dev.lazyz.conformance.broken.gallery.RuleNames.options
import dev.lazyz.conformance.broken.gallery.RuleNames.parallel
import dev.lazyz.conformance.broken.gallery.RuleNames.passes
import dev.lazyz.conformance.broken.gallery.RuleNames.promise
import dev.lazyz.conformance.broken.gallery.RuleNames.steps
import dev.lazyz.conformance.broken.gallery.RuleNames.streams
import dev.lazyz.conformance.broken.gallery.RuleNames.sums
import dev.lazyz.conformance.broken.gallery.RuleNames.unpulled
import dev.lazyz.conformance.broken.gallery.RuleNames.unsupported

/** The gallery's part about counters and capabilities. */
internal object PromisesGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenRenderers::countsACallTooMany, "counts a shading call that never happens", counts, empty),
        Mutant(BrokenRenderers::countsNoPasses, "does not count depth passes", passes),
        Mutant(BrokenPromises::reportsNoMemory, "does not report its working memory", memoryReport),
        Mutant(BrokenPromises::countsVisibleFragments, "counts visible samples as fragments", fragments),
        Mutant(BrokenPromises::countsRejectedTwice, "counts rejected fragments twice", fragments),
        Mutant(BrokenFailures::countsHalfTheDepths, "counts half of the depths that it computes", RuleNames.depths),
        Mutant(BrokenPromises::countsEveryTest, "counts every comparison as passed", among),
        Mutant(BrokenPromises::testsTheBackground, "computes depths where nothing is covered", among),
        Mutant(BrokenColours::shadesBeforeTheTest, "shades before the depth test", promise),
        Mutant(BrokenColours::shadesTwice, "shades each visible sample twice, and counts one", counts, promise),
        Mutant(BrokenPromises::reportsNoLayers, "does not report the memory of translucent layers", held),
        Mutant(
            BrokenPromises::keepsGlass,
            "promises to stream primitives, but keeps those of frames that blend",
            arrivals,
        ),
        Mutant(BrokenColours::countsNoSteps, "does not count steps", steps),
        Mutant(BrokenColours::countsWholeChains, "counts the steps of a row as one chain", steps),
        Mutant(BrokenStreams::drawsTheTranslucent, "draws translucent primitives as opaque ones", oneByOne),
        Mutant(BrokenStreams::deliversAgain, "delivers an image again when it is finished twice", ended),
        Mutant(BrokenStreams::ignoresOptions, "ignores options that it does not support", unsupported),
        Mutant(BrokenStreams::refusesItsOwnOptions, "refuses options that it promises to support", unsupported),
        Mutant(
            BrokenPromises::memoryGrows,
            "promises constant memory, but reports memory that grows with the rows",
            memory,
        ),
        Mutant(BrokenPromises::buffersRows, "promises to stream rows, but buffers the picture", streams, unpulled),
        Mutant(
            BrokenPromises::looksAhead,
            "promises to stream rows, but queries the next row first",
            streams, unpulled,
        ),
        Mutant(
            BrokenPromises::keepsPrimitives,
            "promises to stream primitives, but stores and sorts all of them",
            arrivals,
        ),
        Mutant(BrokenPromises::notParallel, "promises to be parallel, but uses one thread", parallel),
        Mutant(BrokenPromises::countsByThread, "counts work of its own for each thread", sums),
        Mutant(BrokenPromises::losesCounts, "loses the counts of all threads but one", sums),
        Mutant(BrokenPromises::budgetIgnored, "promises to stay within a budget, but ignores it", budget),
        Mutant(
            BrokenPromises::noColoursWithoutBudget,
            "with a memory budget of 0, all colours are missing",
            budget, options,
        ),
    )
}
