package dev.lazyz.conformance.broken

/** Renderers that are correct except for lights, the environment, and the visibility of ambient light. */
object BrokenLight {
    fun environmentLost() = BrokenShading.wrong("environment-lost", LightMistakes::loseEnvironment)

    fun falloffLost() = BrokenShading.wrong("falloff-lost", LightMistakes::loseFalloff)

    fun visibilityLost() = BrokenShading.wrong("visibility-lost", LightMistakes::loseVisibility)
}
