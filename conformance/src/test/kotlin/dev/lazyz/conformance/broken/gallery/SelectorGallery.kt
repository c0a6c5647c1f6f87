package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenCells
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.BrokenVariants
import dev.lazyz.conformance.broken.gallery.RuleNames.accidents
import dev.lazyz.conformance.broken.gallery.RuleNames.called
import dev.lazyz.conformance.broken.gallery.RuleNames.chosen
import dev.lazyz.conformance.broken.gallery.RuleNames.far
import dev.lazyz.conformance.broken.gallery.RuleNames.meets
import dev.lazyz.conformance.broken.gallery.RuleNames.selects
import dev.lazyz.conformance.broken.gallery.RuleNames.status

/** The gallery's part about selectors and the cells that they get. */
internal object SelectorGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenCells::keepsItsSelector, "continues to use a selector after options without one", selects),
        Mutant(BrokenCells::ignoresTheSelector, "promises selection, but shows the nearest fragment", selects),
        Mutant(
            BrokenCells::selectsWithoutTheNearest,
            "the selector does not get the nearest of several fragments",
            selects,
        ),
        Mutant(
            BrokenCells::firstShowDecides,
            "if a selector calls show several times, the first call decides instead of the last",
            selects,
        ),
        Mutant(BrokenCells::cellsFromTheBack, "the selector gets the fragments from back to front", selects),
        Mutant(BrokenCells::coarseBackground, "the selector gets the background in 8 bits a component", selects),
        Mutant(BrokenCells::wrapsAlpha, "an alpha just above 1 that a selector shows is nearly transparent", selects),
        Mutant(BrokenCells::shadesAFewHundred, "the selector gets the colours of 256 fragments", chosen),
        Mutant(BrokenCells::cutsColumns, "the selector gets columns of 16 bits", far),
        Mutant(BrokenCells::oneCell, "the cell is in a field, so that concurrent calls use each other's cells", meets),
        Mutant(BrokenCells::selectsTwice, "the selector is called twice for each sample", called),
        Mutant(BrokenCells::skipsSingleFragments, "the selector is not called where there is one fragment", called),
        Mutant(
            BrokenFailures::countsNoSelectedColours,
            "does not count the colours that a selector asks for",
            called,
        ),
        Mutant(BrokenCells::losesInterrupts, "an interrupt while the selector is called is lost", status),
        Mutant(BrokenVariants::wrapsTheSelectors, "what a selector throws is wrapped", accidents),
    )
}
