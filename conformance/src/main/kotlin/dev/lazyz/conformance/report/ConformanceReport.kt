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
import dev.lazyz.strategies.Renderers
import java.io.File
import java.nio.file.Path

/**
 * What came of a run of the suite: everything one hands over to show that a renderer conforms, or why it does not.
 *
 * Two runs with the same options differ in times only. Immutable and thread safe.
 *
 * @property strategy which renderer was judged
 * @property seed the seed of all rules' frames
 * @property tries how many times the usual frames were tried
 * @property waivers the waivers that were given, those of rules that were not run included
 * @property results what came of each rule that was run, by number
 * @property milliseconds how long it took
 */
public class ConformanceReport internal constructor(
    public val strategy: StrategyInfo,
    public val seed: Long,
    public val tries: Double,
    public val waivers: List<Waiver>,
    private val command: String?,
    public val results: List<RuleResult>,
    public val milliseconds: Long,
) {
    /** The suite's version, see [ConformanceVersions]. */
    public val suiteVersion: String get() = ConformanceVersions.SUITE

    /** Java's version and the name of its machine. */
    public val jvm: String = "${System.getProperty("java.version")}, ${System.getProperty("java.vm.name")}"

    /** The operating system and the kind of processor. */
    public val os: String = "${System.getProperty("os.name")} ${System.getProperty("os.arch")}"

    /** What the frames of all rules were like. */
    public val distribution: Distribution = results.fold(Distribution.NONE) { sum, it -> sum + it.distribution }

    /** Which of the rules that are broken are most likely about the mistake. */
    internal val diagnosis: Diagnosis = Diagnosis.of(results)

    /** The likely causes first, then the others, by number. */
    internal val told: List<RuleResult> = results.filter { it.outcome.isTold }.sortedBy { result ->
        diagnosis.causes.indexOfFirst { it.rule == result.rule }.let { if (it < 0) Int.MAX_VALUE else it }
    }

    /** Whether no rule's outcome is a failure. */
    public val isConformant: Boolean get() = results.none { it.outcome.isFailure }

    /** Returns the results with the given [outcome]. */
    public fun withOutcome(outcome: RuleOutcome): List<RuleResult> = results.filter { it.outcome == outcome }

    /** Returns a line for a shell that repeats [rule] as it was tried here. */
    public fun commandFor(rule: SuiteRule): String {
        val words = command ?: ("zcli conformance --strategy ${strategy.id}" + strategy.classPath())
        return "$words --seed $seed --tries ${plain(tries)} --rule ${rule.name}"
    }

    /**
     * Returns a summary for people: the verdict, the likely cause, the first failures with the beginning of their
     * messages, a line a rule, and the verdict again. Some 150 lines at most, however many rules are broken.
     */
    public fun toText(): String = ReportText(this).text()

    /** Returns all of it but the pictures as JSON; `docs/conformance.md` describes the keys. */
    public fun toJson(): String = ReportJson(this).text()

    /** Returns it in the form that build servers read: one test case a rule. */
    public fun toJUnitXml(): String = ReportJUnit(this).text()

    /** Returns one page, with the pictures of failures in it, that needs no other file and no script. */
    public fun toHtml(): String = ReportHtml(this).text()

    /**
     * Writes `report.txt`, `report.json`, `report.html` and `TEST-lazyz-conformance.xml` to [folder], which is made if
     * it is not there; and to its folder `failures`, for each rule that is broken, the frame as `RULE.kt`, pictures as
     * `RULE-expected.png`, `-actual.png` and `-difference.png`, and `RULE.json`, the frame as a scene file, unless a
     * scene file has no words for it. What an earlier run left of these is replaced or removed. Each file is written
     * whole or not at all.
     *
     * @throws java.io.IOException if a file cannot be written
     */
    public fun writeTo(folder: Path): Unit = ReportFiles(this, folder).write()

    override fun toString(): String = "ConformanceReport(${strategy.id}, ${ReportText(this).verdict()})"

    internal companion object {
        fun versionOf(type: Class<*>): String = type.`package`?.implementationVersion ?: "unknown"

        /** A number as one would type it. */
        fun plain(number: Double): String =
            if (number % 1.0 == 0.0 && number < 1e15) number.toLong().toString() else number.toString()
    }
}

/**
 * Which renderer a report is about. Immutable and thread safe.
 *
 * @property id its id
 * @property className the class that implements it
 * @property version that of the jar it comes from, by its manifest, or `unknown`
 * @property capabilities what it declares, in the order of [Capability]
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

    /** The options by which `zcli` finds the class, with a blank before; empty for the library's own. */
    internal fun classPath(): String = if (place == null) "" else " --classpath ${quoted(place)}"

    override fun toString(): String = "$id ($className, version $version)"

    private companion object {
        /** A renderer that cannot say what it is has the rules to tell so. */
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

        fun quoted(word: String): String = if (word.any { it.isWhitespace() }) "'$word'" else word
    }
}
