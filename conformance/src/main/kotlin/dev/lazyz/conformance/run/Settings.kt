package dev.lazyz.conformance.run

import dev.lazyz.conformance.judgement.ProcessEnded
import dev.lazyz.conformance.judgement.TimedOut
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import java.nio.file.Path
import java.time.Duration

/** How the suite is run. [seed] is null for the default one, and [deadline] applies to each rendering. */
internal class Settings(
    val tries: Double,
    val seed: Long?,
    val waivers: Waivers,
    val shrinking: Shrinking,
    val deadline: Duration,
    val frames: FrameFolder?,
) {
    /** Returns the report of a run with these settings; see [ConformanceReport] for the parameters. */
    fun report(
        judged: StrategyInfo,
        command: String?,
        results: List<RuleResult>,
        milliseconds: Long,
        isOnDisk: Boolean,
    ): ConformanceReport = ConformanceReport(
        judged, seed ?: SuiteRule.fixedSeed, tries, waivers.all, command, results, milliseconds, isOnDisk,
    )

    companion object {
        /** A hundred times the processor time of a try on a slow machine. */
        val USUAL_DEADLINE: Duration = Duration.ofSeconds(20)

        /** Most shrinking steps. Half as many rarely find a larger frame. */
        const val MANY_STEPS: Int = 400

        /** Most shrinking steps when several rules have already failed, most often for the same reason. */
        const val FEW_STEPS: Int = 40

        /** Returns the settings that the system properties define. */
        fun ofProperties(): Settings = Settings(tries(), seed(), waivers(), Shrinking.ON, deadline(), ownFrames())

        fun tries(): Double = positive(SuiteProperties.TRIES) ?: 1.0

        fun deadline(): Duration =
            positive(SuiteProperties.DEADLINE)?.let { Duration.ofMillis((it * 1000).toLong()) } ?: USUAL_DEADLINE

        private fun positive(property: String): Double? = System.getProperty(property)?.let { text ->
            val number = text.toDoubleOrNull()
            require(number != null && number > 0.0 && number.isFinite()) {
                "system property $property must be a positive number: $text"
            }
            number
        }

        fun seed(): Long? = System.getProperty(SuiteProperties.SEED)?.let { text ->
            requireNotNull(text.toLongOrNull()) {
                "system property ${SuiteProperties.SEED} must be a whole number: $text"
            }
        }

        fun frames(): Path? = System.getProperty(SuiteProperties.FRAMES)?.let { Path.of(it) }

        private fun ownFrames(): FrameFolder? = frames()?.let { FrameFolder(it) }

        fun waivers(): Waivers = System.getProperty(Waivers.PROPERTY)?.let { Waivers.read(Path.of(it)) } ?: Waivers.NONE
    }
}

/** [why] a rule is not run, and the [outcome] that it has then. */
internal class NotRun(val why: String, val outcome: RuleOutcome)

/** Counts failures of the rules of one test class, as far as they affect the following rules. */
internal class RuleFailures {
    private var broken = 0
    private var timeOuts = 0
    private var inconclusive = 0

    /** How many shrinking steps the next rule may use. */
    val steps: Int get() = if (broken < MOST_SHRUNK) Settings.MANY_STEPS else Settings.FEW_STEPS

    /** Why the next rule is not run; null if it is. */
    val whyNoFurtherRule: NotRun?
        get() = when {
            timeOuts + inconclusive < MOST_TIME_OUTS -> null
            timeOuts == 0 -> NotRun("$MOST_TIME_OUTS earlier rules are inconclusive", RuleOutcome.INCONCLUSIVE)
            inconclusive == 0 -> notRun("timed out or ended the process")
            else -> notRun("timed out, ended the process or are inconclusive")
        }

    private fun notRun(what: String) = NotRun("$MOST_TIME_OUTS earlier rules $what", RuleOutcome.NOT_RUN)

    fun add(verdict: RuleResult) {
        if (verdict.outcome == RuleOutcome.INCONCLUSIVE) inconclusive++
        val failure = verdict.failure ?: return
        broken++
        if (failure.cause is TimedOut || failure.cause is ProcessEnded) timeOuts++
    }

    companion object {
        /** Number of rules whose frames are shrunk fully. One mistake usually breaks many rules. */
        const val MOST_SHRUNK: Int = 3

        private const val MOST_TIME_OUTS = 3
    }
}

/** Ends this process when the supervising process ends, for example because it was killed: the report would be lost. */
internal object Supervisor {
    /** Environment variable that contains the process id of the supervising process, set by `Supervision`. */
    const val VARIABLE: String = "LAZYZ_SUPERVISOR"

    init {
        System.getenv(VARIABLE)?.toLongOrNull()?.let { id ->
            val end = Runnable { Runtime.getRuntime().halt(1) }
            ProcessHandle.of(id).ifPresentOrElse({ it.onExit().thenRun(end) }, end)
        }
    }

    /** Starts watching the supervising process, if there is one. */
    fun follow(): Unit = Unit
}

/** Names of the system properties of the suite, documented in `RendererConformance` and `Waivers`. */
internal object SuiteProperties {
    const val TRIES: String = "lazyz.conformance.tries"
    const val SEED: String = "lazyz.conformance.seed"
    const val DEADLINE: String = "lazyz.conformance.deadline"
    const val FRAMES: String = "lazyz.conformance.frames"
    const val OUTPUT: String = "lazyz.conformance.output"
}
