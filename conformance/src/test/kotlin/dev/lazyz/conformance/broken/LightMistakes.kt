package dev.lazyz.conformance.broken

import dev.lazyz.world.AmbientVisibility

/** Mistakes in lights, in the environment, and in the visibility of ambient light. */
internal object LightMistakes {
    fun loseVisibility(inside: Inside, changes: Changes) = eachOwner(inside) { changes.set(it, VISIBILITY, null) }

    /** Looks from the other side of the surface. */
    fun turnVisibility(inside: Inside, changes: Changes) = replaceVisibility<Turned>(inside, changes) { Turned(it) }

    /** No light is stronger than 1. */
    fun dimLights(inside: Inside, changes: Changes) = eachLight(inside) { numbers, at ->
        for (k in at + COLOR until at + KIND) changes.setNumber(numbers, k, minOf(numbers[k], 1f))
    }

    /** Spots shine in all directions. */
    fun loseCones(inside: Inside, changes: Changes) = eachVarying(inside) { numbers, at ->
        for (k in 0 until 4) changes.setNumber(numbers, at + CONE + k, 0f)
        changes.setNumber(numbers, at + CONE + 4, 1f)
    }

    /** Lights have the same strength at any distance. */
    fun loseFalloff(inside: Inside, changes: Changes) = eachVarying(inside) { numbers, at ->
        changes.setNumber(numbers, at + FALLOFF, 0f)
    }

    fun loseEnvironment(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(physical(it), "studio", null) }
    }

    private inline fun <reified T : AmbientVisibility> replaceVisibility(
        inside: Inside,
        changes: Changes,
        change: (AmbientVisibility) -> T,
    ) = eachOwner(inside) { owner ->
        // Primitives share what lights them
        val own = Inside.read(owner, VISIBILITY) as AmbientVisibility?
        if (own != null && own !is T) changes.set(owner, VISIBILITY, change(own))
    }

    /** Calls [action] with the numbers of each light, and their first index. */
    private inline fun eachLight(inside: Inside, action: (numbers: FloatArray, at: Int) -> Unit) =
        eachOwner(inside) { owner ->
            val numbers = Inside.read(checkNotNull(Inside.read(owner, "sources")), "numbers") as FloatArray
            for (at in numbers.indices step STRIDE) action(numbers, at)
        }

    /** The same for the lights whose strength depends on the place. */
    private inline fun eachVarying(inside: Inside, action: (numbers: FloatArray, at: Int) -> Unit) =
        eachLight(inside) { numbers, at -> if (numbers[at + KIND] == VARYING) action(numbers, at) }

    /** Calls [action] with what lights the primitive, with each of the two models of light. */
    private inline fun eachOwner(inside: Inside, action: (Any) -> Unit) {
        val shader = inside.shader ?: return
        action(lighting(shader))
        action(physical(shader))
    }

    private fun lighting(shader: Any): Any = checkNotNull(Inside.read(shader, "lighting"))

    private fun physical(shader: Any): Any = checkNotNull(Inside.read(lighting(shader), "physical"))

    private class Turned(private val own: AmbientVisibility) : AmbientVisibility {
        override fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float) =
            own.at(x, y, z, -normalX, -normalY, -normalZ)
    }

    private const val VISIBILITY = "visibility"

    // The layout of the numbers of a light
    private const val COLOR = 3
    private const val KIND = 6
    private const val VARYING = 2f
    private const val FALLOFF = 7
    private const val CONE = 9
    private const val STRIDE = 14
}
