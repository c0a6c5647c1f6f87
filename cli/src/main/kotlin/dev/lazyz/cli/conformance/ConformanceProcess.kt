package dev.lazyz.cli.conformance

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.conformance.EndedEarlyException
import dev.lazyz.conformance.Supervision
import dev.lazyz.conformance.results.RuleListener
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.createDirectory
import kotlin.io.path.createFile
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Files through which two processes of `zcli conformance` communicate: the parent process, which the user started, and
 * the child process, which runs the strategy and may end at any moment.
 */
internal class ConformanceProcess private constructor(private val folder: Path) {
    private val output = folder.resolve("output")
    private val done = folder.resolve("done")

    /** For temporary files of the child process, so that those of other processes are not taken for the strategy's. */
    private val temporary = folder.resolve("temporary")

    /** The file to which the child process writes its progress. */
    val journal: Path = folder.resolve("journal")

    /** Calls [block] in the child process, and writes the exit code that it returns to a file for the parent. */
    fun answer(block: (Path) -> Int): Int {
        val code = try {
            block(output)
        } catch (exhausted: VirtualMachineError) {
            // The strategy has exhausted memory or stack. Treat this like any other crash of the process
            throw exhausted
        } catch (failure: Throwable) {
            done.createFile()
            throw failure
        }
        done.writeText("$code")
        return code
    }

    @OptIn(ExperimentalPathApi::class)
    private fun delete() {
        // Links that the strategy has made there are deleted, not followed
        folder.deleteRecursively()
    }

    private fun command(args: List<String>, seed: Long): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val options = inherited(ManagementFactory.getRuntimeMXBean().inputArguments)
        val own = listOf("-D$FOLDER=$folder", "-D$SEED=$seed", "-D$TEMPORARY=$temporary")
        return listOf(java) + options + own + listOf("-cp", System.getProperty("java.class.path"), MAIN) + args
    }

    /** The result of the child: [report] is the text to print, or null if [messages] contain an error. */
    class Answer(val code: Int, val report: String?, val messages: String)

    companion object {
        private const val FOLDER = "zcli.conformance.folder"
        private const val SEED = "zcli.conformance.seed"
        private const val TEMPORARY = "java.io.tmpdir"
        private const val MAIN = "dev.lazyz.cli.MainKt"
        private const val INCUBATOR = "WARNING: Using incubator modules"

        private const val SERIAL = "-XX:+UseSerialGC"

        /** With this garbage collector, rules about memory measure the heap in one collection instead of several. */
        private val EXACT_COLLECTOR = listOf(SERIAL, "-XX:MarkSweepAlwaysCompactCount=1")

        /** JVM options that the child process must not inherit. */
        private val NOT_INHERITED =
            listOf("-agentlib:jdwp", "-XX:ArchiveClassesAtExit", "-Xlog:", "-D$FOLDER", "-D$SEED", "-D$TEMPORARY")

        /** Returns the child's JVM options for a parent that has [options]: a collector that the user chose is kept. */
        fun inherited(options: List<String>): List<String> {
            val kept = options.filter { option -> NOT_INHERITED.none { option.startsWith(it) } }
            val collectors = kept.filter { it.startsWith("-XX:+Use") && it.endsWith("GC") }
            return if (collectors.all { it == SERIAL }) EXACT_COLLECTOR + kept else kept
        }

        /** Returns the object for this process if it is a child process; null in the parent. */
        fun current(): ConformanceProcess? = System.getProperty(FOLDER)?.let { ConformanceProcess(Path.of(it)) }

        /** Returns the random seed that all child processes of a run share; null in the parent. */
        fun seed(): Long? = System.getProperty(SEED)?.toLongOrNull()

        /**
         * Runs zcli with [args] in a child process, and starts it again if the strategy ends it. Reports the outcome of
         * each rule to [listener].
         *
         * @throws EndedEarlyException if the process ends before the strategy is tried
         */
        fun run(args: List<String>, seed: Long, deadline: Duration, listener: RuleListener): Answer {
            val folder = Files.createTempDirectory("zcli-conformance")
            val process = ConformanceProcess(folder)
            process.temporary.createDirectory()
            val early = EarlyEnd { process.delete() }
            try {
                val outcome = Supervision(process.command(args, seed), process.journal, deadline)
                    .listener(listener)
                    .run {
                        early.awaitIfBegun()
                        process.done.exists()
                    }
                val report = if (process.output.exists()) process.output.readText() else null
                val messages = outcome.printed.lines().filterNot { it.startsWith(INCUBATOR) }.joinToString("\n")

                // A strategy can change the exit code of the process, but not the one in the file
                val code = process.done.readText().toIntOrNull() ?: outcome.code.takeIf { it != 0 } ?: ExitCode.BUG
                return Answer(code, report, messages)
            } finally {
                early.withdraw()
                process.delete()
            }
        }
    }
}

/**
 * What happens if this process is asked to end, for example by SIGTERM, while child processes run: they are ended, and
 * then [delete] deletes the files of both.
 */
internal class EarlyEnd(private val delete: () -> Unit) {
    @Volatile
    private var hasBegun = false

    private val hook = Thread({ end() }, "zcli-early-end").also { Runtime.getRuntime().addShutdownHook(it) }

    private fun end() {
        hasBegun = true

        // A child that still runs would create its file again
        for (child in ProcessHandle.current().children()) {
            child.destroyForcibly()
            child.onExit().join()
        }
        delete()
    }

    /** Waits for the end of this process if it was asked to end. Call it when a child has ended. */
    fun awaitIfBegun() {
        while (hasBegun) Thread.sleep(MOMENT)
    }

    /** Withdraws this, unless it has begun. */
    fun withdraw() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook)
        } catch (_: IllegalStateException) {
            // This process is ending
            awaitIfBegun()
        }
    }

    private companion object {
        const val MOMENT = 100L
    }
}
