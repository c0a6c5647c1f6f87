package dev.lazyz.cli.conformance

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.conformance.EndedEarlyException
import dev.lazyz.conformance.Supervision
import dev.lazyz.conformance.results.RuleListener
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.createFile
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * What two processes of `zcli conformance` tell each other: the one that the user started, and the one that runs the
 * strategy, which may end at any moment.
 */
internal class ConformanceProcess private constructor(private val folder: Path) {
    private val output = folder.resolve("output")
    private val done = folder.resolve("done")

    /** Where the run says how far it has come. */
    val journal: Path = folder.resolve("journal")

    /** Calls [block] in the process that runs the strategy, and leaves the exit code that it returns for the other. */
    fun answer(block: (Path) -> Int): Int {
        val code = try {
            block(output)
        } catch (exhausted: VirtualMachineError) {
            // The strategy has taken all there is: a crash, like any other end of the process
            throw exhausted
        } catch (told: Throwable) {
            done.createFile()
            throw told
        }
        done.writeText("$code")
        return code
    }

    private fun command(args: List<String>, seed: Long): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val options = ManagementFactory.getRuntimeMXBean().inputArguments.filter { option ->
            UNWELCOME.none { option.startsWith(it) }
        }
        val own = listOf("-D$FOLDER=$folder", "-D$SEED=$seed")
        return listOf(java) + options + own + listOf("-cp", System.getProperty("java.class.path"), MAIN) + args
    }

    /** What came of it: [report] is what to print, or null if the process told of a mistake in [messages]. */
    class Answer(val code: Int, val report: String?, val messages: String)

    companion object {
        private const val FOLDER = "zcli.conformance.folder"
        private const val SEED = "zcli.conformance.seed"
        private const val MAIN = "dev.lazyz.cli.MainKt"
        private const val INCUBATOR = "WARNING: Using incubator modules"

        /** Options of Java that two processes cannot have at once. */
        private val UNWELCOME = listOf("-agentlib:jdwp", "-XX:ArchiveClassesAtExit", "-Xlog:", "-D$FOLDER", "-D$SEED")

        /** That of the process which runs the strategy; null in the one that the user started. */
        fun current(): ConformanceProcess? = System.getProperty(FOLDER)?.let { ConformanceProcess(Path.of(it)) }

        /** A random seed that all processes of a run share; null in the one that the user started. */
        fun seed(): Long? = System.getProperty(SEED)?.toLongOrNull()

        /**
         * Runs zcli with [args] in a process of its own, and again where a strategy has ended it; tells [listener] of
         * each rule.
         *
         * @throws EndedEarlyException if the process ends before the strategy is tried
         */
        fun run(args: List<String>, seed: Long, deadline: Duration, listener: RuleListener): Answer {
            val folder = Files.createTempDirectory("zcli-conformance")
            val process = ConformanceProcess(folder)
            try {
                val outcome = Supervision(process.command(args, seed), process.journal, deadline)
                    .listener(listener)
                    .run { process.done.exists() }
                val report = if (process.output.exists()) process.output.readText() else null
                val messages = outcome.printed.lines().filterNot { it.startsWith(INCUBATOR) }.joinToString("\n")

                // A strategy may change the exit code, but not what has been found
                val code = process.done.readText().toIntOrNull() ?: outcome.code.takeIf { it != 0 } ?: ExitCode.BUG
                return Answer(code, report, messages)
            } finally {
                for (file in listOf(process.output, process.done, process.journal, folder)) file.deleteIfExists()
            }
        }
    }
}
