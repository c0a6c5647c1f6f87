package dev.lazyz.cli

import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertTrue

/** Runs zcli in processes of their own, with the current folder [folder]. */
internal class ChildZcli(private val folder: Path) {
    private val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()

    /** The [messages] of the process that was started last. */
    val errors: String get() = messages(folder)

    fun start(
        args: List<String>,
        javaOptions: List<String> = listOf(),
        configure: ProcessBuilder.() -> Unit = {},
    ): Process {
        val classPath = System.getProperty("java.class.path").split(File.pathSeparator)
            .joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        // Most runs are short: the optimizing compiler would take longer than it saves
        val words =
            listOf(java, "-XX:TieredStopAtLevel=1") + javaOptions + listOf("-cp", classPath, "dev.lazyz.cli.MainKt") +
                args
        return ProcessBuilder(words).directory(folder.toFile())
            .redirectError(folder.resolve("errors.txt").toFile())
            .apply(configure)
            .start()
    }

    /** Waits until [process] has ended, and returns its exit code. */
    fun code(process: Process): Int {
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        return process.exitValue()
    }

    /** Waits until [condition] holds while [process] runs. */
    fun await(process: Process, what: String, condition: () -> Boolean) {
        val deadline = System.nanoTime() + TimeUnit.MINUTES.toNanos(10)
        while (!condition()) {
            assertTrue(process.isAlive, errors)
            assertTrue(System.nanoTime() < deadline, what)
            Thread.sleep(10)
        }
    }
}

/** Standard error of a process, `errors.txt` in [folder], without the lines about its progress every ten seconds. */
internal fun messages(folder: Path): String = folder.resolve("errors.txt").readText().replace(PROGRESS, "")

private val PROGRESS = Regex("zcli: after \\d+ s: .*\n")
