package dev.lazyz.shading

import dev.lazyz.GridPoint
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.samples
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.spi.Fragment
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import java.util.Random
import kotlin.math.abs
import kotlin.math.sqrt
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/**
 * An independent implementation of contract rules 3.6 and 6.5, equal bit for bit: light at vertices, interpolated
 * colours, light at samples.
 */
class VertexLightingTest {
    private class Vector(val x: Float, val y: Float, val z: Float) {
        val length: Float get() = sqrt(dot(this))

        fun dot(other: Vector): Float = x * other.x + y * other.y + z * other.z

        fun unit(): Vector = length.let { Vector(x / it, y / it, z / it) }

        operator fun plus(other: Vector) = Vector(x + other.x, y + other.y, z + other.z)

        operator fun minus(other: Vector) = Vector(x - other.x, y - other.y, z - other.z)
    }

    private val lights = listOf(
        Light.Ambient(Rgba(0.1f, 0.05f, 0.2f)),
        Light.Directional(Vector3d(-1.0, -2.0, -3.0), Rgba(0.7f, 0.6f, 0.5f)),
        Light.Point(Vector3d(2.0, 2.0, 2.0), Rgba(0.2f, 1.3f, 0.4f)),
        Light.Directional(Vector3d(0.0, 0.0, 1.0), Rgba(9f, 9f, 9f)),
        Light.Ambient(Rgba(0.03f, 0.07f, 0f)),
    )
    private val cameras = listOf(
        Camera.perspective(Vector3d(0.3, 0.4, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 1.0, 10.0),
        Camera.orthographic(Vector3d(0.3, 0.4, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 3.0, 1.0, 10.0),
    )

    private fun vector(v: Vector3dc) = Vector(v.x().toFloat(), v.y().toFloat(), v.z().toFloat())

    private fun components(color: Rgba) = floatArrayOf(color.red, color.green, color.blue)

    private fun power(base: Float, exponent: Int): Float = generateSequence(base) { it * it }.take(11)
        .filterIndexed { bit, _ -> exponent shr bit and 1 == 1 }.reduce { product, square -> product * square }

    /** Rule 6.5 at a point whose normal points to the viewer; returns red, green and blue. */
    private fun lit(material: Material, camera: Camera, at: Vector, normal: Vector, surface: FloatArray): FloatArray {
        val toViewer = if (camera.projection is Projection.Perspective) {
            (vector(camera.eye) - at).unit()
        } else {
            vector(camera.toWorldDirection(0.0, 0.0, 1.0))
        }
        val n = normal.unit()
        val diffuse = FloatArray(3)
        val added = components(material.emission)
        for (light in lights) {
            if (light is Light.Ambient) for (k in 0 until 3) diffuse[k] += components(light.color)[k]
        }
        for (light in lights) {
            val toLight = when (light) {
                is Light.Ambient -> continue
                is Light.Directional -> Vector(0f, 0f, 0f) - vector(light.direction)
                is Light.Point -> (vector(light.position) - at).unit()
                is Light.Spot -> error("not in this test: $light")
            }
            val cosine = n.dot(toLight)
            if (cosine <= 0f) continue
            val halfway = toLight + toViewer
            val highlight = if (material.shading == Shading.PHONG) {
                2f * cosine * n.dot(toViewer) - toLight.dot(toViewer)
            } else {
                n.dot(halfway) / halfway.length
            }
            for (k in 0 until 3) {
                val color = components(light.color)[k]
                diffuse[k] += color * cosine
                if (highlight > 0f) {
                    added[k] += color * components(material.specular)[k] * power(highlight, material.shininess)
                }
            }
        }
        return FloatArray(3) { surface[it] * components(material.baseColor)[it] * diffuse[it] + added[it] }
    }

    private fun material(shading: Shading, random: Random) = Material(
        Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat(), 0.25f + random.nextFloat() / 2), null, shading,
        Rgba(0.5f, 0.4f, 0.3f), 1 + random.nextInt(50), Rgba(0.01f, 0.2f, 0.03f), AlphaMode.BLEND,
    )

    /** Asserts that a triangle's [colors] at its vertices, four numbers each, are interpolated by rule 3.6. */
    private fun assertInterpolated(primitive: PlanarPrimitive, colors: List<List<Float>>, raster: Raster): Int {
        val covered = primitive.samples(raster)
        val t = primitive.reference
        val (a, b, c) = listOf(GridPoint(t.x0, t.y0), GridPoint(t.x1, t.y1), GridPoint(t.x2, t.y2))
        val fragment = Fragment()
        var samples = 0
        for (y in 0 until raster.height) {
            for (x in 0 until raster.width) {
                if (!covered[x, y]) continue
                samples++
                val sample = GridPoint(256 * x + 128, 256 * y + 128)
                val parts = listOf(sample.side(b, c), sample.side(c, a), sample.side(a, b))
                    .mapIndexed { i, area -> abs(area).toDouble() * (1.0 / primitive.vertices.get(i, Vertices.W)) }
                val scale = 1.0 / (parts[0] + parts[1] + parts[2])
                val expected = List(4) { k ->
                    val (first, second, third) = List(3) { parts[it] * scale * colors[it][k].toDouble() }
                    (first + second + third).toFloat()
                }
                fragment.moveTo(x, y)
                primitive.shade(fragment)
                val actual = listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha)
                assertEquals(expected, actual) { "column $x, row $y" }
            }
        }
        return samples
    }

    @Test
    fun rule_6_5_gouraudShadingToTheBit() {
        val random = Random(1971)
        var samples = 0
        repeat(60) { round ->
            val positions = FloatArray(9) { (random.nextFloat() * 2 - 1) * if (it % 3 == 2) 0.1f else 1.2f }
            val normals = FloatArray(9) { if (it % 3 == 2) 0.6f + random.nextFloat() else random.nextFloat() - 0.5f }
            val colors = FloatArray(12) { random.nextFloat() }
            val material = material(Shading.GOURAUD, random)
            val camera = cameras[round % 2]
            val expected = List(3) { i ->
                val at = Vector(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2])
                val normal = Vector(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2])
                val surface = colors.copyOfRange(4 * i, 4 * i + 4)
                lit(material, camera, at, normal, surface).toList() + surface[3] * material.baseColor.alpha
            }
            for (sign in listOf(1f, -1f)) {
                // Normals that point away from the viewer are all reversed together
                val turned = FloatArray(9) { sign * normals[it] }
                val mesh = Mesh(positions, intArrayOf(0, 1, 2), material, turned, null, colors)
                val frame = Scene(listOf(mesh), lights, camera).frame(24, 24)
                val primitive = frame.primitives.single() as? PlanarPrimitive ?: continue
                samples += assertInterpolated(primitive, expected, frame.raster)
            }
        }
        assertTrue(samples > 3000) { "$samples" }
    }

    @Test
    fun rule_6_5_shadingAtSamplesToTheBit() {
        val random = Random(1975)
        val fragment = Fragment()
        var samples = 0
        repeat(40) { round ->
            val positions = FloatArray(9) { (random.nextFloat() * 2 - 1) * if (it % 3 == 2) 0.5f else 1.2f }
            val normals = FloatArray(9) { random.nextFloat() * 2 - 1 }
            val colors = FloatArray(12) { random.nextFloat() }
            val material = material(if (round / 2 % 2 == 0) Shading.PHONG else Shading.BLINN_PHONG, random)
            val camera = cameras[round % 2]
            val mesh = Mesh(positions, intArrayOf(0, 1, 2), material, normals, colors = colors)
            val frame = Scene(listOf(mesh), lights, camera).frame(24, 24)
            val primitive = frame.primitives.single()
            val covered = primitive.samples(frame.raster)
            for (place in 0 until 24 * 24) {
                if (!covered[place % 24, place / 24]) continue
                samples++
                fragment.moveTo(place % 24, place / 24)
                primitive.shade(fragment)
                val at = Vector(fragment.worldX, fragment.worldY, fragment.worldZ)
                val normal = Vector(fragment.normalX, fragment.normalY, fragment.normalZ)
                val surface = floatArrayOf(fragment.vertexRed, fragment.vertexGreen, fragment.vertexBlue)
                assertEquals(
                    lit(material, camera, at, normal, surface).toList(),
                    listOf(fragment.red, fragment.green, fragment.blue),
                )
                assertEquals(fragment.vertexAlpha * material.baseColor.alpha, fragment.alpha)
            }
        }
        assertTrue(samples > 500) { "$samples" }
    }

    @Test
    fun rule_6_5_flatShadingToTheBit() {
        val random = Random(1974)
        var samples = 0
        repeat(40) { round ->
            val positions = FloatArray(9) { if (it % 3 == 2) 0.3f else (random.nextFloat() * 2 - 1) * 1.2f }
            val colors = FloatArray(12) { random.nextFloat() }
            val material = material(Shading.FLAT, random)
            val camera = cameras[round % 2]
            val (x, y, z) = List(3) { k ->
                val sum = positions[k].toDouble() + positions[3 + k].toDouble() + positions[6 + k].toDouble()
                (sum / 3).toFloat()
            }
            val expected = List(3) { i ->
                val surface = colors.copyOfRange(4 * i, 4 * i + 4)
                val color = lit(material, camera, Vector(x, y, z), Vector(0f, 0f, 1f), surface)
                color.toList() + surface[3] * material.baseColor.alpha
            }
            val mesh = Mesh(positions, intArrayOf(0, 1, 2), material, colors = colors)
            val frame = Scene(listOf(mesh), lights, camera).frame(24, 24)
            val primitive = frame.primitives.single() as? PlanarPrimitive ?: return@repeat
            samples += assertInterpolated(primitive, expected, frame.raster)
        }
        assertTrue(samples > 1000) { "$samples" }
    }
}
