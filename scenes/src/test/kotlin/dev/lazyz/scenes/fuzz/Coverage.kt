package dev.lazyz.scenes.fuzz

import org.jacoco.core.data.ExecutionData
import org.jacoco.core.instr.Instrumenter
import org.jacoco.core.runtime.LoggerRuntime
import org.jacoco.core.runtime.RuntimeData

/**
 * Loads the loaders' classes once more, with JaCoCo's probes in them: one on each branch that code can take. Other
 * tests use the classes as they are, and no agent is needed. Not thread safe.
 */
internal class Coverage : ClassLoader(Coverage::class.java.classLoader) {
    private val runtime = LoggerRuntime()
    private val data = RuntimeData().also { runtime.startup(it) }
    private val instrumenter = Instrumenter(runtime)
    private val seen = HashMap<Long, BooleanArray>()

    /** How many probes were reached since the beginning. */
    var reached = 0
        private set

    /** What the last input reached. */
    class Reach(val probes: Int, val newProbes: Int)

    /** Makes an object of the class [name] with probes, or of a class that uses such. */
    fun create(name: String, vararg arguments: Any): Any =
        loadClass(name).declaredConstructors.single { it.parameterCount == arguments.size }.newInstance(*arguments)

    /** Returns what was reached since this was called last. */
    fun take(): Reach {
        var probes = 0
        val before = reached
        data.collect({ probes += count(it) }, { }, true)
        return Reach(probes, reached - before)
    }

    private fun count(execution: ExecutionData): Int {
        val now = execution.probes
        val ever = seen.getOrPut(execution.id) { BooleanArray(now.size) }
        var count = 0
        for (i in now.indices) {
            if (!now[i]) continue
            count++
            if (!ever[i]) {
                ever[i] = true
                reached++
            }
        }
        return count
    }

    override fun loadClass(name: String, resolve: Boolean): Class<*> {
        if (!isOurs(name)) return super.loadClass(name, resolve)
        synchronized(getClassLoadingLock(name)) {
            return findLoadedClass(name) ?: define(name)
        }
    }

    private fun define(name: String): Class<*> {
        val stream = getResourceAsStream(name.replace('.', '/') + ".class") ?: throw ClassNotFoundException(name)
        val bytes = instrumenter.instrument(stream.use { it.readBytes() }, name)
        return defineClass(name, bytes, 0, bytes.size)
    }

    private companion object {
        val case: String = LoadAndDraw::class.java.name

        /** The loaders, the libraries that they parse with, and what calls them; the fuzzer itself is another's. */
        fun isOurs(name: String): Boolean = when {
            name == case || name.startsWith("$case$") -> true
            name.startsWith(FUZZER) -> false
            else -> name.startsWith("dev.lazyz.scenes.") || name.startsWith("de.javagl.")
        }

        val FUZZER: String = LoadAndDraw::class.java.packageName + "."
    }
}
