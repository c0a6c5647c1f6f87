package dev.lazyz.cli

import com.github.ajalt.clikt.core.CliktError
import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.PrintHelpMessage
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import com.github.ajalt.clikt.parameters.options.versionOption
import dev.lazyz.cli.commands.CompareCommand
import dev.lazyz.cli.commands.CompletionCommand
import dev.lazyz.cli.commands.ConformanceCommand
import dev.lazyz.cli.commands.DiffCommand
import dev.lazyz.cli.commands.ManCommand
import dev.lazyz.cli.commands.RenderCommand
import dev.lazyz.cli.commands.ReportCommand
import dev.lazyz.cli.commands.ScenesCommand
import dev.lazyz.cli.commands.StrategiesCommand
import dev.lazyz.cli.commands.TraceCommand
import dev.lazyz.cli.commands.ViewCommand
import dev.lazyz.cli.options.Command
import dev.lazyz.cli.options.HelpText
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Failure
import dev.lazyz.cli.output.Heartbeat
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputClosed
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Version
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.text.EditDistance
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.system.exitProcess

/** Entry point of the program zcli. See [run]. */
fun main(args: Array<String>) {
    VectorModule.loadIfWanted()
    val streams = Streams.ofProcess()
    Thread.setDefaultUncaughtExceptionHandler(ThreadEnd(streams.messages))
    Heartbeat(streams).start()
    exitProcess(run(args, streams))
}

/**
 * Runs zcli on the given streams, without a terminal, and returns its exit code: 0 if all is done, 1 if pictures differ
 * or a strategy does not conform, 2 after a mistake of the user or a bad file, 70 after a bug in zcli, 75 if the
 * machine was too busy to tell whether a strategy conforms.
 */
fun run(args: Array<String>, stdin: InputStream, stdout: OutputStream, stderr: PrintStream): Int =
    run(args, Streams(stdin, stdout, stderr))

/** Runs zcli, and converts every outcome to a message and an exit code. This is the only place that does so. */
internal fun run(args: Array<String>, streams: Streams): Int = try {
    // JOML's fast access to buffers makes newer Java versions print warnings, and zcli does not need it
    System.setProperty("joml.nounsafe", "true")
    attempt(args, streams)
} catch (closed: OutputClosed) {
    // The reader of standard output has stopped reading. This is not an error
    ExitCode.DONE
} finally {
    streams.flushMessages()
}

private fun attempt(args: Array<String>, streams: Streams): Int {
    try {
        return outcome(args, streams)
    } catch (closed: OutputClosed) {
        throw closed
    } catch (failure: Throwable) {
        val mistake = Failure.mistake(failure)
        if (mistake != null) {
            streams.error(mistake)
            return ExitCode.MISTAKE
        }
        streams.messages.println(Failure.bugReport(failure, args))
        ClassArchive.discard()
        return ExitCode.BUG
    }
}

/** Runs the command. What it prints to standard output is written completely when this function returns. */
private fun outcome(args: Array<String>, streams: Streams): Int = try {
    Zcli(streams, args.asList()).parse(args.asList())
    streams.output.flush()
    ExitCode.DONE
} catch (request: CliktError) {
    answer(request, streams)
}

/** Handles Clikt's exceptions: help and version go to standard output, usage errors to standard error. */
private fun answer(request: CliktError, streams: Streams): Int {
    when (request) {
        is PrintHelpMessage -> streams.print(request.context?.command?.getFormattedHelp().orEmpty().trimEnd() + "\n")

        is UsageError -> streams.error(Failure.usage(request))

        // The command has already printed everything
        is ProgramResult -> Unit

        else -> {
            val text = request.message.orEmpty()
            if (request.statusCode == ExitCode.DONE) streams.print(text + "\n") else streams.error(text)
        }
    }
    try {
        streams.output.flush()
    } catch (closed: OutputClosed) {
        // The result of the command remains, also if nobody reads the text
        if (request !is ProgramResult) throw closed
    }
    return when {
        request is PrintHelpMessage || request.statusCode == ExitCode.DONE -> ExitCode.DONE
        request is ProgramResult -> request.statusCode
        else -> ExitCode.MISTAKE
    }
}

/** The archive of loaded classes with which the script `zcli` starts Java. */
internal object ClassArchive {
    /** System property with the path of the archive. The script sets it. */
    private const val PROPERTY = "zcli.archive"

    /** Deletes the archive after an unexplained failure, because it may be damaged. The script creates a new one. */
    fun discard() {
        val archive = System.getProperty(PROPERTY) ?: return
        try {
            Files.deleteIfExists(Path.of(archive))
        } catch (_: IOException) {
            // The archive is used again. The original failure has already been reported
        }
    }
}

/**
 * Reports the exceptions that end threads other than the main one to [messages], as Java does, except that memory is
 * used up: the thread was helping, and the one that it helped does the work, or fails and reports it.
 */
internal class ThreadEnd(private val messages: PrintStream) : Thread.UncaughtExceptionHandler {
    init {
        // The first call of a method needs memory, which is not there when it matters
        uncaughtException(Thread.currentThread(), OutOfMemoryError())
    }

    override fun uncaughtException(thread: Thread, failure: Throwable) {
        if (failure is OutOfMemoryError) return
        messages.print("Exception in thread \"${thread.name}\" ")
        failure.printStackTrace(messages)
    }
}

/**
 * Loads the module of Java's Vector API if the user requests it with `-Dzcli.kernel=vector`.
 *
 * Java loads the module only if an option requests it at the start, and then prints a warning. This object loads it
 * later and without a warning, by means of an export that the manifest of zcli.jar declares. It is not loaded by
 * default, because the time that it saves in one picture is seldom more than the time to load and compile it: see
 * docs/performance.md, "The Vector API in a process of one picture".
 */
internal object VectorModule {
    /** The package that the manifest exports to zcli. It contains the method that loads a module. */
    const val EXPORT: String = "java.base/jdk.internal.module"

    /** Loads the module if the user requested it. Does nothing on a JVM that does not permit this. */
    fun loadIfWanted() {
        if (System.getProperty("zcli.kernel") != "vector") return
        try {
            val modules = Class.forName("jdk.internal.module.Modules")
            modules.getMethod("loadModule", String::class.java).invoke(null, "jdk.incubator.vector")
        } catch (_: ReflectiveOperationException) {
            // The scalar kernel runs, with the same result. --stats prints which kernel ran
        }
    }
}

/**
 * The command `zcli`, which only contains subcommands.
 *
 * @param args the words of the command line; if the first is the name of a subcommand, only that one is built, so that
 *   zcli starts faster, unless it is about all of them
 */
internal class Zcli(streams: Streams, args: List<String>) : Command("zcli") {
    override val printHelpOnEmptyArgs: Boolean get() = true

    init {
        versionOption(Version.text, help = "Print the version and exit", message = { "zcli $it" })
        val first = args.firstOrNull()
        if (first != null && first !in NAMES && !first.startsWith("-")) throw unknown(first)
        val needsAll = first !in NAMES || first == ManCommand.NAME || first == CompletionCommand.NAME
        subcommands((if (needsAll) NAMES else listOfNotNull(first)).map { command(it, streams, args) })
    }

    private fun command(name: String, streams: Streams, args: List<String>): Command = when (name) {
        "render" -> RenderCommand(streams, args)
        "view" -> ViewCommand(streams)
        "compare" -> CompareCommand(streams, args)
        "diff" -> DiffCommand(streams)
        "report" -> ReportCommand(streams, args)
        "trace" -> TraceCommand(streams)
        "conformance" -> ConformanceCommand(streams, args)
        "scenes" -> ScenesCommand(streams)
        "strategies" -> StrategiesCommand(streams)
        ManCommand.NAME -> ManCommand(streams)
        CompletionCommand.NAME -> CompletionCommand(streams)
        else -> error("there is no command '$name'")
    }

    override fun help(context: Context): String =
        "Turns 3D models into pictures, without a GPU, a display or native code: the same bits on every machine."

    override fun helpEpilog(context: Context): String =
        "'zcli' stands for 'java -jar zcli.jar'.\n\n" + HelpText.examples(
            "zcli render teapot -o teapot.png" to "a built-in scene",
            "zcli render model.obj --view iso -o model.png" to "your own model",
            "zcli render --help" to "all options",
        )

    override fun run() = Unit

    /** Returns the error for an unknown command. If the word is an input, suggests 'zcli render'. */
    private fun unknown(word: String): Mistake {
        val isInput = SceneFormat.ofFileName(word) != null || Scenes.builtins.any { it.id == word }
        val hint = when {
            isInput -> "; did you mean 'zcli render $word'?"
            word == "help" -> "; did you mean 'zcli --help'?"
            else -> EditDistance.hint(word, NAMES)
        }
        return Mistake("no command '$word'$hint\nSee 'zcli --help'.")
    }

    private companion object {
        val NAMES = listOf(
            "render", "view", "compare", "diff", "report", "trace", "conformance", "scenes", "strategies",
            ManCommand.NAME, CompletionCommand.NAME,
        )
    }
}
