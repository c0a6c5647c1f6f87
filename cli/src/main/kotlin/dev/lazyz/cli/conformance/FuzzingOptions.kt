package dev.lazyz.cli.conformance

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.Renderer
import dev.lazyz.cli.options.number
import dev.lazyz.cli.output.Mistake
import dev.lazyz.conformance.fuzz.DifferentialFuzzing
import dev.lazyz.conformance.fuzz.DifferentialReport
import java.nio.file.Path
import java.time.Duration

/** Two strategies against each other, in place of one against the rules. */
internal class FuzzingOptions :
    OptionGroup(
        "Two strategies",
        "Compares pictures of two strategies on random frames of any size, in place of the rules.",
    ) {
    private val against by option(
        "--against",
        metavar = "ID",
        help = "The strategy that is believed to be right",
    )

    private val minutes by option("--minutes", help = "How long, 0.01..10000; default: 1")
        .number("N", LEAST_MINUTES..MOST_MINUTES, "")

    private val corpus by option(
        "--corpus",
        help = "Keep frames there that are unlike those before, and frames that differ; begin with what is there",
    ).convert("FOLDER") { Path.of(it) }

    /** Whether two strategies are to be compared. */
    val isAsked: Boolean get() = against != null

    /** Compares [strategy] with the other one, which [find] finds by its id. */
    fun run(strategy: Renderer, seed: Long?, find: (String) -> Renderer): DifferentialReport {
        val fuzzing = DifferentialFuzzing(find(checkNotNull(against)), strategy)
        fuzzing.time(Duration.ofMillis(((minutes ?: 1.0) * MILLISECONDS).toLong()))
        seed?.let { fuzzing.seed(it) }
        corpus?.let { fuzzing.corpus(it) }
        return fuzzing.run()
    }

    /** Complains about options that say nothing without `--against`. */
    fun check() {
        if (against != null) return
        if (minutes != null) throw Mistake("--minutes goes with --against")
        if (corpus != null) throw Mistake("--corpus goes with --against")
    }

    private companion object {
        const val LEAST_MINUTES = 0.01
        const val MOST_MINUTES = 1e4
        const val MILLISECONDS = 60_000.0
    }
}
