package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.mutants.DisruptiveRenderers
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import java.nio.file.Path
import java.time.Duration
import java.util.SimpleTimeZone
import java.util.TimeZone
import kotlin.io.path.exists
import kotlin.io.path.writeText
import kotlin.system.exitProcess

/**
 * A program that tests the renderer with a given name. It keeps a journal in one file and writes its report to another.
 */
internal object SupervisedRun {
    private val makers: Map<String, () -> Renderer> = mapOf(
        "right" to { PlainRenderer() },
        "wrong" to { BasicMistakes.lastWinsTies() },
        "wrong by few rules" to { BasicMistakes.lastWinsTies() },
        "sleeps" to { DisruptiveRenderers.sleeps() },
        "halts" to { DisruptiveRenderers.halts() },
        "exits when made" to { exitProcess(0) },
        "halts when made" to {
            Runtime.getRuntime().halt(0)
            error("it goes on")
        },
        "never made" to { DisruptiveRenderers.never() },
        "sets the time zone when its class is loaded" to { ZonedRenderer() },
    )

    /** A short run whose outcome does not depend on how busy the machine is. */
    fun conformance(name: String): Conformance {
        val conformance = Conformance(makers.getValue(name)).tries(0.01).deadline(Duration.ofMinutes(2))
        for (rule in rules(name)) conformance.rule(rule)
        return conformance
    }

    /** Returns the rules to run for the renderer [name]; empty for all. */
    private fun rules(name: String): List<String> = when (name) {
        "right", "wrong" -> emptyList()
        "wrong by few rules" -> listOf("2.5", "5.2")
        "sets the time zone when its class is loaded" -> listOf(RuleNames.empty, RuleNames.tidy)
        else -> RULES
    }

    @JvmStatic
    fun main(args: Array<String>) {
        val (name, journal, report) = args
        Path.of(report).writeText(conformance(name).journal(Path.of(journal)).run().toJson())
    }

    /** A rule with primitives to draw, and a rule without. */
    val RULES: List<String> = listOf(RuleNames.ties, "rule_9_6_framesWithoutPrimitivesShowTheBackground")
}

/** Changes a setting of the process once, before the first rule. */
private class ZonedRenderer : PlainRenderer("zoned") {
    private companion object {
        init {
            TimeZone.setDefault(SimpleTimeZone(1000, "Elsewhere"))
        }
    }
}

/** Files of a [SupervisedRun] in [folder]. */
internal class SupervisedFiles(folder: Path) {
    val journal: Path = folder.resolve("journal")
    val report: Path = folder.resolve("report.json")

    fun command(renderer: String): List<String> =
        ChildJvm.command(listOf("-Xmx512m"), SupervisedRun::class, renderer, "$journal", "$report")

    fun supervision(renderer: String, deadline: Duration): Supervision =
        Supervision(command(renderer), journal, deadline)
}

/** A program that supervises a [SupervisedRun] in the given folder. */
internal object Supervising {
    @JvmStatic
    fun main(args: Array<String>) {
        val files = SupervisedFiles(Path.of(args[0]))
        files.supervision("sleeps", Duration.ofMinutes(1)).run { files.report.exists() }
    }
}
