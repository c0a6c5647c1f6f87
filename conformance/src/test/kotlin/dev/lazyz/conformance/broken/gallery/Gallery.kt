package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.broken.BrokenRenderer

/**
 * A wrong renderer and the rules that must notice it.
 *
 * @property make returns a new instance, because some have state
 * @property what its mistake, in words
 * @property noticedBy names of the rules that must all fail; other rules may fail, too
 */
internal class Mutant(val make: () -> BrokenRenderer, val what: String, vararg noticedBy: String) {
    val id: String = make().id
    val noticedBy: List<String> = noticedBy.toList()
}

/** All wrong renderers, by topic. They prove that the suite can fail. */
internal object Gallery {
    val themes: Map<String, List<Mutant>> = linkedMapOf(
        "Coverage" to CoverageGallery.mutants,
        "Depth and order" to DepthAndOrderGallery.mutants,
        "Size" to SizeGallery.mutants,
        "Combinations" to CombinationGallery.mutants,
        "Colour" to ColourGallery.mutants,
        "Light, textures and materials" to ShadingGallery.mutants,
        "Use" to UseGallery.mutants,
        "Threads and the sink" to ThreadGallery.mutants,
        "Counters and promises" to PromisesGallery.mutants,
        "Memory" to MemoryGallery.mutants,
        "Selectors" to SelectorGallery.mutants,
        "Translucent primitives, regions and primitives one by one" to VariantGallery.mutants,
        "What is left behind" to TidyGallery.mutants,
    )

    val all: List<Mutant> get() = themes.values.flatten()

    /** The gallery as a page of the documentation. */
    fun page(): String = buildString {
        append("# The gallery of wrong renderers\n\n")
        append("A suite that cannot fail proves nothing. Each of these ${all.size} renderers makes one mistake, and\n")
        append("the rules beside it fail for it at the default effort; others may, too. `BrokenRenderersTest` runs\n")
        append("a nineteenth of them in a build, all with `-Dlazyz.effort=full`, and writes this page, so do not\n")
        append("edit it.\n")
        for ((theme, mutants) in themes) {
            append("\n## $theme\n\n| renderer | mistake | noticed by |\n|---|---|---|\n")
            for (it in mutants) {
                append(
                    "| `${it.id}` | ${it.what} | ${it.noticedBy.joinToString("<br>") {
                        "`$it`"
                    }} |\n"
                )
            }
        }
        append("\n## Rule by rule\n\n| rule | level | notices |\n|---|---|---|\n")
        for (rule in SuiteRun.rules.sorted()) {
            val noticed = all.filter { rule in it.noticedBy }.joinToString(", ") { "`${it.id}`" }
            append("| `$rule` | ${SuiteRun.annotation(rule).level} | $noticed |\n")
        }
    }
}
