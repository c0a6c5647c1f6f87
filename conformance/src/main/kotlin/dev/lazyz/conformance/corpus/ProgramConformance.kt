package dev.lazyz.conformance.corpus

import dev.lazyz.Image
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.ShellWords
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.conformance.run.Lateness
import dev.lazyz.conformance.run.Settings
import dev.lazyz.conformance.run.Shrinking
import dev.lazyz.conformance.run.smallest
import java.io.IOException
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.Callable
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import net.jqwik.api.sessions.JqwikSession

/**
 * Tests a program in any language: it is called for each scene of the corpus, see [CorpusFiles], and the pictures are
 * compared. The report has a rule for each group of scenes.
 *
 * Options that are not set have default values. The program may hang, crash, or write too much: its processes are
 * ended. Not thread safe.
 *
 * @param command what the shell runs for a scene; `{scene}` in it is the file to read, `{picture}` the one to write,
 *   and `{depth}` and `{primitive}`, which may be omitted, files for these. Exit code 3 says that the program cannot
 *   draw the scene
 * @throws IllegalArgumentException if the command does not have `{scene}` and `{picture}`
 */
public class ProgramConformance(private val command: String) {
    private var seed = SuiteRule.fixedSeed
    private var tries = 1.0
    private var deadline = Settings.USUAL_DEADLINE
    private var jobs = Runtime.getRuntime().availableProcessors()
    private val rules = LinkedHashSet<SuiteRule>()
    private var baseline: Path? = null
    private var output: Path? = null
    private var listener = RuleListener { _, _, _ -> }

    init {
        require("{scene}" in command && "{picture}" in command) {
            "the command must have {scene}, the file to read, and {picture}, the file to write: $command"
        }
    }

    /** Sets the seed of the scenes. Another seed gives other scenes than those of the corpus. */
    public fun seed(seed: Long): ProgramConformance = apply { this.seed = seed }

    /** Multiplies the number of scenes of each rule by [factor], which must be positive. */
    public fun tries(factor: Double): ProgramConformance = apply {
        require(factor > 0.0 && factor.isFinite()) { "tries must be a positive number: $factor" }
        tries = factor
    }

    /** Sets the processor time that the program may use for a scene; by default 20 seconds. */
    public fun deadline(deadline: Duration): ProgramConformance = apply {
        require(deadline > Duration.ZERO) { "the deadline must be positive: $deadline" }
        this.deadline = deadline
    }

    /** Sets how many scenes are drawn at the same time; by default one for each processor. */
    public fun jobs(jobs: Int): ProgramConformance = apply {
        require(jobs > 0) { "jobs must be positive: $jobs" }
        this.jobs = jobs
    }

    /**
     * Runs the scenes of this rule; if none is added, all.
     *
     * @throws IllegalArgumentException if the corpus has no rule with this name or number
     */
    public fun rule(nameOrNumber: String): ProgramConformance = apply {
        val found = ruleNames().zip(CorpusGroup.all).filter { (name, group) ->
            name == nameOrNumber || group.rule.number == nameOrNumber
        }
        require(found.isNotEmpty()) { "no rule '$nameOrNumber'; the rules are ${ruleNames().joinToString()}" }
        rules.addAll(found.map { it.second.rule })
    }

    /**
     * Sets a file with the result of each scene in an earlier run: scenes that failed may fail again, and it is a
     * failure if others fail, or if these pass. If there is no such file, it is written.
     */
    public fun baseline(path: Path): ProgramConformance = apply { baseline = path }

    /** Also writes the report to [folder], see [ConformanceReport.writeTo]. */
    public fun output(folder: Path): ProgramConformance = apply { output = folder }

    /** Sets a listener that is called with the outcome of each rule as soon as it is known. */
    public fun listener(listener: RuleListener): ProgramConformance = apply { this.listener = listener }

    /**
     * Runs the program for all scenes, and returns the results.
     *
     * @throws IOException if the baseline or the output folder cannot be read or written
     * @throws IllegalArgumentException if the baseline is not one
     */
    @Throws(IOException::class)
    public fun run(): ConformanceReport {
        val start = System.nanoTime()
        val known = baseline?.let { Baseline.read(it) }
        val program = Program(command, deadline)
        val pool = Executors.newFixedThreadPool(jobs) { task -> Thread(task, "lazyz-jobs").apply { isDaemon = true } }
        val verdicts = LinkedHashMap<String, SceneResult>()
        val results = try {
            CorpusFiles.cases(rules, seed, tries).groupBy { it.group }.map { (group, cases) ->
                val judge = RuleJudge(program, group.rule, name(), known)
                judge.result(cases, pool, verdicts).also { listener.ended(group.rule, it.outcome, it.milliseconds) }
            }
        } finally {
            pool.shutdownNow()
        }
        if (known == null) baseline?.let { Baseline.write(it, command, verdicts) }
        val milliseconds = (System.nanoTime() - start) / NANOSECONDS
        val settings = Settings(tries, seed, Waivers.NONE, Shrinking.ON, deadline, null)
        val words = "zcli conformance --program ${ShellWords.quoted(command)}"
        val info = StrategyInfo(name(), command)
        val report = settings.report(info, words, results, milliseconds, isOnDisk = output != null)
        output?.let { report.writeTo(it) }
        return report
    }

    /** The command without the files. */
    private fun name(): String = command.split(' ').filter { it.isNotEmpty() && '{' !in it }.joinToString(" ")

    override fun toString(): String = "ProgramConformance($command)"

    public companion object {
        private const val NANOSECONDS = 1_000_000L

        /** The names of the rules, in the order of difficulty. */
        @JvmStatic
        public fun ruleNames(): List<String> = CorpusGroup.all.map { it.rule.name }
    }
}

/** The result of a scene, with its [words] in a baseline. */
internal enum class SceneResult(val words: String) {
    /** Equal, bit for bit. */
    EXACT("exact"),

    /** Equal within the tolerance of the scene. */
    WITHIN("within"),
    WRONG("wrong"),
    CRASHED("crashed"),
    TIMED_OUT("timed out"),
    NOT_SUPPORTED("not supported"),

    /** The machine was too busy to tell. */
    INCONCLUSIVE("inconclusive"),

    /** Not drawn, because another scene of the rule was late. */
    NOT_RUN("not run"),
    ;

    val isRight: Boolean get() = this == EXACT || this == WITHIN

    val isFailure: Boolean get() = this == WRONG || this == CRASHED || this == TIMED_OUT

    companion object {
        fun of(drawing: Drawing, scene: CorpusScene): SceneResult = when (drawing) {
            is Drawing.Picture -> when {
                difference(scene.expected, drawing.image) == null -> EXACT
                difference(scene.expected, scene.tolerated(drawing.image)) == null -> WITHIN
                else -> WRONG
            }

            is Drawing.NotSupported -> NOT_SUPPORTED

            is Drawing.Failed -> if (drawing.isCrash) CRASHED else WRONG

            is Drawing.Late -> if (drawing.lateness == Lateness.UNKNOWN) INCONCLUSIVE else TIMED_OUT
        }
    }
}

/** Judges a [program], called [name] in messages, by the scenes of a [rule]. */
private class RuleJudge(
    private val program: Program,
    private val rule: SuiteRule,
    private val name: String,
    private val known: Map<String, SceneResult>?,
) {
    private val start = System.nanoTime()

    @Volatile
    private var isLate = false

    /** Draws all scenes in [pool], and adds what became of them to [verdicts]. */
    fun result(
        cases: List<CorpusCase>,
        pool: ExecutorService,
        verdicts: MutableMap<String, SceneResult>,
    ): RuleResult {
        val drawings = cases.map { case -> pool.submit(Callable { drawing(case) }) }.map { it.get() }
        val results = cases.zip(drawings).associate { (case, drawing) ->
            case to (drawing?.let { SceneResult.of(it, case.scene) } ?: SceneResult.NOT_RUN)
        }
        for ((case, result) in results) verdicts[case.name] = result
        val failed = results.filter { it.value.isFailure }.keys
        val isKnown = { case: CorpusCase -> known?.get(case.name)?.isFailure == true }
        val new = failed.filterNot(isKnown)
        val passing = results.filter { it.value.isRight && isKnown(it.key) }.keys
        val shown = new.firstOrNull() ?: failed.firstOrNull()
        val drawing = shown?.let { drawings[cases.indexOf(it)] }
        val isFlaky = shown in new && shown != null && isFlaky(shown, results.getValue(shown))
        val outcome = when {
            isFlaky -> RuleOutcome.FLAKY
            new.isNotEmpty() -> outcome(results.getValue(new.first()))
            passing.isNotEmpty() -> RuleOutcome.WAIVED_BUT_PASSES
            SceneResult.INCONCLUSIVE in results.values -> RuleOutcome.INCONCLUSIVE
            failed.isNotEmpty() -> RuleOutcome.WAIVED
            results.values.all { it == SceneResult.NOT_SUPPORTED } -> RuleOutcome.NOT_SUPPORTED
            else -> RuleOutcome.PASSED
        }
        val counts = SceneResult.entries.associateWith { kind -> results.values.count { it == kind } }
            .filterValues { it > 0 }.entries.joinToString { "${it.value} ${it.key.words}" }
        val names = listOf("failed before" to failed.filter(isKnown), "new failures" to new, "new passes" to passing)
            .filter { known != null && it.second.isNotEmpty() }
            .joinToString("") { (what, list) -> "; $what: ${list.joinToString { it.name }}" }
        val census = Census()
        for (case in cases) census.add(case.scene.frame, case.scene.scene)
        return RuleResult(
            rule, outcome, counts + names, cases.size, (System.nanoTime() - start) / NANOSECONDS,
            census.distribution(), if (drawing == null) null else failure(shown, drawing, isFlaky),
        )
    }

    private fun drawing(case: CorpusCase): Drawing? {
        if (isLate) return null
        val drawing = program.draw(case.scene, case.json())
        if (drawing is Drawing.Late) isLate = true
        return drawing
    }

    private fun isFlaky(case: CorpusCase, first: SceneResult): Boolean = first != SceneResult.TIMED_OUT &&
        SceneResult.of(program.draw(case.scene, case.json()), case.scene) != first

    private fun outcome(result: SceneResult): RuleOutcome = when (result) {
        SceneResult.CRASHED -> RuleOutcome.CRASHED
        SceneResult.TIMED_OUT -> RuleOutcome.TIMED_OUT
        else -> RuleOutcome.FAILED
    }

    /** Returns how the program fails, for the smallest scene that it fails on, unless it is slow or flaky. */
    private fun failure(case: CorpusCase, drawing: Drawing, isFlaky: Boolean): RuleFailure? {
        val first = violation(case, case.scene, drawing) ?: return null
        if (isFlaky || drawing is Drawing.Late) return RuleFailure.of(first, emptyList())
        var last: Violation = first
        JqwikSession.run {
            last = smallest(case.shrinkable, first, STEPS) { scene ->
                val json = scene.json(case.group.members(case.name))
                program.draw(scene, json).takeUnless { it is Drawing.Late }?.let { violation(case, scene, it) }
            }.second
        }
        return RuleFailure.of(last, emptyList(), first)
    }

    /** Returns what is wrong with [drawing]; null if nothing is. */
    private fun violation(case: CorpusCase, scene: CorpusScene, drawing: Drawing): Violation? {
        val json = scene.json(case.group.members(case.name))
        val frame = FrameCase(scene.frame, json, scene.scene, json)
        val right = scene.expected
        fun violation(what: String, actual: Image?) =
            Violation("$name: $what\nin\n$json", frame, actual?.let { right }, actual)
        return when (drawing) {
            is Drawing.NotSupported -> null

            is Drawing.Failed -> violation(drawing.message, null)

            is Drawing.Late -> violation(drawing.message, null)

            is Drawing.Picture -> {
                val actual = scene.tolerated(drawing.image)
                difference(right, actual)?.let { violation("$it", actual) }
            }
        }
    }

    private companion object {
        const val NANOSECONDS = 1_000_000L

        /** Most scenes that are drawn to find a smaller one. */
        const val STEPS = 100
    }
}
