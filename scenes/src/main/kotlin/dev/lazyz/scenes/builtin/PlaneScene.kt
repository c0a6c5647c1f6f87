package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d

/** A chequered plane of two triangles, with some objects on it. */
internal object PlaneScene {
    private const val HALF_SIDE = 300.0
    private const val DARK = 0x39536B
    private const val LIGHT = 0xE8E4D8

    fun scene(): Scene = Scene(
        surfaces = listOf(
            ground(),
            ball(-2.3, 1.0, -1.2, 0xCC4B37),
            ball(0.2, 0.6, 1.5, 0xE0A83C),
            ball(5.5, 1.6, -9.0, 0x4F9C7F),
            ball(-9.0, 2.2, -22.0, 0x7B6BB0),
            crate(),
        ),
        lights = listOf(
            Light.Ambient(Rgba(0.25f, 0.27f, 0.30f)),
            Light.Directional(Vector3d(0.7, -1.0, -0.5), Rgba(0.78f, 0.76f, 0.70f)),
        ),
        viewpoint = Camera.perspective(
            eye = Vector3d(0.6, 2.3, 8.5),
            target = Vector3d(0.3, 1.15, 0.0),
            up = Vector3d(0.0, 1.0, 0.0),
            fieldOfViewDegrees = 42.0,
            near = 0.5,
            far = 700.0,
        ),
        background = Rgba.ofRgb(0xB7D0E2),
    )

    /** Returns the plane, with squares of one unit. The texture consists of two by two squares. */
    private fun ground(): Surface {
        val texture = Texture(
            2, 2, intArrayOf(opaque(DARK), opaque(LIGHT), opaque(LIGHT), opaque(DARK)),
            Texture.Filter.NEAREST, Texture.Wrap.REPEAT, Texture.Wrap.REPEAT, "chequers", MipFilter.ANISOTROPIC,
        )
        val builder = MeshBuilder()
        builder.floor(-HALF_SIDE, -HALF_SIDE, HALF_SIDE, HALF_SIDE, 0.0, HALF_SIDE)
        return builder.build(Material(texture = texture, name = "ground"))
    }

    private fun ball(x: Double, radius: Double, z: Double, color: Int): Sphere = Sphere(
        Vector3d(x, radius, z),
        radius,
        Material(
            Rgba.ofRgb(color),
            shading = Shading.BLINN_PHONG,
            specular = Rgba(0.4f, 0.4f, 0.4f),
            shininess = 60,
            name = "ball",
        ),
    )

    /** Returns a cube rotated by the angle of a triangle with sides 3, 4 and 5. */
    private fun crate(): Surface {
        val a = doubleArrayOf(1.6 * 0.8, 0.0, -1.6 * 0.6)
        val b = doubleArrayOf(-1.6 * 0.6, 0.0, -1.6 * 0.8)
        val up = doubleArrayOf(0.0, 1.6, 0.0)
        val front = doubleArrayOf(1.9, 0.0, 0.4)
        val builder = MeshBuilder()
        builder.rectangle(front, a, up)
        builder.rectangle(sum(front, a), b, up)
        builder.rectangle(sum(sum(front, a), b), negative(a), up)
        builder.rectangle(sum(front, b), negative(b), up)
        builder.rectangle(sum(front, up), a, b)
        return builder.build(Material(texture = boards(), name = "crate"))
    }

    /** Returns a texture of boards within a frame, 16 x 16 texels. */
    private fun boards(): Texture {
        val texels = IntArray(16 * 16) {
            val x = it % 16
            val y = it / 16
            val isFrame = x < 2 || x > 13 || y < 2 || y > 13
            val isGap = !isFrame && (x - 2) % 4 == 3
            opaque(
                if (isFrame) {
                    0x9A6A3A
                } else if (isGap) {
                    0x5E3D1E
                } else {
                    0xC49359
                }
            )
        }
        return Texture(
            16, 16, texels, Texture.Filter.NEAREST, Texture.Wrap.CLAMP, Texture.Wrap.CLAMP, "boards",
            MipFilter.ANISOTROPIC,
        )
    }

    private fun sum(a: DoubleArray, b: DoubleArray): DoubleArray = DoubleArray(3) { a[it] + b[it] }

    private fun negative(a: DoubleArray): DoubleArray = DoubleArray(3) { -a[it] }

    private fun opaque(rgb: Int): Int = rgb or (0xFF shl 24)
}
