package dev.lazyz.conformance.broken

import dev.lazyz.Shader

/** Mistakes in maps, metallic-roughness materials and tone mapping. */
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

    /** Leaves out exposure and tone curve in one kind of primitive. */
    fun loseToneMappingOfSpheres(inside: Inside, changes: Changes) {
        if (inside.isSphere) inside.shader?.let { changes.set(it, "toneMapper", null) }
    }
}
