package dev.lazyz.cli.pages

import dev.lazyz.cli.run
import java.io.ByteArrayInputStream
import java.io.File
import java.io.PrintStream
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.inputStream
import kotlin.io.path.outputStream
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertTrue

/**
 * A shell in [folder], where `zcli` and `java -jar zcli.jar` run the code under test. One process runs all of its
 * commands, so that each does not wait for a start of Java.
 *
 * @param exchange folder for the files by which the shell and that process talk
 */
internal class PageShell(val folder: Path, private val exchange: Path) : AutoCloseable {
    private val programs = exchange.resolve("programs").createDirectories()
    private val zcli: Process

    /** The program `zcli`. */
    val program: Path get() = programs.resolve("zcli")

    init {
        for (pipe in listOf("request", "answer")) check(started("mkfifo", exchange.resolve(pipe).toString()) == 0)
        script("zcli", ZCLI)
        script("java", JAVA)
        val classPath = System.getProperty("java.class.path").split(File.pathSeparator)
            .joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        // Commands are short: the optimizing compiler would take longer than it saves
        val name = PageShell::class.java.name
        zcli = ProcessBuilder(java, "-XX:TieredStopAtLevel=1", "-cp", classPath, name, exchange.toString())
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(exchange.resolve("log.txt").toFile())
            .start()
    }

    private fun script(name: String, text: String) {
        val file = programs.resolve(name)
        file.writeText("#!/usr/bin/env bash\nexchange='$exchange'\n$text")
        file.toFile().setExecutable(true)
    }

    private fun started(vararg words: String): Int = ProcessBuilder(*words).inheritIO().start().waitFor()

    /** Runs [commands] as a script that ends at the first failure, and fails with what it prints. */
    fun run(commands: String) {
        val log = exchange.resolve("output.txt")
        val bash = ProcessBuilder("bash", "-euo", "pipefail", "-c", commands)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(log.toFile())
        bash.environment().merge("PATH", "$programs") { path, own -> own + File.pathSeparator + path }
        val process = bash.start()
        val ended = process.waitFor(15, TimeUnit.MINUTES)
        process.destroy()
        assertTrue(ended && process.exitValue() == 0) {
            "$commands\n${log.readText()}\n${exchange.resolve("log.txt").readText()}"
        }
    }

    override fun close() {
        zcli.destroy()
        zcli.waitFor()
    }

    companion object {
        private const val ZCLI = """
printf '%s\0' "${'$'}@" >"${'$'}exchange/arguments"
rm -f "${'$'}exchange/input"
for word; do
    if [[ ${'$'}word == - && ! -e ${'$'}exchange/input ]]; then cat >"${'$'}exchange/input"; fi
done
echo >"${'$'}exchange/request"
read -r code <"${'$'}exchange/answer"
cat "${'$'}exchange/errors" >&2
cat "${'$'}exchange/output"
exit "${'$'}code"
"""

        private const val JAVA = """
while [[ ${'$'}# -gt 0 ]]; do
    case ${'$'}1 in
        -D* | -X*) shift ;;
        -cp | --add-modules) shift 2 ;;
        -jar) [[ ${'$'}2 == *zcli.jar ]] || break
            shift 2
            exec zcli "${'$'}@" ;;
        dev.lazyz.cli.MainKt) shift
            exec zcli "${'$'}@" ;;
        *) break ;;
    esac
done
echo "java is not run for this page: ${'$'}*" >&2
exit 1
"""

        /** Runs a command of zcli for each request. */
        @JvmStatic
        fun main(args: Array<String>) {
            val exchange = Path.of(args[0])
            while (true) {
                exchange.resolve("request").readText()
                val words = exchange.resolve("arguments").readText().split('\u0000').dropLast(1)
                val input = exchange.resolve("input").takeIf { it.exists() }?.inputStream()
                val code = exchange.resolve("output").outputStream().use { output ->
                    PrintStream(exchange.resolve("errors").outputStream()).use { errors ->
                        run(words.toTypedArray(), input ?: ByteArrayInputStream(ByteArray(0)), output, errors)
                    }
                }
                input?.close()
                exchange.resolve("answer").writeText("$code\n")
            }
        }
    }
}
