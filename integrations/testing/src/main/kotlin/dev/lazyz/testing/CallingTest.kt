package dev.lazyz.testing

import kotlin.streams.asSequence

/** Finds the class of the test that runs on this thread. */
internal object CallingTest {
    private val libraries = listOf("java.", "jdk.", "kotlin.", "kotlinx.")
    private val frameworks = listOf("org.junit.", "net.jqwik.engine.", "org.testng.", "io.kotest.")

    /**
     * Returns the full name of the class: the outermost on the stack that a test framework has called, so that it is
     * the test's and not that of a helper, without the names of nested classes. Returns `unknown` if there is none.
     */
    fun name(): String = name(StackWalker.getInstance().walk { it.asSequence().map { it.className }.toList() })

    /** As above, for the names of the classes on a stack, innermost first. */
    fun name(stack: List<String>): String {
        val callers = stack.takeWhile { name -> frameworks.none { name.startsWith(it) } }
        val called = callers.lastOrNull { name -> libraries.none { name.startsWith(it) } }
        return called?.substringBefore('$') ?: "unknown"
    }
}
