package dev.lazyz.conformance.broken

/** Renderers that are correct except for lights, the environment, and the visibility of ambient light. */
object BrokenLight {
    fun environmentLost() = BrokenShading.wrong("environment-lost", LightMistakes::loseEnvironment)

    fun conesLost() = BrokenShading.wrong("cones-lost", LightMistakes::loseCones)

    fun falloffLost() = BrokenShading.wrong("falloff-lost", LightMistakes::loseFalloff)

    fun visibilityLost() = BrokenShading.wrong("visibility-lost", LightMistakes::loseVisibility)

    fun visibilityLostOnMetals() =
        BrokenShading.wrong("visibility-lost-on-metals", LightMistakes::loseVisibilityOfMetals)

    fun visibilityOfTheLastPoint() =
        BrokenShading.wrong("visibility-of-the-last-point", LightMistakes::delayVisibility)

    fun studioAtMostOne() = BrokenShading.wrong("studio-at-most-1", LightMistakes::dimStudio)
}
