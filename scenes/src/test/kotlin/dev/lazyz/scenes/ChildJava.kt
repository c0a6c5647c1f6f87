package dev.lazyz.scenes

import java.io.File
import java.util.concurrent.TimeUnit

/** Runs a class in a Java of its own. */
internal object ChildJava {
    /** Returns what the `main` of [main] prints, with these options of Java and [words], in at most ten minutes. */
    fun run(main: Class<*>, options: List<String>, vararg words: String): String {
        val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
        val java = File(System.getProperty("java.home"), "bin/java").path
        val command = listOf(java) + options + listOf("-XX:TieredStopAtLevel=1", "-cp", classPath, main.name) + words
        val process = ProcessBuilder(command).redirectErrorStream(true).start()
        if (!process.waitFor(10, TimeUnit.MINUTES)) {
            process.destroyForcibly()
            return "does not end"
        }
        return process.inputStream.bufferedReader().readText().trim()
    }
}
