package dev.lazyz.cli

/**
 * Java's Vector API for those who ask for it: `-Dzcli.kernel=vector`.
 *
 * Java leaves the module out unless it is told at its start, and then prints a warning. Here it comes later and silently,
 * by a door that zcli.jar's manifest opens. It does not come by itself, for what it saves in one picture seldom pays for
 * loading and compiling it: see docs/performance.md, "The Vector API in a process of one picture".
 */
internal object VectorModule {
    /** What the manifest exports to us: the package of the method that loads a module. */
    const val EXPORT: String = "java.base/jdk.internal.module"

    /** Loads the module if the user asked for it; on a Java that does not let us, nothing happens. */
    fun loadIfWanted() {
        if (System.getProperty("zcli.kernel") != "vector") return
        try {
            val modules = Class.forName("jdk.internal.module.Modules")
            modules.getMethod("loadModule", String::class.java).invoke(null, "jdk.incubator.vector")
        } catch (_: ReflectiveOperationException) {
            // Then the scalar kernel runs: the same bits, and --stats says so
        }
    }
}
