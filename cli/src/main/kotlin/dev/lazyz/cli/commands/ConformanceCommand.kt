package dev.lazyz.cli.commands

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.Renderer
import dev.lazyz.cli.conformance.ConformanceProcess
import dev.lazyz.cli.conformance.ConformanceWords
import dev.lazyz.cli.conformance.FuzzingOptions
import dev.lazyz.cli.conformance.ProgramOptions
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.Completions
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.options.classPath
import dev.lazyz.cli.options.number
import dev.lazyz.cli.options.path
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.ReportPlace
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyPath
import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.EndedEarlyException
import dev.lazyz.conformance.NotMadeException
import dev.lazyz.conformance.RecordedReport
import dev.lazyz.conformance.RecordedReportException
import dev.lazyz.conformance.report.ConformanceReport
import dev.lazyz.conformance.report.ShellWords
import dev.lazyz.conformance.results.RuleListener
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.WaiversException
import dev.lazyz.conformance.run.FramesException
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.text.EditDistance
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.ThreadLocalRandom
import kotlin.io.path.exists
import kotlin.io.path.writeText

/** `zcli conformance`: runs the conformance suite on a built-in or custom strategy. */
internal class ConformanceCommand(private val streams: Streams, private val args: List<String>) :
    Command("conformance") {
    private val strategy by option(
        "--strategy",
        metavar = "ID",
        help = "The strategy to test",
        completionCandidates = Completions.words { Strategies.ids() },
    )

    private val classPath by classPath()

    private val seed by option("--seed", help = "Use this seed; default: the fixed one").convert("N") { text ->
        text.toLongOrNull() ?: fail("'$text' is not a whole number")
    }

    private val isExploring by option("--explore", help = "Use a random seed; the summary prints it").flag()

    private val tries by option("--tries", help = "Multiply the number of frames by this; default: 1")
        .number("F", LEAST_TRIES..MOST_TRIES, "")

    private val rules by option(
        "--rule",
        metavar = "NAME",
        help = "Run only this rule, by its name or number; repeat the option for more; default: all",
    ).multiple()

    private val waivers by option("--waivers", help = "A file of rules that the strategy is known to break")
        .path()

    private val frames by option(
        "--frames",
        help = "Also use the scene files and meshes in this folder, and save frames there that rules fail on",
    ).path("FOLDER")

    private val verify by option(
        "--verify",
        metavar = "REPORT",
        help = "Repeat the run of this report.json, with its settings, and compare the outcome of each rule",
    ).path("REPORT")

    private val report by option(
        "--report",
        help = "Also write the report: ${ReportPlace.HELP}, with the report as text, JSON and JUnit XML, and the " +
            "frames that failed",
    ).path("OUT")

    private var reportPlace: ReportPlace? = null

    private val fuzzing by FuzzingOptions()

    private val programs by ProgramOptions()

    private val deadline by option(
        "--deadline",
        help = "Seconds of processor time until a rendering times out; default: 20. If ten times as long passes on " +
            "the wall, the rule is inconclusive: the machine is too busy",
    ).number("S", LEAST_DEADLINE..MOST_DEADLINE, "")

    private val isInProcess by option(
        "--in-process",
        help = "Run the strategy in the process of zcli, for debuggers: if it exits, zcli ends without a report",
    ).flag()

    private val isQuiet by option(
        "--quiet",
        help = "Do not print to standard error, while the suite runs, the outcome of each rule or, with --against, " +
            "what is done",
    ).flag()

    private val isJson by option("--json", help = "Print JSON instead of the summary").flag()

    /** The report that `--verify` names, or null. */
    private val recorded: RecordedReport? by lazy {
        if (verify != null && (seed != null || isExploring || tries != null || rules.isNotEmpty() || waivers != null)) {
            throw Mistake("--verify takes seed, tries, rules and waivers from the report: omit those options")
        }
        try {
            verify?.let { RecordedReport.read(it) }
        } catch (bad: RecordedReportException) {
            throw Mistake(bad.message.orEmpty())
        }
    }

    override fun help(context: Context): String =
        "Tests a built-in or custom strategy against the rules of the contract.\n\n" +
            "Exit code 1: it does not conform, pictures differ, or --verify finds a different outcome. " +
            "Exit code 75: the machine was too busy to tell; run it again, or with a longer --deadline."

    override fun helpEpilog(context: Context): String = HelpText.examples(
        "zcli conformance --strategy my-id --classpath my.jar --report report" to "your own strategy, and a report",
        "zcli conformance --strategy lazy --rule 5.2 --tries 10" to "one rule, with ten times as many frames",
        "zcli conformance --strategy my-id --classpath my.jar --explore" to "new random frames",
        "zcli conformance --strategy tiled --against zbuffer --minutes 10 --corpus frames" to "two strategies compared",
        "zcli conformance --program 'my-renderer {scene} {picture}' --report report" to "a program in any language",
        "zcli conformance --verify report/report.json --classpath my.jar" to "repeats and checks a recorded run",
    )

    override fun run() {
        fuzzing.check(rulesOnly())
        programs.exported(strategyOnly() + rulesOnly())?.let {
            streams.print(it)
            return
        }
        reportPlace = report?.let { ReportPlace(it, "--report") }
        val process = ConformanceProcess.current()
        if (process == null) frames?.let { announce(it) }
        val code = when {
            fuzzing.isAsked -> fuzz()

            programs.isAsked -> judgeProgram()

            process != null -> process.answer { output ->
                judged(process.journal) { output.writeText(it) }
            }

            isInProcess -> judged(null) { streams.print(it) }

            else -> supervise()
        }
        end(code)
    }

    /** Returns the options that were given of those that have an effect only if rules are run. */
    private fun rulesOnly(): List<String> = listOfNotNull(
        if (isExploring) "--explore" else null,
        tries?.let { "--tries" },
        if (rules.isNotEmpty()) "--rule" else null,
        waivers?.let { "--waivers" },
        frames?.let { "--frames" },
        verify?.let { "--verify" },
        report?.let { "--report" },
        deadline?.let { "--deadline" },
        if (isInProcess) "--in-process" else null,
        if (isJson) "--json" else null,
    )

    /** Returns the options that were given of those that are about a strategy. */
    private fun strategyOnly(): List<String> = listOfNotNull(
        strategy?.let { "--strategy" },
        if (classPath.isNotEmpty()) "--classpath" else null,
        if (fuzzing.isAsked) "--against" else null,
        if (isExploring) "--explore" else null,
        waivers?.let { "--waivers" },
        frames?.let { "--frames" },
        verify?.let { "--verify" },
        if (isInProcess) "--in-process" else null,
    )

    /** Reports how many frames of the user's own are in [folder], so that a misspelt name is noticed. */
    private fun announce(folder: Path) {
        val saved = "frames that rules fail on are saved there"
        val found = try {
            Conformance.ownFrames(folder)
        } catch (bad: FramesException) {
            throw Mistake("--frames: ${bad.message}")
        }
        when {
            !folder.exists() -> streams.warning("--frames: there was no folder $folder; it is created, and $saved")
            found == 0 -> streams.warning("--frames: no scene file or mesh is in $folder; $saved")
            !isQuiet -> streams.note("${counted(found.toLong(), "frame")} of your own in $folder\n")
        }
    }

    private fun judgeProgram(): Int {
        val run = programs.conformance(strategyOnly()).listener(progressListener())
        seed?.let { run.seed(it) }
        tries?.let { run.tries(it) }
        deadline?.let { run.deadline(seconds(it)) }
        reportPlace?.folder?.let { run.output(it) }
        return try {
            for (rule in rules) run.rule(rule)
            answered(run.run()) { streams.print(it) }
        } catch (bad: IllegalArgumentException) {
            throw Mistake(bad.message.orEmpty())
        }
    }

    /** Passes the text of [report] to [print], and returns the exit code. */
    private fun answered(report: ConformanceReport, print: (String) -> Unit): Int {
        reportPlace?.takeIf { it.folder == null }?.let { Html.write(it.page, report.toHtml()) }
        val words = ConformanceWords(recorded, isJson)
        print(words.text(report))
        return words.code(report)
    }

    /** Runs the suite, passes the text of the report to [print], and returns the exit code. */
    private fun judged(journal: Path?, print: (String) -> Unit): Int = try {
        answered(judge(journal), print)
    } catch (hanging: NotMadeException) {
        noReport(hanging, hanging.isInconclusive)
    }

    private fun progressListener() =
        if (isQuiet) RuleListener { _, _, _ -> } else ConformanceWords.progressListener(streams)

    private fun noReport(why: Exception, isInconclusive: Boolean): Int {
        val verdict = if (isInconclusive) "may conform, this run is inconclusive" else "does NOT conform"
        streams.error("${strategy ?: recorded?.strategy} $verdict: ${why.message}")
        return if (isInconclusive) ExitCode.INCONCLUSIVE else ExitCode.DIFFERENT
    }

    private fun fuzz(): Int = StrategyPath(classPath).use { path ->
        val id = strategy ?: throw Mistake("which strategy? Use --strategy ID")
        streams.isQuiet = isQuiet
        streams.progress("comparing pictures of random frames ...")
        val report = fuzzing.run(id, seed, path::find)
        streams.print(report.toText())
        if (report.isEqual) ExitCode.DONE else ExitCode.DIFFERENT
    }

    private fun judge(journal: Path?): ConformanceReport = StrategyPath(classPath).use { path ->
        val id =
            strategy ?: recorded?.strategy ?: throw Mistake("which strategy? Use --strategy ID, or --verify REPORT")
        val renderer by lazy { path.find(id) }
        val conformance = conformance(id) { renderer }
        if (journal == null) conformance.listener(progressListener()) else conformance.journal(journal)
        try {
            conformance.run()
        } catch (bad: FramesException) {
            throw Mistake(bad.message.orEmpty())
        }
    }

    /**
     * Runs the suite in a child process, so that there is a result even if the strategy ends or crashes that process.
     */
    private fun supervise(): Int {
        val seed = ThreadLocalRandom.current().nextLong(0, Int.MAX_VALUE.toLong())
        val answer = try {
            ConformanceProcess.run(args, seed, seconds(deadline ?: USUAL_DEADLINE), progressListener())
        } catch (ended: EndedEarlyException) {
            streams.note(ended.printed)
            return noReport(ended, ended.isInconclusive)
        }
        answer.report?.let { streams.print(it) }
        if (answer.messages.isNotBlank()) streams.note(answer.messages.trimEnd() + "\n")
        return answer.code
    }

    private fun seconds(number: Double): Duration = Duration.ofMillis((number * MILLISECONDS).toLong())

    private fun conformance(id: String, renderer: () -> Renderer): Conformance {
        if (seed != null && isExploring) throw Mistake("--seed and --explore exclude each other")
        val conformance = recorded?.again(renderer) ?: Conformance(renderer)
        conformance.command(command(id))
        seed?.let { conformance.seed(it) }
        if (isExploring) ConformanceProcess.seed()?.let { conformance.seed(it) } ?: conformance.explore()
        deadline?.let { conformance.deadline(seconds(it)) }
        tries?.let { conformance.tries(it) }
        for (rule in rules) {
            if (SuiteRule.matching(rule).isEmpty()) throw Mistake(unknown(rule))
            conformance.rule(rule)
        }
        try {
            waivers?.let { conformance.waivers(it) }
        } catch (bad: WaiversException) {
            throw Mistake(bad.message.orEmpty())
        }
        frames?.let { conformance.frames(it) }
        reportPlace?.folder?.let { conformance.output(it) }
        return conformance
    }

    /** Returns the command that reproduces a failure of the strategy [id], without the seed. */
    private fun command(id: String): String = buildString {
        append("zcli conformance --strategy ").append(ShellWords.quoted(id))
        for (jar in classPath) append(" --classpath ").append(ShellWords.quoted(jar))
        frames?.let { append(" --frames ").append(ShellWords.quoted("$it")) }
    }

    private fun unknown(rule: String): String {
        val names = SuiteRule.all.flatMap { listOf(it.name, it.number) }.distinct()
        return "no rule '$rule'${EditDistance.hint(rule, names)}\n" +
            "The rules are:\n" + SuiteRule.all.joinToString("\n") { "  ${it.name}" }
    }

    private companion object {
        const val LEAST_TRIES = 0.001
        const val MOST_TRIES = 1e6
        const val LEAST_DEADLINE = 0.001
        const val MOST_DEADLINE = 86_400.0
        const val USUAL_DEADLINE = 20.0
        const val MILLISECONDS = 1000.0
    }
}
