package dev.lazyz.conformance.report

import dev.lazyz.Capability
import dev.lazyz.Renderer
import dev.lazyz.conformance.census.Distribution
import dev.lazyz.conformance.results.Diagnosis
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waiver
import dev.lazyz.conformance.rules.ConformanceVersions
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.strategies.Renderers
import java.io.File
import java.io.IOException
import java.nio.file.Path
import java.util.Locale

/**
 * The result of a run of the suite: evidence that a renderer conforms, or the reasons why it does not.
 *
 * Two runs with the same options differ only in times. Immutable and thread safe.
 *
 * @property strategy the renderer that was tested
 * @property seed the suite's seed, from which the seeds of all rules are computed
 * @property tries factor of the default number of frames
 * @property waivers all given waivers, including those of rules that were not run
 * @property results the result of each rule that was run, ordered by number
 * @property milliseconds duration of the run
 * @param isOnDisk whether the run has written the report to a folder
 */
public class ConformanceReport internal constructor(
    public val strategy: StrategyInfo,
    public val seed: Long,
    public val tries: Double,
    public val waivers: List<Waiver>,
    private val command: String?,
    public val results: List<RuleResult>,
    public val milliseconds: Long,
    private val isOnDisk: Boolean,
) {
    /** The suite's version, see [ConformanceVersions]. */
    public val suiteVersion: String get() = ConformanceVersions.SUITE

    /**
     * Version of Java, name of the virtual machine, and whether it has the Vector API: without it, loops of a renderer
     * that use it were not tested.
     */
    public val jvm: String = "${System.getProperty("java.version")}, ${System.getProperty("java.vm.name")}, " +
        (if (ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent) "with" else "without") + " the Vector API"

    /** The operating system and the processor architecture. */
    public val os: String = "${System.getProperty("os.name")} ${System.getProperty("os.arch")}"

    /** Traits of the frames of all rules. */
    public val distribution: Distribution = results.fold(Distribution.NONE) { sum, it -> sum + it.distribution }

    /** The broken rules that are most likely related to the mistake. */
    internal val diagnosis: Diagnosis = Diagnosis.of(results)

    /** The results to describe in detail: the likely causes first, then the others, ordered by number. */
    internal val detailed: List<RuleResult> = results.filter { it.outcome.isDetailed }.sortedBy { result ->
        diagnosis.causes.indexOfFirst { it.rule == result.rule }.let { if (it < 0) Int.MAX_VALUE else it }
    }

    /** Whether no rule's outcome is a failure, and none is inconclusive. */
    public val isConformant: Boolean get() = results.none { it.outcome.isFailure } && !isInconclusive

    /** Whether no rule's outcome is a failure, but some are inconclusive: the run neither proves nor disproves it. */
    public val isInconclusive: Boolean
        get() = results.none { it.outcome.isFailure } && withOutcome(RuleOutcome.INCONCLUSIVE).isNotEmpty()

    /** Returns the results with the given [outcome]. */
    public fun withOutcome(outcome: RuleOutcome): List<RuleResult> = results.filter { it.outcome == outcome }

    /** Returns a shell command that repeats [rule] as in this run. */
    public fun commandFor(rule: SuiteRule): String {
        val strategyId = ShellWords.quoted(strategy.id)
        val words = command ?: ("zcli conformance --strategy $strategyId" + strategy.classPath())
        return "$words --seed $seed --tries ${plain(tries)} --rule ${rule.name}"
    }

    /**
     * Returns a summary for people: the verdict, the likely causes, the first failures with the beginning of their
     * messages, a line per rule, and the verdict again. At most about 150 lines, however many rules are broken. Names
     * files of failures only if the run has written the report to a folder.
     */
    public fun toText(): String = ReportText(this, isOnDisk).text()

    /** Returns the whole report except pictures as JSON. `docs/conformance.md` describes the keys. */
    public fun toJson(): String = ReportJson(this).text()

    /** Returns the report in the XML format that build servers read, with one test case per rule. */
    public fun toJUnitXml(): String = ReportJUnit(this).text()

    /**
     * Returns the report as one HTML page that contains the pictures of failures. It needs no other files and no
     * scripts.
     */
    public fun toHtml(): String = ReportHtml(this).text()

    /**
     * Writes `report.txt`, `report.json`, `report.html` and `TEST-lazyz-conformance.xml` to [folder], which is created
     * if it does not exist. For each broken rule, the subfolder `failures` gets the frame as `RULE.kt`, pictures as
     * `RULE-expected.png`, `-actual.png` and `-difference.png`, and the frame as a scene file `RULE.json`, if that
     * format can express it. Such files of an earlier run are replaced or removed. Each file is written completely or
     * not at all.
     *
     * @throws IOException if a file cannot be written
     */
    @Throws(IOException::class)
    public fun writeTo(folder: Path): Unit = ReportFiles(this, folder).write()

    override fun toString(): String = "ConformanceReport(${strategy.id}, ${ReportText(this).verdict()})"

    internal companion object {
        fun versionOf(type: Class<*>): String = type.`package`?.implementationVersion ?: "unknown"

        /** Formats a number without an unnecessary fraction. */
        fun plain(number: Double): String =
            if (number % 1.0 == 0.0 && number < 1e15) number.toLong().toString() else number.toString()
    }
}

/**
 * The renderer of a report. Immutable and thread safe.
 *
 * @property id its id
 * @property className its class; of a program, the command that calls it
 * @property version version of its jar, according to the manifest, or `unknown`
 * @property capabilities the capabilities that it declares, in the order of [Capability]
 */
public class StrategyInfo private constructor(
    public val id: String,
    public val className: String,
    public val version: String,
    public val capabilities: List<Capability>,
    private val place: String?,
) {
    internal constructor(renderer: Renderer) : this(
        answer("unknown") { renderer.id },
        renderer.javaClass.name,
        ConformanceReport.versionOf(renderer.javaClass),
        answer(emptyList()) { renderer.capabilities.sorted() },
        placeOf(renderer.javaClass),
    )

    /** A program that is called by [command]. */
    internal constructor(name: String, command: String) : this(name, command, "unknown", emptyList(), null)

    /** Returns the options with which `zcli` finds the class, with a leading blank; empty for built-in renderers. */
    internal fun classPath(): String = if (place == null) "" else " --classpath ${ShellWords.quoted(place)}"

    override fun toString(): String = "$id ($className, version $version)"

    private companion object {
        /** If a renderer throws here, uses a default; the rules report the failure. */
        fun <T> answer(otherwise: T, question: () -> T): T = try {
            question()
        } catch (_: Throwable) {
            otherwise
        }

        fun placeOf(type: Class<*>): String? = when {
            Renderers.builtIn.any { it.javaClass == type } -> null
            else -> type.protectionDomain?.codeSource?.location?.takeIf { it.protocol == "file" }
                ?.let { File(it.toURI()).path }
        }
    }
}

/** A report as the XML that build servers read: a test suite with a test case for each rule. */
internal class ReportJUnit(private val report: ConformanceReport) {
    fun text(): String = buildString {
        val failures = report.results.count { it.outcome.isFailure }
        val errors = report.withOutcome(RuleOutcome.INCONCLUSIVE).size
        val skipped = report.results.count { isSkipped(it) }
        appendLine("""<?xml version="1.0" encoding="UTF-8"?>""")
        appendLine(
            """<testsuite name="${suite()}" tests="${report.results.size}" failures="$failures" errors="$errors" """ +
                """skipped="$skipped" time="${seconds(report.milliseconds)}">""",
        )
        properties()
        for (result in report.results) case(result)
        appendLine("</testsuite>")
    }

    private fun suite() = escaped("dev.lazyz.conformance.${report.strategy.id}")

    private fun StringBuilder.properties() {
        val causes = report.diagnosis.causes.withIndex().associate { (i, it) -> "likely.cause.${i + 1}" to "$it" }
        val properties = mapOf("verdict" to ReportText(report).verdict()) + causes + mapOf(
            "suite.version" to report.suiteVersion,
            "contract.version" to ConformanceVersions.CONTRACT,
            "strategy.class" to report.strategy.className,
            "strategy.version" to report.strategy.version,
            "capabilities" to report.strategy.capabilities.joinToString(",") { it.name },
            "java" to report.jvm,
            "os" to report.os,
            "seed" to "${report.seed}",
            "tries" to ConformanceReport.plain(report.tries),
        )
        appendLine("  <properties>")
        for ((name, value) in properties) appendLine("""    <property name="$name" value="${escaped(value)}"/>""")
        appendLine("  </properties>")
    }

    private fun StringBuilder.case(result: RuleResult) {
        append("""  <testcase classname="${suite()}" name="${escaped(result.rule.name)}" """)
        append("""time="${seconds(result.milliseconds)}"""")
        when {
            result.outcome.isFailure || result.outcome == RuleOutcome.INCONCLUSIVE -> {
                val element = if (result.outcome.isFailure) "failure" else "error"
                appendLine(">")
                append("""    <$element type="${result.outcome.words}" """)
                append("""message="${escaped(result.message.lineSequence().first())}">""")
                appendLine("${escaped(details(result))}</$element>")
                appendLine("  </testcase>")
            }

            isSkipped(result) -> {
                appendLine(">")
                appendLine("""    <skipped message="${escaped(skipped(result))}"/>""")
                appendLine("  </testcase>")
            }

            else -> appendLine("/>")
        }
    }

    private fun skipped(result: RuleResult): String =
        if (result.outcome == RuleOutcome.NOT_FOLLOWED) "not followed: ${details(result)}" else result.message

    private fun details(result: RuleResult): String = listOfNotNull(
        result.message,
        result.failure?.message?.takeIf { it != result.message },
        "why: ${result.rule.intent}",
        "look at: ${result.look}",
        "reproduce: ${report.commandFor(result.rule)}",
    ).joinToString("\n")

    /** Neither passed nor failed, for a known reason. */
    private fun isSkipped(result: RuleResult): Boolean = !result.outcome.isFailure &&
        result.outcome != RuleOutcome.PASSED && result.outcome != RuleOutcome.INCONCLUSIVE

    private fun seconds(milliseconds: Long): String = "%.3f".format(Locale.ROOT, milliseconds / 1000.0)
}

/** Words of commands that a message or a report contains. Thread safe. */
public object ShellWords {
    /** What means something to a shell. */
    private const val SPECIAL = " \t\n\"'\\$&|;<>()*?[]{}!~#`"

    /** Returns [word] as it is typed in a POSIX shell: in quotes if it is empty or contains special characters. */
    @JvmStatic
    public fun quoted(word: String): String =
        if (word.isEmpty() || word.any { it in SPECIAL }) "'${word.replace("'", "'\\''")}'" else word
}
