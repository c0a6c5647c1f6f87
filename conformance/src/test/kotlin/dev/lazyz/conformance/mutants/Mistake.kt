package dev.lazyz.conformance.mutants

import dev.lazyz.Renderer
import dev.lazyz.conformance.mutants.skeletons.Skeletons
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import dev.lazyz.conformance.mutants.wrappers.ColourMistakes
import dev.lazyz.conformance.mutants.wrappers.CombinationMistakes
import dev.lazyz.conformance.mutants.wrappers.CoverageMistakes
import dev.lazyz.conformance.mutants.wrappers.DepthMistakes
import dev.lazyz.conformance.mutants.wrappers.FailureMistakes
import dev.lazyz.conformance.mutants.wrappers.GlassMistakes
import dev.lazyz.conformance.mutants.wrappers.MannerMistakes
import dev.lazyz.conformance.mutants.wrappers.MemoryMistakes
import dev.lazyz.conformance.mutants.wrappers.PixelMistakes
import dev.lazyz.conformance.mutants.wrappers.PromiseMistakes
import dev.lazyz.conformance.mutants.wrappers.ReuseMistakes
import dev.lazyz.conformance.mutants.wrappers.SelectorMistakes
import dev.lazyz.conformance.mutants.wrappers.ShadingMistakes
import dev.lazyz.conformance.mutants.wrappers.SizeMistakes
import dev.lazyz.conformance.mutants.wrappers.StreamMistakes
import dev.lazyz.conformance.mutants.wrappers.ThreadMistakes
import dev.lazyz.conformance.mutants.wrappers.TidyMistakes
import dev.lazyz.conformance.mutants.wrappers.VariantMistakes

/**
 * A mistake, and the rules that must notice a renderer that makes it. The rules are in `mistakes.csv`, a line for each
 * mistake.
 *
 * @property make returns a new renderer, because some have state
 * @property what the mistake, in words
 */
internal class Mistake(val make: () -> Renderer, val what: String, id: String? = null) {
    /** The name of the mistake, by default that of the renderer. */
    val id: String by lazy { id ?: make().id }

    /** Names of the rules that must all fail; others may fail, too. */
    val noticedBy: List<String> get() = checkNotNull(noticed[id]) { "mistakes.csv has no rules for $id" }

    /** A mistake in a step of a skeleton. */
    constructor(id: String, what: String, make: () -> Renderer) : this(make, what, id)

    companion object {
        /** The rules that must notice a mistake, by its name. */
        val noticed: Map<String, List<String>> =
            checkNotNull(Mistake::class.java.getResource("/mistakes.csv")).readText().trim().lines().drop(1)
                .associate { it.substringBefore(',') to it.substringAfter(',').split(' ') }
    }
}

/**
 * All mistakes. They prove that the suite can fail: each rule notices one at least, and three if there are so many ways
 * to break it. Some go into a step of a renderer that is written for them ([Skeletons]); the others are made around one
 * of the library's strategies, in the frame that it gets or in what it returns.
 */
internal object Mistakes {
    val all: List<Mistake> = Skeletons.mistakes + CoverageMistakes.mistakes + DepthMistakes.mistakes +
        BasicMistakes.mistakes + SizeMistakes.mistakes + CombinationMistakes.mistakes + ColourMistakes.mistakes +
        GlassMistakes.mistakes + PixelMistakes.mistakes + ShadingMistakes.mistakes +
        MannerMistakes.mistakes + ThreadMistakes.mistakes + PromiseMistakes.mistakes + MemoryMistakes.mistakes +
        SelectorMistakes.mistakes + VariantMistakes.mistakes + ReuseMistakes.mistakes + StreamMistakes.mistakes +
        FailureMistakes.mistakes + TidyMistakes.mistakes
}
