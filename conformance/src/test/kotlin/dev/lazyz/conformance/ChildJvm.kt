package dev.lazyz.conformance

import java.nio.file.Path
import kotlin.reflect.KClass

/** Programs of the tests in a JVM of their own. */
internal object ChildJvm {
    /** The words that run [main] with [args] in a JVM with [options]. */
    fun command(options: List<String>, main: KClass<*>, vararg args: String): List<String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        return listOf(java) + options + listOf("-cp", System.getProperty("java.class.path"), main.java.name) + args
    }

    /** Runs [main]; standard error goes where standard output goes. */
    fun start(options: List<String>, main: KClass<*>, vararg args: String): Process =
        ProcessBuilder(command(options, main, *args)).redirectErrorStream(true).start()
}
