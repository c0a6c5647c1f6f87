package dev.lazyz.conformance

import java.lang.reflect.AnnotatedElement
import java.lang.reflect.Method
import java.util.Optional
import net.jqwik.api.lifecycle.AroundPropertyHook
import net.jqwik.api.lifecycle.PropertyExecutionResult
import net.jqwik.api.lifecycle.PropertyExecutor
import net.jqwik.api.lifecycle.PropertyLifecycleContext

/** Multiplies the tries of the suite's rules by a system property, and sets their seed by another. */
internal class Effort : AroundPropertyHook {
    /** Leaves alone what a subclass adds. */
    override fun appliesTo(element: Optional<AnnotatedElement>): Boolean =
        element.map { it !is Method || it.declaringClass == RendererConformance::class.java }.orElse(false)

    override fun aroundProperty(
        context: PropertyLifecycleContext,
        property: PropertyExecutor,
    ): PropertyExecutionResult {
        val attributes = context.attributes()
        val factor = System.getProperty(RendererConformance.TRIES, "1").toDoubleOrNull()
        require(factor != null && factor > 0.0) {
            "system property ${RendererConformance.TRIES} must be a positive number: " +
                System.getProperty(RendererConformance.TRIES)
        }
        attributes.setTries((attributes.tries().orElse(1) * factor).toInt().coerceAtLeast(1))
        System.getProperty(RendererConformance.SEED)?.let { attributes.setSeed(it) }
        return property.execute()
    }
}
