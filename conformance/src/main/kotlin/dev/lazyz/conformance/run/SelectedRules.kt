package dev.lazyz.conformance.run

import dev.lazyz.conformance.rules.AllRules
import org.junit.platform.engine.FilterResult
import org.junit.platform.engine.TestDescriptor
import org.junit.platform.engine.support.descriptor.ClassSource
import org.junit.platform.launcher.PostDiscoveryFilter

/**
 * Fails a Maven build that would run no rule, and succeed, because of `-Dtest='MyTest#rule_5*'`: Maven looks for
 * methods by the class that declares them, which is one of the suite's. It includes everything.
 */
internal class SelectedRules : PostDiscoveryFilter {
    override fun apply(test: TestDescriptor): FilterResult {
        val source = test.source.orElse(null) as? ClassSource
        val type = source?.let { runCatching { it.getJavaClass() }.getOrNull() }
        if (type != null && AllRules::class.java.isAssignableFrom(type)) requireRules(type.simpleName)
        return FilterResult.included(null)
    }

    companion object {
        /** The system property in which Maven passes the option of this name on. */
        const val PROPERTY: String = "test"

        private fun requireRules(name: String) {
            val words = System.getProperty(PROPERTY).orEmpty().split(',').map { it.trim() }
            val (type, methods) = words.firstOrNull { it.substringBefore('#').endsWith(name) && '#' in it }
                ?.split('#', limit = 2) ?: return
            check("*Rules#$methods" in words) {
                "-Dtest=$type#$methods runs none of the rules, which $name inherits; use -Dtest='$type,*Rules#$methods'"
            }
        }
    }
}
