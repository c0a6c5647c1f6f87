package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenReuse
import dev.lazyz.conformance.broken.BrokenStreams
import dev.lazyz.conformance.broken.BrokenVariants

/** The gallery's part about what is true only for opaque primitives, whole pictures or frames. */
internal object VariantGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenVariants::blendsThreeHundred, "blends at most 300 translucent primitives", RuleNames.thousand),
        Mutant(
            BrokenVariants::buffersGlass,
            "delivers the first row of a translucent picture after the last is rendered",
            RuleNames.streams, RuleNames.unpulled, RuleNames.memory,
        ),
        Mutant(BrokenVariants::oneThreadForGlass, "one thread for translucent pictures", RuleNames.parallel),
        Mutant(
            BrokenVariants::oneThreadTooManyForGlass,
            "one thread more than allowed for translucent pictures",
            RuleNames.parallel,
        ),
        Mutant(
            BrokenStreams::continuesAfterAnError,
            "begins again after a primitive has thrown an Error",
            RuleNames.ended,
        ),
        Mutant(
            BrokenStreams::refusesBeforeItLooks,
            "refuses a translucent primitive for an ended image as for any other",
            RuleNames.ended,
        ),
        Mutant(BrokenStreams::namesTheFirst, "names another primitive than it refuses", RuleNames.oneByOne),
        Mutant(BrokenReuse::countsALastGroup, "counts the primitives of the last group", RuleNames.counted),
        Mutant(
            BrokenReuse::countsWhatIsKeptAgain,
            "draws the visible primitives again with each group, and counts their fragments each time",
            RuleNames.counted,
        ),
        Mutant(BrokenReuse::numbersALastGroup, "numbers the primitives of the last group from 0", RuleNames.counted),
        Mutant(BrokenReuse::numbersEachPart, "numbers primitives of streamed parts from 0", RuleNames.streamed),
        Mutant(BrokenReuse::streamsAsOpaque, "draws streamed parts as if they were opaque", RuleNames.streamed),
        Mutant(BrokenStreams::keepsWhatArrives, "keeps a note of each picture that it begins", RuleNames.leaks),
    )
}
