package dev.lazyz.conformance.run

import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.APPEND
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.attribute.FileTime
import kotlin.io.path.readLines
import kotlin.io.path.readText

/**
 * A file that tells at every moment how far a run of the suite has come, so that one whose process has ended can be
 * taken up by another process. Each rule has a line: its name, a dot for each try, a comma for each step to a smaller
 * frame, the outcome, and how many milliseconds it took. A line without an outcome is of the rule that was on trial
 * when the process ended; who notices writes the reason there, by [ended]. Lines are added and never changed. Thread safe.
 *
 * @property path the file; if it is there, its run is taken up
 */
internal class Journal(private val path: Path) {
    /** What ended the processes of earlier runs, by the name of the rule that was on trial. */
    private val ends: Map<String, ProcessEnd> = (if (Files.exists(path)) path.readLines() else listOf())
        .mapNotNull { ProcessEnd.of(it) }.associateBy { it.rule }

    @Volatile
    private var touched = 0L

    init {
        // All lines stay: who follows the file reads on from where it was
        val isUnfinished = Files.exists(path) && path.readText().let { it.isNotEmpty() && !it.endsWith("\n") }
        append(if (isUnfinished) "\n" else "")
    }

    /** Returns how an earlier run ended when [rule] was on trial, or null if none did. */
    fun endAt(rule: SuiteRule): ProcessEnd? = ends[rule.name]

    fun begins(rule: SuiteRule): Unit = append("$rule ")

    fun tries(): Unit = append(TRY)

    fun shrinks(): Unit = append(STEP)

    fun ends(result: RuleResult): Unit = append(" ${result.outcome} ${result.milliseconds}\n")

    /** The try under way is not stuck: the file's time says so, once a second at most. */
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

        /** Writes to the journal at [path] why the process of its run has ended; false if no rule was on trial. */
        fun ended(path: Path, words: String, outcome: RuleOutcome): Boolean {
            val text = if (Files.exists(path)) path.readText() else ""
            if (text.isEmpty() || text.endsWith("\n")) return false
            Files.writeString(path, " ${ProcessEnd.MARK}$outcome $words\n", APPEND)
            return true
        }
    }
}

/**
 * The process ended when [rule] had been tried [tries] times, the last time included.
 *
 * @property outcome crashed or timed out
 * @property words how it ended
 */
internal class ProcessEnd(
    val rule: String,
    val tries: Int,
    private val steps: Int,
    val outcome: RuleOutcome,
    val words: String,
) {
    /** Whether it ended when a smaller frame was looked for. */
    val isShrinking: Boolean get() = steps > 0

    override fun toString(): String =
        "$rule ${Journal.TRY.repeat(tries)}${Journal.STEP.repeat(steps)} $MARK$outcome $words"

    companion object {
        const val MARK: String = "! "
        private val line = Regex("""(\w+) (\.*)(,*) ! ([A-Z_]+) (.*)""")

        /** Reads a line of a journal; null if it is of a rule with an outcome. */
        fun of(text: String): ProcessEnd? {
            val (rule, tries, steps, outcome, words) = line.matchEntire(text)?.destructured ?: return null
            return ProcessEnd(rule, tries.length, steps.length, RuleOutcome.valueOf(outcome), words)
        }
    }
}
