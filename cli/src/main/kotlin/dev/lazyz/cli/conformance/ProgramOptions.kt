package dev.lazyz.cli.conformance

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.options.count
import dev.lazyz.cli.options.path
import dev.lazyz.cli.output.Mistake
import dev.lazyz.conformance.corpus.CorpusFiles
import dev.lazyz.conformance.corpus.ProgramConformance
import java.nio.file.Path

/** Options for programs in any language, which draw the scenes of the corpus. */
internal class ProgramOptions :
    OptionGroup("Programs", "Tests a program in any language, which is called for each scene of the corpus.") {
    private val program by option(
        "--program",
        metavar = "COMMAND",
        help = "The command to test; {scene} in it is the file to read, {picture} the one to write, and {depth} and " +
            "{primitive}, if they are there, files for these",
    )

    private val baseline by option(
        "--baseline",
        help = "Results of an earlier run, which is written if there is none: what failed may fail again, and new " +
            "failures and new passes are reported",
    ).path()

    private val jobs by option("--jobs", help = "How many scenes are drawn at a time; default: one per processor")
        .count(1..MOST_JOBS)

    private val export by option("--export", help = "Write the corpus to this folder, and test nothing").path("FOLDER")

    /** Whether a program is to be tested. */
    val isAsked: Boolean get() = program != null

    /**
     * Writes the corpus and returns what was done; null if that is not asked for. Throws [Mistake] if one of the
     * options was given that has no effect, among [others].
     */
    fun exported(others: List<String>): String? {
        if (program == null && baseline != null) throw Mistake("--baseline needs --program")
        if (program == null && jobs != null) throw Mistake("--jobs needs --program")
        val folder: Path = export ?: return null
        val unused = (listOfNotNull(program?.let { "--program" }) + others).firstOrNull()
        if (unused != null) throw Mistake("$unused has no effect with --export, which only writes files: omit it")
        return "${CorpusFiles.write(folder)} scenes in $folder\n"
    }

    /**
     * Returns the run of the program. Throws [Mistake] if the command is not one, or if one of [others] was given, the
     * options that have no effect with it.
     */
    fun conformance(others: List<String>): ProgramConformance {
        val unused = others.firstOrNull()
        if (unused != null) throw Mistake("$unused has no effect with --program, which tests no strategy: omit it")
        val run = try {
            ProgramConformance(checkNotNull(program))
        } catch (bad: IllegalArgumentException) {
            throw Mistake("--program: ${bad.message}")
        }
        baseline?.let { run.baseline(it) }
        jobs?.let { run.jobs(it) }
        return run
    }

    private companion object {
        const val MOST_JOBS = 1024
    }
}
