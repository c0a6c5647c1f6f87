package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.spi.Fragment
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Contract rule 6.9: maps. */
class MapsTest {
    private val camera = Camera.orthographic(
        Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 9.0,
    )

    /** A texture of one row of linear codes, 0xRRGGBB. */
    private fun row(vararg codes: Int) = Texture(
        codes.size, 1, codes.map { it or (0xFF shl 24) }.toIntArray(), Texture.Filter.NEAREST,
        encoding = Texture.Encoding.LINEAR,
    )

    /** A square that faces the camera; u to the right, v downward. Its second set has u and v exchanged. */
    private fun square(material: Material, isTurned: Boolean = false): Mesh = Mesh(
        floatArrayOf(-2f, -2f, 0f, 2f, -2f, 0f, 2f, 2f, 0f, -2f, 2f, 0f),
        if (isTurned) intArrayOf(2, 1, 0, 3, 2, 0) else intArrayOf(0, 1, 2, 0, 2, 3),
        material,
        FloatArray(12) {
            if (it % 3 < 2) {
                0f
            } else if (isTurned) {
                -1f
            } else {
                1f
            }
        },
        floatArrayOf(0f, 1f, 1f, 1f, 1f, 0f, 0f, 0f),
        uvs2 = floatArrayOf(1f, 0f, 1f, 1f, 0f, 1f, 0f, 0f),
    )

    /** The linear colour at column [x], row [y] of 4 x 4. */
    private fun seen(mesh: Mesh, x: Int, y: Int, vararg lights: Light): Rgba {
        val scene = Scene(listOf(mesh), lights.toList(), camera)
            .withEnvironment(Environment.NONE).withToneMapping(ToneMapping.NONE)
        val fragment = Fragment()
        for (primitive in scene.frame(4, 4).primitives) {
            val spans = dev.lazyz.spi.Spans()
            if (y in primitive.rowStart until primitive.rowEnd) primitive.spans(y, spans)
            if ((0 until spans.count).none { x in spans.start(it) until spans.end(it) }) continue
            fragment.moveTo(x, y)
            primitive.shade(fragment)
            return Rgba(fragment.red, fragment.green, fragment.blue)
        }
        error("no primitive at $x, $y")
    }

    private fun sun(x: Double, y: Double, z: Double) = Light.Directional(Vector3d(-x, -y, -z), Rgba.WHITE)

    /** The normal of [material] at the middle, by Lambert's law from six sides. */
    private fun normal(mesh: Mesh): List<Float> = listOf(
        Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, 0.0, 1.0),
    ).map { axis ->
        seen(mesh, 1, 1, sun(axis.x, axis.y, axis.z)).red - seen(mesh, 1, 1, sun(-axis.x, -axis.y, -axis.z)).red
    }

    private fun assertNormal(x: Double, y: Double, z: Double, mesh: Mesh) {
        val expected = Vector3d(x, y, z).normalize()
        val actual = normal(mesh)
        for (k in 0 until 3) assertEquals(expected[k], actual[k].toDouble(), 1e-5, "$actual instead of $expected")
    }

    private fun bumpy(code: Int, map: (Texture) -> TextureMap = { TextureMap(it) }, scale: Float = 1f) =
        Material().withNormalMap(NormalMap(map(row(code)), scale))

    /** The components of a code, from -1 to 1. */
    private fun part(code: Int): Double = 2.0 * code / 255 - 1.0

    @Test
    fun rule_6_9_aNormalIsRightUpAndOut() {
        val x = part(0xC0)
        val y = part(0xA0)
        val z = part(0xE0)
        assertNormal(x, y, z, square(bumpy(0xC0A0E0)).withTangents())
        assertNormal(2 * x, 2 * y, z, square(bumpy(0xC0A0E0, scale = 2f)).withTangents())
        assertNormal(0.0, 0.0, 1.0, square(bumpy(0xC0A0E0)))
    }

    @Test
    fun rule_6_9_tangentsAreOfTheMapsOwnCoordinates() {
        val x = part(0xC0)
        val y = part(0xA0)
        val z = part(0xE0)
        // In the second set, u increases downward and v to the right: right of the map is down, and up of the map is
        // left
        val second = square(bumpy(0xC0A0E0, { TextureMap(it, 1) })).withTangents(1)
        assertNormal(-y, -x, z, second)
        // A quarter turn: u' = v, v' = -u, so right of the map is down, and up of the map is right
        val turn = UvTransform(rotation = 90.0)
        assertNormal(y, -x, z, square(bumpy(0xC0A0E0, { TextureMap(it, 0, turn) })).withTangents(0, turn))
    }

    @Test
    fun rule_6_9_mirroredSeamsAreSplit() {
        // Two squares beside each other; u runs from the middle outward on both
        val mesh = Mesh(
            floatArrayOf(-1f, 0f, 0f, 0f, 0f, 0f, 0f, 1f, 0f, -1f, 1f, 0f, 1f, 0f, 0f, 1f, 1f, 0f),
            intArrayOf(0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2),
            Material(),
            FloatArray(18) { if (it % 3 < 2) 0f else 1f },
            floatArrayOf(1f, 1f, 0f, 1f, 0f, 0f, 1f, 0f, 1f, 1f, 1f, 0f),
        ).withTangents()
        assertEquals(8, mesh.vertexCount)
        val tangents = mesh.tangents!!
        for ((i, vertex) in mesh.triangles.withIndex()) {
            val expected = if (i < 6) listOf(-1f, 0f, 0f, -1f) else listOf(1f, 0f, 0f, 1f)
            assertEquals(expected, tangents.slice(4 * vertex until 4 * vertex + 4).map { it + 0f }, "corner $i")
        }
    }

    @Test
    fun rule_6_9_occlusionDarkensIndirectLightOnly() {
        val map = OcclusionMap(TextureMap(row(0x660000)), 0.5f)
        val factor = 1f + 0.5f * (0x66 / 255f - 1f)
        val ambient = Light.Ambient(Rgba(0.5f, 0.25f, 1f))
        for (plain in listOf(Material(), Material().withMetallicRoughness(MetallicRoughness(0.5f, 0.5f)))) {
            val occluded = plain.withOcclusionMap(map)
            val expected = seen(square(plain), 1, 1, ambient)
            val actual = seen(square(occluded), 1, 1, ambient)
            assertEquals(expected.red * factor, actual.red, 1e-6f)
            val sun = sun(0.0, 0.0, 1.0)
            assertEquals(seen(square(plain), 1, 1, sun), seen(square(occluded), 1, 1, sun))
        }
    }
}
