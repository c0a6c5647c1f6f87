package dev.lazyz.conformance

import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.run.Deadline
import dev.lazyz.conformance.run.Journal
import dev.lazyz.conformance.run.JournalFollower
import dev.lazyz.conformance.run.Lateness
import dev.lazyz.conformance.run.Settings
import dev.lazyz.conformance.run.StallTimer
import dev.lazyz.conformance.run.Supervisor
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.time.Duration
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * Runs the suite in a separate process, so that a run survives whatever the renderer does to that process. If the
 * process exits, halts, crashes or hangs, the rule that was running has crashed or timed out, or is inconclusive, and a
 * new process continues with the rules that follow. After three such ends the remaining rules are not run.
 *
 * The process is any program that runs [Conformance] with [Conformance.journal]. Its output is kept but not
 * interpreted, so it should write the report to a file. It ends when this process ends, even if this process is killed.
 * Not thread safe.
 *
 * @param command the command that starts the process: a program and its arguments
 * @param journal the journal file of the process; deleted before the run
 * @param deadline the deadline of a rendering, see [Conformance.deadline]. A process that makes no progress is ended
 *   after ten deadlines and 30 seconds, and the rule that was running is inconclusive; or after two deadlines and 30
 *   seconds of processor time for each processor of the machine, and the rule has timed out
 */
public class Supervision @JvmOverloads constructor(
    private val command: List<String>,
    private val journal: Path,
    deadline: Duration = Settings.USUAL_DEADLINE,
) {
    private val patience = deadline.multipliedBy(Deadline.WALL) + GRACE
    private val processorTime =
        (deadline.multipliedBy(2) + GRACE).multipliedBy(Runtime.getRuntime().availableProcessors().toLong())
    private var listener = RuleListener { _, _, _ -> }

    /** Sets a listener that is called with the outcome of each rule, shortly after the rule has ended. */
    public fun listener(listener: RuleListener): Supervision = apply { this.listener = listener }

    /**
     * Runs processes until one completes the run, that is, until [isDone] returns true after a process has ended.
     *
     * @return the last process's exit code, and what all processes wrote to standard output and standard error
     * @throws EndedEarlyException if a process ended while no rule was running
     * @throws IOException if a process cannot be started, or the journal cannot be read or written
     * @throws InterruptedException if the calling thread is interrupted
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun run(isDone: () -> Boolean): Outcome {
        Files.deleteIfExists(journal)
        val follower = JournalFollower(journal, listener)
        val printed = StringBuilder()
        while (true) {
            val process = started()
            process.outputStream.close()
            val reader = thread(isDaemon = true, name = "lazyz-supervision") { keep(process.inputStream, printed) }
            val lateness = try {
                awaitEnd(process, follower)
            } finally {
                // Of a process that has ended, this would close the output before it is read
                if (process.isAlive) process.destroyForcibly()
            }
            val code = process.waitFor()
            reader.join(LAST_OUTPUT)
            val text = synchronized(printed) { printed.toString() }
            follower.goOn()
            if (isDone()) return Outcome(code, text)
            val (outcome, words) = when (lateness) {
                null -> RuleOutcome.CRASHED to "exit code $code"
                Lateness.UNKNOWN -> RuleOutcome.INCONCLUSIVE to "$NO_PROGRESS ${Deadline.seconds(patience)}"
                else -> RuleOutcome.TIMED_OUT to "$NO_PROGRESS ${Deadline.seconds(processorTime)} of processor time"
            }
            if (!Journal.ended(journal, words, outcome)) {
                throw EndedEarlyException(words, text, outcome == RuleOutcome.INCONCLUSIVE)
            }
            follower.goOn()
        }
    }

    private fun started(): Process {
        val builder = ProcessBuilder(command).redirectErrorStream(true)
        builder.environment()[Supervisor.VARIABLE] = "${ProcessHandle.current().pid()}"
        return builder.start()
    }

    /**
     * Waits for the process to end. Returns why it is not awaited further if its journal does not change for too long;
     * a slow process is fine.
     */
    private fun awaitEnd(process: Process, follower: JournalFollower): Lateness? {
        var state: Pair<Long, FileTime>? = null
        val silence = StallTimer(patience)
        fun used() = process.info().totalCpuDuration().orElse(Duration.ZERO)
        var before = used()
        while (!process.waitFor(MOMENT, TimeUnit.MILLISECONDS)) {
            val now = if (Files.exists(journal)) Files.size(journal) to Files.getLastModifiedTime(journal) else null
            if (now != state) {
                silence.progress()
                before = used()
            }
            state = now
            follower.goOn()
            if (used() - before >= processorTime) return Lateness.BUSY
            if (silence.left() <= 0) return Lateness.UNKNOWN
        }
        return null
    }

    /** Keeps the first part of the output, and reads and discards the rest, so that the process does not block. */
    private fun keep(stream: InputStream, to: StringBuilder) {
        val reader = stream.reader()
        val buffer = CharArray(BUFFER)
        while (true) {
            val count = reader.read(buffer)
            if (count < 0) return
            synchronized(to) { if (to.length < MOST_PRINTED) to.appendRange(buffer, 0, count) }
        }
    }

    /**
     * How a process ended.
     *
     * @property code its exit code
     * @property printed what this process and the earlier ones wrote to standard output and standard error, at most
     *   about 60,000 characters
     */
    public class Outcome internal constructor(public val code: Int, public val printed: String)

    private companion object {
        val GRACE: Duration = Duration.ofSeconds(30)
        const val NO_PROGRESS = "the process made no progress for"
        const val MOMENT = 100L

        /** Milliseconds for the output of a process that has ended. Its own children may keep the output open. */
        const val LAST_OUTPUT = 2000L
        const val BUFFER = 4096
        const val MOST_PRINTED = 60_000
    }
}

/**
 * Thrown if a process ended before the first rule or after the last, so that no rule can be blamed.
 *
 * @property printed what the process wrote to standard output and standard error
 * @property isInconclusive whether the machine may only have been too busy
 */
public class EndedEarlyException internal constructor(
    words: String,
    public val printed: String,
    public val isInconclusive: Boolean,
) : RuntimeException("the process ended while no rule was tried: $words")
