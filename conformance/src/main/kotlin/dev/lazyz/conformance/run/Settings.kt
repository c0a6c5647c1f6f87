package dev.lazyz.conformance.run

import dev.lazyz.conformance.judgement.ProcessEnded
import dev.lazyz.conformance.judgement.TimedOut
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.StrategyInfo
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import java.nio.file.Path
import java.time.Duration
import net.jqwik.api.ShrinkingMode

/** Whether a frame that fails is made smaller. */
internal enum class Shrinking(val mode: ShrinkingMode) {
    /** Bounded in steps. */
    ON(ShrinkingMode.FULL),

    OFF(ShrinkingMode.OFF),
}

/** How the suite is run; [seed] is null for the fixed one, and [deadline] is for each try. */
internal class Settings(
    val tries: Double,
    val seed: Long?,
    val waivers: Waivers,
    val shrinking: Shrinking,
    val deadline: Duration,
    val frames: OwnFrames?,
) {
    /** Returns the report of a run by these settings; see [ConformanceReport] for the rest. */
    fun report(
        judged: StrategyInfo,
        command: String?,
        results: List<RuleResult>,
        milliseconds: Long,
    ): ConformanceReport = ConformanceReport(
        judged, seed ?: SuiteRule.fixedSeed, tries, waivers.all, command, results, milliseconds,
    )

    companion object {
        /** A hundred times what a try takes on a slow machine. */
        val USUAL_DEADLINE: Duration = Duration.ofSeconds(20)

        /** Most frames that are tried to find a smaller one that fails; half as many rarely find a larger one. */
        const val MANY_STEPS: Int = 400

        /** The same, when several rules have failed, most often for the same reason. */
        const val FEW_STEPS: Int = 40

        /** What the system properties say. */
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

        private fun ownFrames(): OwnFrames? = frames()?.let { OwnFrames(it) }

        fun waivers(): Waivers =
            System.getProperty(Waivers.PROPERTY)?.let { Waivers.read(Path.of(it)) } ?: Waivers.NONE
    }
}

/** What came of the rules of one test class so far, as far as it matters to the next. */
internal class Tally {
    private var broken = 0
    private var timeOuts = 0

    /** How many frames may be tried to find a smaller one that fails. */
    val steps: Int get() = if (broken < MOST_SHRUNK) Settings.MANY_STEPS else Settings.FEW_STEPS

    /** Why the next rule is not tried; null if it is. */
    val whyNoFurtherRule: String?
        get() = if (timeOuts <
            MOST_TIME_OUTS
        ) {
            null
        } else {
            "$MOST_TIME_OUTS rules before it timed out or ended the process"
        }

    fun add(verdict: RuleResult) {
        val failure = verdict.failure ?: return
        broken++
        if (failure.cause is TimedOut || failure.cause is ProcessEnded) timeOuts++
    }

    companion object {
        /** Rules whose frames are made as small as possible: who makes one mistake breaks many rules by it. */
        const val MOST_SHRUNK: Int = 3

        private const val MOST_TIME_OUTS = 3
    }
}
