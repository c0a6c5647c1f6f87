package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenCells
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.gallery.RuleNames.called
import dev.lazyz.conformance.broken.gallery.RuleNames.chosen
import dev.lazyz.conformance.broken.gallery.RuleNames.far
import dev.lazyz.conformance.broken.gallery.RuleNames.selects
import dev.lazyz.conformance.broken.gallery.RuleNames.status

/** The gallery's part about selectors and the cells that they get. */
internal object SelectorGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenCells::ignoresTheSelector, "promises selection, but shows the nearest fragment", selects),
        Mutant(BrokenCells::cellsFromTheBack, "the selector gets the fragments from back to front", selects),
        Mutant(BrokenCells::wrapsAlpha, "an alpha just above 1 that a selector shows is nearly transparent", selects),
        Mutant(BrokenCells::shadesAFewHundred, "the selector gets the colours of 256 fragments", chosen),
        Mutant(BrokenCells::cutsColumns, "the selector gets columns of 16 bits", far),
        Mutant(BrokenCells::selectsTwice, "the selector is called twice for each sample", called),
        Mutant(BrokenCells::skipsSingleFragments, "the selector is not called where there is one fragment", called),
        Mutant(
            BrokenFailures::countsNoSelectedColours,
            "does not count the colours that a selector asks for",
            called,
        ),
        Mutant(BrokenCells::losesInterrupts, "an interrupt while the selector is called is lost", status),
    )
}
