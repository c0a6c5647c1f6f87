package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.conformance.run.Journal
import dev.lazyz.conformance.run.LastWords
import dev.lazyz.conformance.run.Late
import dev.lazyz.conformance.run.OwnFrames
import dev.lazyz.conformance.run.RunUnderWay
import dev.lazyz.conformance.run.Settings
import dev.lazyz.conformance.run.Shrinking
import dev.lazyz.conformance.run.Supervisor
import dev.lazyz.conformance.run.TryThread
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ThreadLocalRandom
import java.util.function.Supplier

/**
 * Runs the conformance suite in this process and returns a report.
 *
 * Use it to judge a renderer from a program of one's own; as a test of a build, extend [RendererConformance]. What is
 * not said is as the suite's system properties have it, or usual. Kotlin:
 *
 * ```
 * val report = Conformance { MyRenderer() }.tries(0.1).output(Path.of("report")).run()
 * check(report.isConformant) { report.toText() }
 * ```
 *
 * The same options give the same report but for times. There can be one run at a time in a process; nothing is printed.
 * Not thread safe. Cost: a few seconds a run.
 *
 * @param renderer makes the renderer to judge, a new one or always the same; called once for each try of each rule
 */
public class Conformance(private val renderer: Supplier<out Renderer>) {
    private var subject: Class<out RendererConformance> = SubjectOfRun::class.java
    private var shrinking = Shrinking.ON
    private var seed: Long? = null
    private var tries: Double? = null
    private val rules = LinkedHashSet<SuiteRule>()
    private var waivers: Waivers? = null
    private var deadline: Duration? = null
    private var frames: Path? = null
    private var output: Path? = null
    private var command: String? = null
    private var journal: Path? = null
    private var listener = RuleListener { _, _, _ -> }

    /** Chooses other frames than the usual. */
    public fun seed(seed: Long): Conformance = apply { this.seed = seed }

    /** Chooses frames that nobody has seen, by a random seed that the report tells. */
    public fun explore(): Conformance = seed(ThreadLocalRandom.current().nextLong(0, Int.MAX_VALUE.toLong()))

    /**
     * Tries [factor] times as many frames as usual.
     *
     * @throws IllegalArgumentException if it is not positive and finite
     */
    public fun tries(factor: Double): Conformance = apply {
        require(factor > 0.0 && factor.isFinite()) { "tries must be a positive number: $factor" }
        tries = factor
    }

    /**
     * Gives each rendering so much time, by default 20 seconds. A rule of which one takes longer has timed out; when three
     * have, no others are tried.
     *
     * @throws IllegalArgumentException if it is not positive
     */
    public fun deadline(deadline: Duration): Conformance = apply {
        require(deadline > Duration.ZERO) { "the deadline must be positive: $deadline" }
        this.deadline = deadline
    }

    /**
     * Runs this rule, and no others but those that are named too.
     *
     * @param nameOrNumber a [SuiteRule.name], or a [SuiteRule.number] for all rules of that number
     * @throws IllegalArgumentException if there is no such rule
     */
    public fun rule(nameOrNumber: String): Conformance = apply {
        val found = SuiteRule.matching(nameOrNumber)
        require(found.isNotEmpty()) { "no rule '$nameOrNumber'" }
        rules.addAll(found)
    }

    /**
     * Waives what the file at [path] says, see [Waivers].
     *
     * @throws WaiversException if it cannot be read or is not what it should be
     */
    public fun waivers(path: Path): Conformance = waivers(Waivers.read(path))

    /** Waives these rules. */
    public fun waivers(waivers: Waivers): Conformance = apply { this.waivers = waivers }

    /**
     * Tries the scene files and meshes in [folder] too, by the rule `rule_7_1_framesOfOnesOwnAreRight`, each as a whole and
     * in part, and adds to the folder, which is made if it is not there, each frame that a rule fails on, as a scene file
     * where there are words for it. That rule is tried before all others. Files that are no scenes are left alone.
     */
    public fun frames(folder: Path): Conformance = apply { frames = folder }

    /** Writes the report to [folder] too, as [ConformanceReport.writeTo] does. */
    public fun output(folder: Path): Conformance = apply { output = folder }

    /**
     * Keeps a journal in the file at [path], by which a process that runs the suite again, with the same options, takes
     * up a run whose process has ended: it tells that the rule on trial has crashed or timed out, and tries the others.
     * [Supervision] starts such processes.
     */
    public fun journal(path: Path): Conformance = apply { journal = path }

    /**
     * Says how a reader of the report repeats the run: [words] for a shell, to which seed, tries and rule are added.
     * By default `zcli conformance` with the renderer's id, and the class path that its class comes from.
     */
    public fun command(words: String): Conformance = apply { command = words }

    /** Tells [listener] what came of each rule as soon as it has been tried. */
    public fun listener(listener: RuleListener): Conformance = apply { this.listener = listener }

    /** Judges by this class, which says itself which renderer. */
    internal fun subject(subject: Class<out RendererConformance>): Conformance = apply { this.subject = subject }

    /** Leaves frames that fail as they are. */
    internal fun withoutShrinking(): Conformance = apply { shrinking = Shrinking.OFF }

    /**
     * Runs the suite and returns what came of it. A renderer that breaks rules, or throws when it is made or renders in
     * a try, is told in the report. What is thrown when the first is made or asked what it is, before any try, reaches
     * the caller as it is.
     *
     * @throws IllegalStateException if a run is under way in this process, or the suite itself fails
     * @throws IllegalArgumentException if a system property of the suite is not what it should be
     * @throws NotMadeException if the first renderer is not made, and has not said what it is, within the deadline
     * @throws FramesException if there is a folder of frames, and it or a file in it cannot be read
     * @throws java.io.IOException if there is an output folder, and it cannot be written
     */
    public fun run(): ConformanceReport {
        val settings = Settings(
            tries ?: Settings.tries(),
            seed ?: Settings.seed() ?: SuiteRule.fixedSeed,
            waivers ?: Settings.waivers(),
            shrinking,
            deadline ?: Settings.deadline(),
            (frames ?: Settings.frames())?.let { OwnFrames(it) },
        )

        Supervisor.follow()

        // A file that cannot be read is told before any rule is tried
        settings.frames?.cases
        val chosen = SuiteRule.all.filter { rules.isEmpty() || it in rules }
        val judged = judged(settings.deadline)
        val start = System.nanoTime()
        val results = RunUnderWay(renderer, subject, chosen, settings, journal?.let { Journal(it) }, listener).execute()
        val milliseconds = (System.nanoTime() - start) / NANOSECONDS
        val report = settings.report(judged, command, results, milliseconds)
        output?.let { report.writeTo(it) }
        return report
    }

    /** Makes the first renderer and asks it what it is. Who ends the process there, or hangs, is told of. */
    private fun judged(deadline: Duration): StrategyInfo = TryThread(deadline).use { thread ->
        LastWords.keep()
        LastWords.isMaking = true
        try {
            thread.call { StrategyInfo(renderer.get()) }
        } catch (late: Late) {
            throw NotMadeException("making the renderer ${late.message}")
        } finally {
            LastWords.isMaking = false
        }
    }

    private companion object {
        const val NANOSECONDS = 1_000_000L
    }
}
