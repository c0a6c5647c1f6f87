package dev.lazyz.conformance

import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.run.Journal
import dev.lazyz.conformance.run.JournalFollower
import dev.lazyz.conformance.run.Settings
import dev.lazyz.conformance.run.Supervisor
import dev.lazyz.conformance.run.TryThread
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.time.Duration
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

/**
 * Keeps a run of the suite going in a process of its own, whatever the renderer does to that process: if it exits, halts,
 * crashes or hangs, the rule that was on trial has crashed or timed out, and another process goes on with the rules that
 * come after. After three such ends the remaining rules are not run.
 *
 * The process is any program that runs [Conformance] with [Conformance.journal]. What it prints is its own business; a
 * report is best written to a file. It ends when this process does, killed or not. Not thread safe.
 *
 * @param command starts the process: a program, and its arguments
 * @param journal the file that the process is told to keep its journal in; it is deleted first
 * @param deadline that of a try, see [Conformance.deadline]; a process that is silent for two deadlines and half a minute
 *   is ended
 */
public class Supervision @JvmOverloads constructor(
    private val command: List<String>,
    private val journal: Path,
    deadline: Duration = Settings.USUAL_DEADLINE,
) {
    private val patience = deadline.multipliedBy(2) + GRACE
    private var listener = RuleListener { _, _, _ -> }

    /** Tells [listener] what came of each rule, some moments after it has ended. */
    public fun listener(listener: RuleListener): Supervision = apply { this.listener = listener }

    /**
     * Runs processes until one has come to its end by itself: until [isDone] says so after a process has ended.
     *
     * @return the last process's exit code, and what all of them wrote to standard output and standard error
     * @throws EndedEarlyException if a process ended and no rule was on trial
     */
    public fun run(isDone: () -> Boolean): Outcome {
        Files.deleteIfExists(journal)
        val follower = JournalFollower(journal, listener)
        val printed = StringBuilder()
        while (true) {
            val process = started()
            process.outputStream.close()
            val reader = thread(isDaemon = true, name = "lazyz-supervision") { keep(process.inputStream, printed) }
            val isInTime = try {
                awaitEnd(process, follower)
            } finally {
                process.destroyForcibly()
            }
            val code = process.waitFor()
            reader.join(MOMENT)
            val text = synchronized(printed) { printed.toString() }
            follower.goOn()
            if (isDone()) return Outcome(code, text)
            val silence = TryThread.seconds(patience)
            val words = if (isInTime) "exit code $code" else "the process did not answer for $silence"
            val outcome = if (isInTime) RuleOutcome.CRASHED else RuleOutcome.TIMED_OUT
            if (!Journal.ended(journal, words, outcome)) throw EndedEarlyException(words, text)
            follower.goOn()
        }
    }

    private fun started(): Process {
        val builder = ProcessBuilder(command).redirectErrorStream(true)
        builder.environment()[Supervisor.VARIABLE] = "${ProcessHandle.current().pid()}"
        return builder.start()
    }

    /** Whether the process ends by itself: it may be slow, as long as its journal changes. */
    private fun awaitEnd(process: Process, follower: JournalFollower): Boolean {
        var state: Pair<Long, FileTime>? = null
        var since = System.nanoTime()
        while (!process.waitFor(MOMENT, TimeUnit.MILLISECONDS)) {
            val now = if (Files.exists(journal)) Files.size(journal) to Files.getLastModifiedTime(journal) else null
            if (now != state) since = System.nanoTime()
            state = now
            follower.goOn()
            if (System.nanoTime() - since > patience.toNanos()) return false
        }
        return true
    }

    /** Keeps the first part of what is printed, and reads the rest, so that nobody waits. */
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
     * @property printed what it and those before it wrote to standard output and standard error, at most some 60,000
     *   characters
     */
    public class Outcome internal constructor(public val code: Int, public val printed: String)

    private companion object {
        val GRACE: Duration = Duration.ofSeconds(30)
        const val MOMENT = 100L
        const val BUFFER = 4096
        const val MOST_PRINTED = 60_000
    }
}

/**
 * A process ended before the first rule was tried, or after the last: there is no rule to blame.
 *
 * @property printed what it wrote to standard output and standard error
 */
public class EndedEarlyException internal constructor(words: String, public val printed: String) :
    RuntimeException("the process ended while no rule was tried: $words")
