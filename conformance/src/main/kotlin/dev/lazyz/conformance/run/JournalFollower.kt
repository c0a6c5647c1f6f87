package dev.lazyz.conformance.run

import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import java.io.RandomAccessFile
import java.nio.file.Files
import java.nio.file.Path

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
