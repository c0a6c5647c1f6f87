package dev.lazyz.lighting

import dev.lazyz.Image
import dev.lazyz.Rgba
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import java.util.Random
import kotlin.math.abs
import kotlin.math.sqrt
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class MatcapTest {
    /** Red grows to the right, green upward; the corners, which no normal reaches, are blue. */
    private val texture: Texture = run {
        val texels = IntArray(SIDE * SIDE) { i ->
            val u = (i % SIDE + 0.5) / SIDE
            val v = (i / SIDE + 0.5) / SIDE
            val isInside = (u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5) < 0.25
            val blue = if (isInside) 0 else 255
            (0xFF shl 24) or ((u * 255).toInt() shl 16) or (((1 - v) * 255).toInt() shl 8) or blue
        }
        Texture(SIDE, SIDE, texels, Texture.Filter.BILINEAR, Texture.Wrap.CLAMP, Texture.Wrap.CLAMP)
    }

    private fun picture(scene: Scene, camera: Camera, tint: Rgba = Rgba.WHITE): Image {
        val shader = Matcap(texture, camera, scene.origin, tint)
        return ZBufferRenderer().render(
            scene.withMaterials { it.withShader(shader) }.withViewpoint(camera).frame(101, 101),
        )
    }

    /** The codes of red and green that a place on the lit sphere has, 0..255; [x] and [y] are -1..1. */
    private fun requireColor(x: Double, y: Double, argb: Int, tolerance: Int) {
        val red = (argb ushr 16 and 0xFF) - 255 * (0.5 + 0.49 * x)
        val green = (argb ushr 8 and 0xFF) - 255 * (0.5 + 0.49 * y)
        assertTrue(abs(red) <= tolerance && abs(green) <= tolerance) { "($x, $y): %08x".format(argb) }
        assertTrue(argb and 0xFF < 30) { "a corner is read at ($x, $y): %08x".format(argb) }
    }

    /** At the edge of the picture, too: its axes turn with the direction to the point. */
    @Test
    fun rule_6_14_withPerspectiveTheEdgeOfASphereIsTheEdgeOfThePicture() {
        val sphere = Sphere(Vector3d(1.5, 0.8, 0.0), 1.0, Material())
        val camera = Camera.perspective(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 10.0)
        val image = picture(Scene(listOf(sphere)), camera)
        val inside = image.argb.indices.filter { image.primitive[it] == 0 }
        val (rights, ups) = inside.map { i ->
            (image.argb[i] ushr 16 and 0xFF) / 255.0 - 0.5 to (image.argb[i] ushr 8 and 0xFF) / 255.0 - 0.5
        }.unzip()

        // Both ends of both axes are reached, on all sides alike
        for (ends in listOf(rights.min(), -rights.max(), ups.min(), -ups.max())) assertEquals(-0.48, ends, 0.03)
        assertTrue(rights.zip(ups).maxOf { (x, y) -> sqrt(x * x + y * y) } < 0.5)
    }

    /** Points of a scene far away are relative to its origin, and so is the eye. */
    @Test
    fun rule_6_14_withPerspectiveASceneFarAwayLooksTheSame() {
        val positions = floatArrayOf(-1f, -1f, 0f, 1f, -1f, 0f, 1f, 1f, 0f, -1f, 1f, 0f)
        val normals = floatArrayOf(-1f, -1f, 1f, 1f, -1f, 1f, 1f, 1f, 1f, -1f, 1f, 1f)
        val pictures = listOf(Vector3d(), Vector3d(4000.0, -2000.0, 1000.0)).map { origin ->
            val mesh = Mesh(positions, intArrayOf(0, 1, 2, 0, 2, 3), Material(), normals, origin = origin)
            val eye = Vector3d(1.0, 0.5, 2.0).add(origin)
            picture(Scene(listOf(mesh)), Camera.perspective(eye, origin, Vector3d(0.0, 1.0, 0.0), 60.0, 0.5, 10.0))
        }
        assertEquals(pictures[0], pictures[1])
        assertTrue(pictures[0].argb.toSet().size > 100)
    }

    /** Bit for bit, as the contract has it, in single precision. */
    @Test
    fun rule_6_14_coloursAreThoseOfTheFormula() {
        val random = Random(614)
        val eye = Vector3d(1.0, 2.0, 5.0)
        val perspective = Camera.perspective(eye, Vector3d(), Vector3d(0.2, 1.0, 0.0), 60.0, 1.0, 10.0)
        val parallel = Camera.orthographic(eye, Vector3d(), Vector3d(0.2, 1.0, 0.0), 4.0, 1.0, 10.0)
        val origin = Vector3d(0.5, -0.25, 0.125)
        val tint = Rgba(0.9f, 0.8f, 0.7f, 0.6f)
        val fragment = Fragment()
        for (camera in listOf(perspective, parallel)) {
            val matcap = Matcap(texture, camera, origin, tint)
            repeat(500) {
                fun number() = 2 * random.nextFloat() - 1
                val n = FloatArray(3) { number() }
                val p = FloatArray(3) { number() }
                fragment.moveTo(0, 0)
                fragment.normalX = n[0]
                fragment.normalY = n[1]
                fragment.normalZ = n[2]
                fragment.worldX = p[0]
                fragment.worldY = p[1]
                fragment.worldZ = p[2]
                matcap.shade(fragment)
                val toEye = floatArrayOf(0.5f - p[0], 2.25f - p[1], 4.875f - p[2])
                val color = expected(camera, n, if (camera === perspective) toEye else null)
                val actual = listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha)
                val tinted = listOf(color[0] * tint.red, color[1] * tint.green, color[2] * tint.blue, tint.alpha)
                assertEquals(tinted, actual)
            }
        }
    }

    private fun expected(camera: Camera, normal: FloatArray, toEye: FloatArray?): FloatArray {
        fun along(x: Double, y: Double, z: Double, v: FloatArray): Float {
            val axis = camera.toWorldDirection(x, y, z)
            return axis.x.toFloat() * v[0] + axis.y.toFloat() * v[1] + axis.z.toFloat() * v[2]
        }
        fun inView(v: FloatArray) =
            floatArrayOf(along(1.0, 0.0, 0.0, v), along(0.0, 1.0, 0.0, v), along(0.0, 0.0, 1.0, v))
        fun length(v: FloatArray) = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
        val n = inView(normal)
        val far = toEye?.let { inView(it) }
        val v = if (far == null) floatArrayOf(0f, 0f, 1f) else FloatArray(3) { far[it] / length(far) }
        val e = sqrt(v[0] * v[0] + v[2] * v[2])
        val k = 0.49f / length(n)
        val s = (n[0] * v[2] - n[2] * v[0]) / e
        val t = (n[1] * (v[2] * v[2] + v[0] * v[0]) - v[1] * (n[0] * v[0] + n[2] * v[2])) / e
        return FloatArray(4).also { texture.sample(0.5f + k * s, 0.5f - k * t, it) }
    }

    @Test
    fun rule_6_14_withoutANormalTheMiddleIsShown() {
        val camera = Camera.fit().camera(Scene(listOf(Sphere(Vector3d(), 1.0, Material()))), 1.0)
        val fragment = Fragment()
        fragment.moveTo(0, 0)
        Matcap(texture, camera).shade(fragment)
        requireColor(0.0, 0.0, fragment.toArgb(), 2)
    }

    private companion object {
        const val SIDE = 64
    }
}
