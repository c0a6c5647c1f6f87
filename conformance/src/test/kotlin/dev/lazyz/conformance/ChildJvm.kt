package dev.lazyz.conformance

import java.nio.file.Path
import kotlin.reflect.KClass

/** Runs programs of the tests in separate JVMs. */
internal object ChildJvm {
    /**
     * Returns the command that runs [main] with [args] in a JVM with [options]. The optimizing compiler is off, because
     * the program is short.
     */
    fun command(options: List<String>, main: KClass<*>, vararg args: String): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val words = listOf("-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), main.java.name)
        return listOf(java) + options + words + args
    }

    /** Runs [main] with standard error redirected to standard output. */
    fun start(options: List<String>, main: KClass<*>, vararg args: String): Process =
        ProcessBuilder(command(options, main, *args)).redirectErrorStream(true).start()
}
