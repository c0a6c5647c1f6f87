package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.scenes.teapot.Teapot
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d

/** The Utah teapot in glazed pottery. */
internal object TeapotScene {
    fun scene(segments: Int): Scene {
        val teapot = Teapot.tessellate(segments)
        val material = Material(
            baseColor = Rgba.ofRgb(0xC8643C),
            shading = Shading.BLINN_PHONG,
            specular = Rgba(0.45f, 0.43f, 0.40f),
            shininess = 64,
            name = "pottery",
        )

        // v increases upwards in the patches, downwards in a texture
        val uvs = FloatArray(teapot.uvs.size) { if (it % 2 == 0) teapot.uvs[it] else 1f - teapot.uvs[it] }
        return Scene(
            surfaces = listOf(Mesh(teapot.positions, teapot.triangles, material, teapot.normals, uvs)),
            lights = listOf(
                Light.Ambient(Rgba(0.12f, 0.13f, 0.16f)),
                Light.Directional(Vector3d(0.5, -0.9, -0.7), Rgba(0.85f, 0.82f, 0.76f)),
                Light.Directional(Vector3d(-0.9, 0.2, -0.2), Rgba(0.15f, 0.14f, 0.13f)),
            ),
            viewpoint = Camera.fit(azimuth = 25.0, elevation = 24.0),
            background = Rgba.ofRgb(0xE9EDF0),
        )
    }
}
