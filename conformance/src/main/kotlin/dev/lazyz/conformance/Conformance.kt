package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.probes.SettingsBefore
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.conformance.results.WaiversException
import dev.lazyz.conformance.run.ExitMessage
import dev.lazyz.conformance.run.FrameFolder
import dev.lazyz.conformance.run.FramesException
import dev.lazyz.conformance.run.Journal
import dev.lazyz.conformance.run.Late
import dev.lazyz.conformance.run.Lateness
import dev.lazyz.conformance.run.RunUnderWay
import dev.lazyz.conformance.run.Settings
import dev.lazyz.conformance.run.Shrinking
import dev.lazyz.conformance.run.Supervisor
import dev.lazyz.conformance.run.TryThread
import java.io.IOException
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ThreadLocalRandom
import java.util.function.Supplier

/**
 * Runs the conformance suite in this process and returns a report.
 *
 * Use this class to test a renderer from a program. For a test in a build, extend [RendererConformance] instead.
 * Options that are not set come from the suite's system properties, or else have default values. Kotlin:
 *
 * ```
 * val report = Conformance { MyRenderer() }.tries(0.1).output(Path.of("report")).run()
 * check(report.isConformant) { report.toText() }
 * ```
 *
 * The same options give the same report, except for times. Only one run at a time is possible in a process. Nothing is
 * printed. Not thread safe. Cost: ten to thirty seconds per run.
 *
 * @param renderer returns the renderer to test: either a new instance or always the same one; called once for each try
 *   of each rule
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

    /** Sets the seed of the frames. Another seed gives other frames than the default one. */
    public fun seed(seed: Long): Conformance = apply { this.seed = seed }

    /** Chooses new frames by a random seed. The report contains the seed. */
    public fun explore(): Conformance = seed(ThreadLocalRandom.current().nextLong(0, Int.MAX_VALUE.toLong()))

    /**
     * Multiplies the default number of frames by [factor].
     *
     * @throws IllegalArgumentException if [factor] is not positive and finite
     */
    public fun tries(factor: Double): Conformance = apply {
        require(factor > 0.0 && factor.isFinite()) { "tries must be a positive number: $factor" }
        tries = factor
    }

    /**
     * Sets the deadline of each rendering, as processor time of its busiest thread; by default 20 seconds. A rule with
     * a rendering that takes longer has timed out, also if no thread runs for as long. If ten times as long passes on
     * the clock on the wall, the rule is inconclusive: the machine has too much other work. After three such rules, the
     * remaining rules are not run.
     *
     * @throws IllegalArgumentException if [deadline] is not positive
     */
    public fun deadline(deadline: Duration): Conformance = apply {
        require(deadline > Duration.ZERO) { "the deadline must be positive: $deadline" }
        this.deadline = deadline
    }

    /**
     * Runs this rule. Only rules added by this function are run; if none is added, all are.
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
     * Uses the waivers in the file at [path], see [Waivers].
     *
     * @throws WaiversException if the file cannot be read or is not valid
     */
    public fun waivers(path: Path): Conformance = waivers(Waivers.read(path))

    /** Uses these waivers. */
    public fun waivers(waivers: Waivers): Conformance = apply { this.waivers = waivers }

    /**
     * Also tests the scene files and meshes in [folder], each as a whole and in part, with the rule
     * `rule_7_1_userFramesAreDrawnCorrectly`. This rule is run before all others. Each frame on which a rule fails is
     * added to the folder as a scene file, if the scene file format can express it. The folder is created if it does
     * not exist. Files that are not scenes are ignored.
     */
    public fun frames(folder: Path): Conformance = apply { frames = folder }

    /** Also writes the report to [folder], see [ConformanceReport.writeTo]. */
    public fun output(folder: Path): Conformance = apply { output = folder }

    /**
     * Keeps a journal in the file at [path]. If the process ends during the run, another process with the same options
     * and journal can continue it: it reports the rule that was running as crashed or timed out, and runs the other
     * rules. [Supervision] starts such processes.
     */
    public fun journal(path: Path): Conformance = apply { journal = path }

    /**
     * Sets the shell command with which a reader of the report repeats the run. Seed, tries and rule are appended to
     * [words]. By default, it is `zcli conformance` with the renderer's id and the class path of its class.
     */
    public fun command(words: String): Conformance = apply { command = words }

    /** Sets a listener that is called with the outcome of each rule as soon as the rule has ended. */
    public fun listener(listener: RuleListener): Conformance = apply { this.listener = listener }

    /** Uses this test class, which supplies its own renderer. */
    internal fun subject(subject: Class<out RendererConformance>): Conformance = apply { this.subject = subject }

    /** Disables shrinking: frames that fail are reported unchanged. */
    internal fun withoutShrinking(): Conformance = apply { shrinking = Shrinking.OFF }

    /**
     * Runs the suite and returns the results. If a renderer breaks rules, or throws when it is created or renders in a
     * try, the report contains the failure. Exceptions thrown while the first renderer is created or queried, before
     * any try, are passed to the caller unchanged.
     *
     * @throws IllegalStateException if a run is in progress in this process, or the suite itself fails
     * @throws IllegalArgumentException if a system property of the suite is not valid
     * @throws NotMadeException if the first renderer cannot be created and queried within the deadline
     * @throws FramesException if there is a folder of frames, and the folder or a file in it cannot be read
     * @throws IOException if there is an output folder, and it cannot be written
     * @throws InterruptedException if the calling thread is interrupted
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun run(): ConformanceReport {
        val settings = Settings(
            tries ?: Settings.tries(),
            seed ?: Settings.seed() ?: SuiteRule.fixedSeed,
            waivers ?: Settings.waivers(),
            shrinking,
            deadline ?: Settings.deadline(),
            (frames ?: Settings.frames())?.let { FrameFolder(it) },
        )

        Supervisor.follow()

        // With a journal, the process is the suite's own, and nobody else changes its settings
        val settingsBefore = journal?.let { SettingsBefore() }

        // Read the user's frames now, so that an unreadable file is reported before any rule is run
        settings.frames?.cases
        val chosen = SuiteRule.all.filter { rules.isEmpty() || it in rules }
        val judged = judged(settings.deadline)
        val start = System.nanoTime()
        val run = RunUnderWay(
            renderer, subject, chosen, settings, journal?.let { Journal(it) }, listener, settingsBefore,
        )
        val results = run.execute()
        val milliseconds = (System.nanoTime() - start) / NANOSECONDS
        val report = settings.report(judged, command, results, milliseconds, isOnDisk = output != null)
        output?.let { report.writeTo(it) }
        return report
    }

    /** Creates the first renderer and queries its properties. If it ends the process or hangs, that is reported. */
    private fun judged(deadline: Duration): StrategyInfo = TryThread(deadline).use { thread ->
        ExitMessage.keep()
        ExitMessage.isMaking = true
        try {
            thread.call { StrategyInfo(renderer.get()) }
        } catch (late: Late) {
            throw NotMadeException("making the renderer ${late.message}", late.lateness == Lateness.UNKNOWN)
        } finally {
            ExitMessage.isMaking = false
        }
    }

    public companion object {
        private const val NANOSECONDS = 1_000_000L

        /**
         * Returns how many files in [folder] are frames for [frames]: scene files and meshes; 0 if there is no such
         * folder.
         *
         * @throws FramesException if the folder cannot be read
         */
        @JvmStatic
        public fun ownFrames(folder: Path): Int = FrameFolder.files(folder).size
    }
}

/**
 * Thrown if the renderer hangs when it is created or queried, before any rule is run. The message contains stack
 * traces.
 *
 * @property isInconclusive whether the machine may only have been too busy
 */
public class NotMadeException internal constructor(message: String, public val isInconclusive: Boolean) :
    RuntimeException(message)

/** The suite for the renderer of the run in progress. Instantiated by jqwik. */
internal class SubjectOfRun : RendererConformance() {
    override fun renderer(): Renderer = checkNotNull(RunUnderWay.current) { "no run is in progress" }.make.get()
}
