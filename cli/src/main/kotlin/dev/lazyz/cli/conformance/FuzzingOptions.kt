package dev.lazyz.cli.conformance

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.Renderer
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.number
import dev.lazyz.cli.options.path
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.conformance.fuzz.DifferentialFuzzing
import dev.lazyz.conformance.fuzz.DifferentialReport
import java.time.Duration

/** Options that compare two strategies with each other, instead of testing one against the rules. */
internal class FuzzingOptions :
    OptionGroup(
        "Two strategies",
        "Compares pictures of two strategies on random frames of any size, instead of running rules.",
    ) {
    private val against by option(
        "--against",
        metavar = "ID",
        help = "The reference strategy",
        completionCandidates = Completions.words { Strategies.ids() },
    )

    private val minutes by option("--minutes", help = "How many minutes to run, 0.01..10000; default: 1")
        .number("N", LEAST_MINUTES..MOST_MINUTES, "")

    private val corpus by option(
        "--corpus",
        help = "Save frames with new features, and frames that differ, in this folder; begin with the frames in it",
    ).path("FOLDER")

    /** Whether two strategies are to be compared. */
    val isAsked: Boolean get() = against != null

    /** Compares [strategy] with the reference; [find] makes a renderer of an id. */
    fun run(strategy: String, seed: Long?, find: (String) -> Renderer): DifferentialReport {
        val reference = checkNotNull(against)
        val fuzzing = DifferentialFuzzing({ find(reference) }, { find(strategy) })
        fuzzing.time(Duration.ofMillis(((minutes ?: 1.0) * MILLISECONDS).toLong()))
        seed?.let { fuzzing.seed(it) }
        corpus?.let { fuzzing.corpus(it) }
        return fuzzing.run()
    }

    /**
     * Throws [Mistake] if an option was given that needs `--against`, and `--against` was not; or if it was, and one of
     * [others], the given options that have no effect then.
     */
    fun check(others: List<String>) {
        if (against != null) {
            val unused = others.firstOrNull() ?: return
            throw Mistake("$unused has no effect with --against, which compares pictures and runs no rules: omit it")
        }
        if (minutes != null) throw Mistake("--minutes needs --against")
        if (corpus != null) throw Mistake("--corpus needs --against")
    }

    private companion object {
        const val LEAST_MINUTES = 0.01
        const val MOST_MINUTES = 1e4
        const val MILLISECONDS = 60_000.0
    }
}
