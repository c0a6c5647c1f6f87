package dev.lazyz.cli

/**
 * Loads the module of Java's Vector API if the user requests it with `-Dzcli.kernel=vector`.
 *
 * Java loads the module only if an option requests it at the start, and then prints a warning. This object loads it
 * later and without a warning, by means of an export that the manifest of zcli.jar declares. It is not loaded by
 * default, because the time that it saves in one picture is seldom more than the time to load and compile it: see
 * docs/performance.md, "The Vector API in a process of one picture".
 */
internal object VectorModule {
    /** The package that the manifest exports to zcli. It contains the method that loads a module. */
    const val EXPORT: String = "java.base/jdk.internal.module"

    /** Loads the module if the user requested it. Does nothing on a JVM that does not permit this. */
    fun loadIfWanted() {
        if (System.getProperty("zcli.kernel") != "vector") return
        try {
            val modules = Class.forName("jdk.internal.module.Modules")
            modules.getMethod("loadModule", String::class.java).invoke(null, "jdk.incubator.vector")
        } catch (_: ReflectiveOperationException) {
            // The scalar kernel runs, with the same result. --stats prints which kernel ran
        }
    }
}
