package dev.lazyz.shared

import net.jqwik.api.lifecycle.LifecycleContext
import net.jqwik.api.lifecycle.SkipExecutionHook
import net.jqwik.api.lifecycle.SkipExecutionHook.SkipResult

/** What `@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")` is for other tests, for properties. */
internal class NotByDefault : SkipExecutionHook {
    override fun shouldBeSkipped(context: LifecycleContext): SkipResult =
        if (System.getProperty("lazyz.effort") == null) SkipResult.skip("not by default") else SkipResult.doNotSkip()
}
