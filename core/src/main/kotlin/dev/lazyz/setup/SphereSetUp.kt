package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.Primitive
import dev.lazyz.Shader
import dev.lazyz.shading.Lighting
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.MaterialShader
import dev.lazyz.world.Camera
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Sphere

/** Converts spheres to primitives. */
internal object SphereSetUp {
    fun sphere(sphere: Sphere, camera: Camera, rays: SampleRays, lighting: Lighting): Primitive {
        val material = lit(sphere.material)
        val shader = MaterialShader(material, lighting, isPrelit = false)
        val primitive = SpherePrimitive.of(sphere, camera, rays, material.shader ?: shader) ?: return EmptyPrimitive
        if (material.alphaMode != AlphaMode.MASK) return primitive
        return MaskedPrimitive(primitive, shader, material.alphaCutoff)
    }

    /** Returns the shader for samples of [material] that are lit one by one. */
    fun shader(material: Material, lighting: Lighting): Shader =
        material.shader ?: MaterialShader(lit(material), lighting, isPrelit = false)

    /** A sphere has no faces or vertices that could be lit during set-up. */
    private fun lit(material: Material): Material = when (material.shading) {
        Shading.FLAT, Shading.GOURAUD -> material.withShading(Shading.PHONG)
        else -> material
    }
}
