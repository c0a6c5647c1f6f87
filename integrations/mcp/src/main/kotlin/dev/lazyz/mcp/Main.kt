package dev.lazyz.mcp

import io.modelcontextprotocol.json.McpJsonDefaults
import java.io.FileDescriptor
import java.io.FileInputStream
import java.io.FileOutputStream
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.system.exitProcess

/**
 * Entry point of the program `lazyz-mcp`: serves the models in a folder to a client of the Model Context Protocol,
 * which talks through standard input and output, until it closes them. Exit code 2 after a mistake in the options.
 */
public fun main(args: Array<String>) {
    System.setProperty("joml.nounsafe", "true")
    System.setProperty("slf4j.internal.verbosity", "ERROR")
    if (args.any { it == "--help" || it == "-h" }) return println(Limits.HELP)
    val words = args.filterNot { it.startsWith("--") }
    val folder = try {
        Path.of(words.singleOrNull() ?: exit("name one folder, with the models")).takeIf(Files::isDirectory)
    } catch (_: InvalidPathException) {
        null
    } ?: exit("there is no folder '${words.single()}'")
    val limits = args.filter { it.startsWith("--") }.fold(Limits()) { all, option ->
        all.with(option) ?: exit("'$option' is no option with a whole number above 0, such as --max-seconds=30")
    }
    val input = FileInputStream(FileDescriptor.`in`)
    val output = FileOutputStream(FileDescriptor.out)

    // Whatever prints, the client reads the protocol alone
    System.setOut(System.err)
    val transport = LineTransport(McpJsonDefaults.getMapper(), input, output)
    val jobs = Jobs(limits.seconds)
    ModelTools(ModelFolder(folder, limits.bytes), limits).serve(transport, jobs)
    transport.read()

    // Nobody reads what a job at work would answer
    exitProcess(0)
}

private fun exit(message: String): Nothing {
    System.err.println("lazyz-mcp: $message\nSee --help.")
    exitProcess(2)
}

/**
 * What one call may take. The defaults are those of `lazyz-server`.
 *
 * @property seconds time on the wall for reading and rendering
 * @property pixels pixels of all pictures
 * @property bytes bytes of a file
 */
internal class Limits(val seconds: Long = 30, val pixels: Long = 1L shl 24, val bytes: Long = 64L shl 20) {
    /** Returns these limits with that of [option], or null if there is no such option or value. */
    fun with(option: String): Limits? {
        val number = option.substringAfter('=').toLongOrNull()?.takeIf { it in 1..MOST } ?: return null
        return when (option.substringBefore('=')) {
            "--max-seconds" -> Limits(number, pixels, bytes)
            "--max-pixels" -> Limits(seconds, number, bytes)
            "--max-bytes" -> Limits(seconds, pixels, number)
            else -> null
        }
    }

    companion object {
        private const val MOST = Int.MAX_VALUE.toLong()

        val HELP: String = """
            Usage: java -jar lazyz-mcp.jar FOLDER [OPTIONS]

            Serves the models in FOLDER to a client of the Model Context Protocol, which starts
            this program and talks through standard input and output. Files elsewhere are not read.

            Options:
              --max-seconds=N   time on the wall for a call; default: ${Limits().seconds}
              --max-pixels=N    pixels of all pictures of a call; default: ${Limits().pixels}
              --max-bytes=N     bytes of a file; default: ${Limits().bytes}
              -h, --help        print this text and exit
        """.trimIndent()
    }
}
