package dev.lazyz.conformance.run

import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.attribute.FileTime
import kotlin.io.path.readLines
import kotlin.io.path.readText

/**
 * A file that records the progress of a run of the suite, so that another process can continue a run whose process has
 * ended. Each rule has a line: its name, a dot for each try, a comma for each shrinking step, the outcome, and the
 * duration in milliseconds. A line without an outcome belongs to the rule that was running when the process ended; the
 * supervising process then appends the reason with [ended]. Lines are appended and never changed. Thread safe.
 *
 * @property path the file; if it exists, its run is continued
 */
internal class Journal(private val path: Path) {
    /** How the processes of earlier runs ended, by the name of the rule that was running. */
    private val ends: Map<String, ProcessEnd> = (if (Files.exists(path)) path.readLines() else listOf())
        .mapNotNull { ProcessEnd.of(it) }.associateBy { it.rule }

    @Volatile
    private var touched = 0L

    /** Whether the last line has a rule without an outcome. */
    private var isOpen = false

    init {
        // Keep all lines, because a follower continues reading where it stopped
        val isUnfinished = Files.exists(path) && path.readText().let { it.isNotEmpty() && !it.endsWith("\n") }
        append(if (isUnfinished) "\n" else "")
    }

    /** Returns how an earlier process ended during [rule], or null if none did. */
    fun endAt(rule: SuiteRule): ProcessEnd? = ends[rule.name]

    /** Begins a line; a rule before it that has no outcome, because the suite itself failed, keeps its own line. */
    fun begins(rule: SuiteRule) {
        append(if (isOpen) "\n$rule " else "$rule ")
        isOpen = true
    }

    fun tries(): Unit = append(TRY)

    fun shrinks(): Unit = append(STEP)

    fun ends(result: RuleResult) {
        append(" ${result.outcome} ${result.milliseconds}\n")
        isOpen = false
    }

    /** Shows progress of the current try by updating the file's time, at most once a second. */
    fun goesOn() {
        val now = System.currentTimeMillis()
        if (now - touched < SECOND) return
        touched = now
        Files.setLastModifiedTime(path, FileTime.fromMillis(now))
    }

    @Synchronized
    private fun append(text: String) {
        Files.writeString(path, text, CREATE, APPEND)
    }

    companion object {
        const val TRY: String = "."
        const val STEP: String = ","
        private const val SECOND = 1000L

        /** Appends to the journal at [path] why its process has ended. Returns false if no rule was running. */
        fun ended(path: Path, words: String, outcome: RuleOutcome): Boolean {
            val text = if (Files.exists(path)) path.readText() else ""
            if (text.isEmpty() || text.endsWith("\n")) return false
            Files.writeString(path, " ${ProcessEnd.MARK}$outcome $words\n", APPEND)
            return true
        }
    }
}

/**
 * The end of a process during the try number [tries] of [rule].
 *
 * @property outcome crashed, timed out or inconclusive
 * @property words how the process ended
 */
internal class ProcessEnd(
    val rule: String,
    val tries: Int,
    private val steps: Int,
    val outcome: RuleOutcome,
    val words: String,
) {
    /** Whether the process ended during shrinking. */
    val isShrinking: Boolean get() = steps > 0

    override fun toString(): String =
        "$rule ${Journal.TRY.repeat(tries)}${Journal.STEP.repeat(steps)} $MARK$outcome $words"

    companion object {
        const val MARK: String = "! "

        /** Parses a line of a journal; returns null if its rule has an outcome. */
        fun of(text: String): ProcessEnd? {
            val (rule, progress) = text.substringBefore(" $MARK", "").split(' ').takeIf { it.size == 2 } ?: return null
            val end = text.substringAfter(MARK).split(' ', limit = 2)
            val (outcome, words) = end.takeIf { it.size == 2 } ?: return null
            val tries = progress.count { it == Journal.TRY[0] }
            return ProcessEnd(rule, tries, progress.length - tries, RuleOutcome.valueOf(outcome), words)
        }
    }
}

/** Reads a [Journal] while a sequence of processes writes it, and calls [listener] once for each rule. */
internal class JournalFollower(private val path: Path, private val listener: RuleListener) {
    private val reported = HashSet<String>()
    private val line = StringBuilder()
    private var position = 0L
    private var since = System.nanoTime()

    /** Reads what was appended since the last call. */
    fun goOn() {
        if (!Files.exists(path) || Files.size(path) == position) return
        val news = RandomAccessFile(path.toFile(), "r").use { file ->
            file.seek(position)
            ByteArray((file.length() - position).toInt()).also { file.readFully(it) }
        }
        position += news.size
        for (byte in news) {
            when (val char = byte.toInt().toChar()) {
                '\n' -> lineEnds()
                Journal.TRY[0], Journal.STEP[0] -> Unit
                else -> line.append(char)
            }
        }
    }

    private fun lineEnds() {
        val text = line.toString()
        line.clear()

        // Without tries and steps. A rule that ended with its process has no recorded duration
        val words = text.replace(ProcessEnd.MARK, "").split(' ').filter { it.isNotEmpty() }
        val outcome = RuleOutcome.entries.firstOrNull { it.name == words.getOrNull(1) } ?: return
        val name = words[0]
        val now = System.nanoTime()
        val elapsed = (now - since) / NANOSECONDS
        since = now
        if (!reported.add(name)) return
        val rule = SuiteRule.find(name) ?: return
        listener.ended(rule, outcome, words.getOrNull(2)?.takeIf { words.size == 3 }?.toLongOrNull() ?: elapsed)
    }

    private companion object {
        const val NANOSECONDS = 1_000_000L
    }
}
