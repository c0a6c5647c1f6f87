package dev.lazyz.conformance.broken

import dev.lazyz.Shader

/** Mistakes in maps, metallic-roughness materials, spots, falloff and tone mapping. */
internal object MapMistakes {
    /** Reads all maps at the coordinates of the first set. */
    fun readFirstCoordinates(inside: Inside, changes: Changes) = inside.reshade(changes) { shader ->
        Shader {
            it.u2 = it.u
            it.v2 = it.v
            it.du2dx = it.dudx
            it.dv2dx = it.dvdx
            it.du2dy = it.dudy
            it.dv2dy = it.dvdy
            shader.shade(it)
        }
    }

    /** Reverses the normals of back faces, but not their tangents. */
    fun turnTangentsBack(inside: Inside, changes: Changes) {
        if (!inside.isTurned) return
        inside.reshade(changes) { shader ->
            Shader {
                it.tangentX = -it.tangentX
                it.tangentY = -it.tangentY
                it.tangentZ = -it.tangentZ
                it.tangentW = -it.tangentW
                shader.shade(it)
            }
        }
    }

    fun loseTransforms(inside: Inside, changes: Changes) {
        inside.shader?.let { Inside.read(it, "texture") }?.let { changes.set(it, "isTransformed", false) }
    }

    fun loseOcclusion(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(it, "occlusionMap", null) }
    }

    fun loseEmissionMap(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(it, "emissionMap", null) }
    }

    fun loseMetalness(inside: Inside, changes: Changes) {
        inside.shader?.let { Inside.read(it, "model") }?.let { changes.set(it, "metallic", 0f) }
    }

    fun loseEnvironment(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(physical(it), "studio", null) }
    }

    /** Leaves out exposure and tone curve in one kind of primitive. */
    fun loseToneMappingOfSpheres(inside: Inside, changes: Changes) {
        if (inside.isSphere) inside.shader?.let { changes.set(it, "toneMapper", null) }
    }

    /** Spots shine in all directions. */
    fun loseCones(inside: Inside, changes: Changes) = eachLight(inside) { numbers, at ->
        for (k in 0 until 4) changes.setNumber(numbers, at + CONE + k, 0f)
        changes.setNumber(numbers, at + CONE + 4, 1f)
    }

    /** Lights have the same strength at any distance. */
    fun loseFalloff(inside: Inside, changes: Changes) = eachLight(inside) { numbers, at ->
        changes.setNumber(numbers, at + FALLOFF, 0f)
    }

    /** Calls [action] with the numbers of each light whose strength depends on the place, and their first index. */
    private fun eachLight(inside: Inside, action: (numbers: FloatArray, at: Int) -> Unit) {
        val shader = inside.shader ?: return
        for (owner in listOf(lighting(shader), physical(shader))) {
            val numbers = Inside.read(checkNotNull(Inside.read(owner, "sources")), "numbers") as FloatArray
            for (at in numbers.indices step STRIDE) if (numbers[at + KIND] == VARYING) action(numbers, at)
        }
    }

    private fun lighting(shader: Any): Any = checkNotNull(Inside.read(shader, "lighting"))

    private fun physical(shader: Any): Any = checkNotNull(Inside.read(lighting(shader), "physical"))

    // The layout of the numbers of a light
    private const val KIND = 6
    private const val VARYING = 2f
    private const val FALLOFF = 7
    private const val CONE = 9
    private const val STRIDE = 14
}
