package dev.lazyz.conformance.results

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.DateTimeException
import java.time.LocalDate

/**
 * Allows a renderer to break a rule until a date. Immutable and thread safe.
 *
 * @property rule the rule's name
 * @property reason why the rule is broken, for readers of the report
 * @property link where the problem is tracked
 * @property expires the last day on which the waiver is valid
 */
public class Waiver(
    public val rule: String,
    public val reason: String,
    public val link: String,
    public val expires: LocalDate,
) {
    override fun toString(): String = "$rule until $expires: $reason ($link)"
}

/**
 * A waivers file: blocks of four lines, in any order, with empty lines between the blocks. Lines that begin with `#`
 * are comments.
 *
 * ```
 * rule: rule_5_2_tiesGoToTheFirstSubmitted
 * reason: depths are compared in 24 bits
 * link: https://example.org/issues/7
 * expires: 2027-01-31
 * ```
 *
 * A waived rule that fails is reported but is not a failure. A waived rule that passes is a failure, and so is an
 * expired waiver, so that outdated waivers are removed. Immutable and thread safe.
 *
 * @property all all waivers in the order of the file
 */
public class Waivers private constructor(public val all: List<Waiver>) {
    /** Returns the waiver of the rule with the name [rule], or null if it has none. */
    public fun of(rule: String): Waiver? = all.firstOrNull { it.rule == rule }

    override fun toString(): String = "Waivers(${all.joinToString { it.rule }})"

    /** The lines of one block, until it is complete. */
    private class Block(private val name: String, val line: Int) {
        private val values = LinkedHashMap<String, String>()
        private val lines = HashMap<String, Int>()

        fun add(text: String, line: Int) {
            val key = text.substringBefore(':', "").trim()
            val value = text.substringAfter(':').trim()
            if (key !in KEYS) bad(name, line, "expected ${KEYS.joinToString { "'$it:'" }}: $text")
            if (value.isEmpty()) bad(name, line, "'$key:' has no value")
            if (values.put(key, value) != null) bad(name, line, "'$key:' twice in one block; is an empty line missing?")
            lines[key] = line
        }

        fun waiver(): Waiver {
            for (key in KEYS) if (key !in values) bad(name, line, "the block that begins here has no '$key:'")
            val rule = values.getValue("rule")
            if (SuiteRule.find(rule) == null) bad(name, lines.getValue("rule"), "no rule '$rule'${nearestRule(rule)}")
            val expires = try {
                LocalDate.parse(values.getValue("expires"))
            } catch (_: DateTimeException) {
                bad(name, lines.getValue("expires"), "not a date such as 2027-01-31: ${values.getValue("expires")}")
            }
            return Waiver(rule, values.getValue("reason"), values.getValue("link"), expires)
        }
    }

    public companion object {
        /** System property: the waivers file for a suite that runs as a test. */
        public const val PROPERTY: String = "lazyz.conformance.waivers"

        private val KEYS = listOf("rule", "reason", "link", "expires")

        internal fun listed(all: List<Waiver>): Waivers = Waivers(all)

        /** No waivers. */
        @JvmField
        public val NONE: Waivers = Waivers(emptyList())

        /**
         * Reads a waivers file.
         *
         * @throws WaiversException if the file cannot be read or is not valid; the message has file and line
         */
        @JvmStatic
        public fun read(path: Path): Waivers = try {
            parse(Files.readString(path), path.toString())
        } catch (e: IOException) {
            throw WaiversException("cannot read the waivers file $path: ${reason(e)}", e)
        }

        /**
         * Parses waivers from [text]; messages use [name] as the name of the source.
         *
         * @throws WaiversException as [read] does
         */
        @JvmStatic
        @JvmOverloads
        public fun parse(text: String, name: String = "<text>"): Waivers {
            val waivers = ArrayList<Waiver>()
            var block: Block? = null
            for ((i, raw) in (text.lines() + "").withIndex()) {
                val line = raw.trim()
                if (line.startsWith("#")) continue
                if (line.isNotEmpty()) {
                    if (block == null) block = Block(name, i + 1)
                    block.add(line, i + 1)
                } else if (block != null) {
                    val waiver = block.waiver()
                    if (waivers.any { it.rule == waiver.rule }) bad(name, block.line, "${waiver.rule} is waived twice")
                    waivers.add(waiver)
                    block = null
                }
            }
            return Waivers(waivers)
        }

        private fun bad(name: String, line: Int, what: String): Nothing = throw WaiversException("$name:$line: $what")

        /** Returns `; did you mean ...?` with the rules of the same number. */
        private fun nearestRule(name: String): String {
            val number = name.removePrefix("rule_").split('_').takeWhile { it.toIntOrNull() != null }.joinToString(".")
            val near = SuiteRule.matching(number).map { it.name }
            return if (near.isEmpty()) "" else "; did you mean ${near.joinToString(" or ")}?"
        }
    }
}

/** Thrown if a waivers file cannot be read or is not valid. The message has the place and the reason. */
public class WaiversException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    IllegalArgumentException(message, cause)
