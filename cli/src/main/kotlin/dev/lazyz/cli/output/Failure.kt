package dev.lazyz.cli.output

import com.github.ajalt.clikt.core.MultiUsageError
import com.github.ajalt.clikt.core.NoSuchOption
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.output.ParameterFormatter
import dev.lazyz.conformance.report.ShellWords
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.pictures.NoPictureException
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.util.ServiceConfigurationError

/** A mistake of the user, or a bad file. The user sees only the message. */
internal open class Mistake(message: String) : RuntimeException(message)

/** Converts exceptions to messages. */
internal object Failure {
    private const val ISSUES = "https://github.com/lazyz/lazyz/issues"

    /** Returns the message for the user, or null if [failure] is a bug in zcli. */
    fun mistake(failure: Throwable): String? = when (failure) {
        is Mistake, is NoPictureException, is SceneFormatException ->
            failure.message?.lines()?.joinToString("\n", transform = ::printable)

        is FileSystemException -> describe(failure)
        is OutOfMemoryError -> outOfMemory(failure)
        is UncheckedIOException -> failure.cause?.let(::mistake)
        is IOException -> failure.message ?: failure.javaClass.simpleName
        is InvalidPathException -> "not a file name: ${failure.input} (${failure.reason}; is the locale set to UTF-8?)"
        is ServiceConfigurationError -> "a renderer on the class path cannot be loaded: ${failure.message}"
        else -> null
    }

    /** Returns Clikt's message and a hint to --help. If an option is misspelt, omits the errors that follow from it. */
    fun usage(error: UsageError): String {
        val all = if (error is MultiUsageError) error.errors else listOf(error)
        val errors = all.filter { it is NoSuchOption }.ifEmpty { all }
        val context = errors.firstNotNullOfOrNull { it.context }
        val command = context?.commandNameWithParents()?.joinToString(" ") ?: "zcli"
        return errors.joinToString("\n") { wording(it) } + "\nSee '$command --help'."
    }

    private fun wording(error: UsageError): String {
        val context = error.context ?: return error.message.orEmpty()
        return error.formatMessage(context.localization, ParameterFormatter.Plain)
    }

    private fun outOfMemory(error: OutOfMemoryError): String =
        "out of memory (${error.message}); Java may use ${Bytes.readable(Runtime.getRuntime().maxMemory())}: " +
            "give it more with 'java -Xmx...g -jar zcli.jar ...', or render a smaller --size"

    /** Returns a bug report with everything that the user needs to send. */
    fun bugReport(failure: Throwable, args: Array<String>): String = buildString {
        appendLine("zcli: this is a bug in zcli.")
        appendLine("Please report it at $ISSUES with the text below and, if possible, the input file.")
        appendLine()
        appendLine("zcli ${Version.text}")
        appendLine("Java ${System.getProperty("java.version")}, ${System.getProperty("java.vm.name")}")
        appendLine("${System.getProperty("os.name")} ${System.getProperty("os.arch")}")
        appendLine(CommandLine.of(args.asList()))
        append(failure.stackTraceToString())
    }

    private fun describe(failure: FileSystemException): String {
        val what = when (failure) {
            is NoSuchFileException -> "no such file or folder"
            is AccessDeniedException -> "permission denied"
            else -> failure.reason ?: failure.javaClass.simpleName
        }
        return printable("${failure.file}: $what")
    }
}

/** The exit codes of zcli. */
internal object ExitCode {
    const val DONE = 0

    /** Pictures differ, a strategy failed, or a strategy does not conform. */
    const val DIFFERENT = 1

    /** A mistake of the user, or a bad file. */
    const val MISTAKE = 2

    /** A bug in zcli: `EX_SOFTWARE` of sysexits.h. */
    const val BUG = 70

    /** The machine was too busy to tell whether a strategy conforms: `EX_TEMPFAIL` of sysexits.h. */
    const val INCONCLUSIVE = 75
}

/** The version of zcli, from the manifest of the jar. */
internal object Version {
    val text: String get() = Version::class.java.`package`?.implementationVersion ?: "(development)"
}

/** Command lines of zcli as text. */
internal object CommandLine {
    /** Returns the command with the words [args], as it is typed in a shell. */
    fun of(args: List<String>): String = (listOf("zcli") + args).joinToString(" ", transform = ShellWords::quoted)

    /** Returns [args] without the options [names], which have a value each, up to a word `--`. */
    fun without(args: List<String>, names: Set<String>): List<String> {
        val end = args.indexOf("--").let { if (it < 0) args.size else it }
        val kept = ArrayList<String>()
        var i = 0
        while (i < end) {
            val word = args[i++]
            when {
                word in names -> i++
                names.none { word.startsWith(if (it.startsWith("--")) "$it=" else it) } -> kept.add(word)
            }
        }
        return kept + args.drop(end)
    }
}
