package dev.lazyz.conformance

import java.nio.file.Path
import kotlin.reflect.KClass

/** Programs of the tests in a JVM of their own. */
internal object ChildJvm {
    /** The words that run [main] with [args] in a JVM with [options], and without the optimizing compiler: it is soon over. */
    fun command(options: List<String>, main: KClass<*>, vararg args: String): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val words = listOf("-XX:TieredStopAtLevel=1", "-cp", System.getProperty("java.class.path"), main.java.name)
        return listOf(java) + options + words + args
    }

    /** Runs [main]; standard error goes where standard output goes. */
    fun start(options: List<String>, main: KClass<*>, vararg args: String): Process =
        ProcessBuilder(command(options, main, *args)).redirectErrorStream(true).start()
}
