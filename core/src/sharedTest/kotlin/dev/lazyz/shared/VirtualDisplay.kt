package dev.lazyz.shared

import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.deleteExisting
import kotlin.io.path.readText
import kotlin.system.exitProcess

/** A display on which processes can open windows: an Xvfb of its own. */
internal class VirtualDisplay private constructor(private val server: Process, private val number: String) :
    AutoCloseable {
    /** Runs the main function of [program] with the class path of the tests; returns its output and its exit code. */
    fun run(program: String, vararg args: String): Pair<String, Int> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val path = ClassPath.entries.joinToString(File.pathSeparator) { it.absolutePath }
        val words = listOf(java, "-XX:TieredStopAtLevel=1", "-Djava.awt.headless=false", "-cp", path, program) + args
        val log = Files.createTempFile("display", ".txt")
        val process = ProcessBuilder(words).redirectErrorStream(true).redirectOutput(log.toFile())
            .apply { environment()["DISPLAY"] = ":$number" }.start()
        try {
            check(process.waitFor(10, TimeUnit.MINUTES)) { "the process hangs: ${log.readText()}" }
            return log.readText() to process.exitValue()
        } finally {
            process.destroyForcibly()
            log.deleteExisting()
        }
    }

    override fun close() {
        server.destroy()
        server.waitFor()
    }

    companion object {
        /** The main function of a program for [run]: ends the process after [work], with a failure on the output. */
        fun program(work: () -> Unit): Nothing {
            val code = try {
                work()
                println("done")
                0
            } catch (failure: Throwable) {
                failure.printStackTrace()
                1
            }
            exitProcess(code)
        }

        /** Waits until [condition] holds. After five minutes it fails, with what [state] returns. */
        fun await(what: String, state: () -> String, condition: () -> Boolean) {
            val end = System.nanoTime() + TimeUnit.MINUTES.toNanos(5)
            while (!condition()) {
                check(System.nanoTime() < end) { "$what: ${state()}" }
                Thread.sleep(20)
            }
        }

        /** Starts a display, or returns null if Xvfb is not installed. */
        fun open(): VirtualDisplay? {
            val words = listOf("Xvfb", "-displayfd", "1", "-screen", "0", "1400x1000x24", "-nolisten", "tcp")
            val server = try {
                ProcessBuilder(words).redirectError(ProcessBuilder.Redirect.DISCARD).start()
            } catch (_: IOException) {
                return null
            }
            return server.inputStream.bufferedReader().readLine()?.let { VirtualDisplay(server, it) }
        }
    }
}
