package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SceneTest {
    private fun square(origin: Vector3d): Mesh {
        val corners = floatArrayOf(-1f, -1f, 0f, 1f, -1f, 0f, 1f, 1f, 0f, -1f, 1f, 0f)
        return Mesh(corners, intArrayOf(0, 1, 2, 0, 2, 3), Material(), origin = origin)
    }

    @Test
    fun addedTexturesNeedCoordinates() {
        val red = Texture(1, 1, intArrayOf(0xFFFF0000.toInt()))
        val bare = square(Vector3d())
        val placed = Mesh(bare.positions, bare.triangles, uvs = FloatArray(8))
        val points = Points(bare.positions, 1.0)
        fun textures(scene: Scene) = scene.surfaces.map {
            when (it) {
                is Mesh -> it.material.texture
                is Points -> it.material.texture
                else -> (it as Sphere).material.texture
            }
        }

        val painted = Scene(listOf(bare, placed, points, Sphere(Vector3d(), 1.0))).withMaterials { it.withTexture(red) }
        assertEquals(listOf(null, red, null, red), textures(painted))
        for (surfaces in listOf(listOf(bare), listOf(points, bare))) {
            val error = assertThrows(IllegalArgumentException::class.java) {
                Scene(surfaces).withMaterials { it.withTexture(red) }
            }
            assertTrue("none of the ${surfaces.size} surfaces" in error.message!!, error.message)
        }
        val second = TextureMap(red, uvSet = 1)
        assertThrows(IllegalArgumentException::class.java) {
            Scene(listOf(placed)).withMaterials { it.withEmissionMap(second) }
        }

        // What was there before stays: its coordinates count as (0, 0)
        val given = Scene(listOf(Mesh(bare.positions, bare.triangles, Material(texture = red))))
        assertEquals(listOf(red), textures(given.withMaterials { it.withBaseColor(Rgba.BLACK) }))
        assertEquals(emptyList<Surface>(), Scene(emptyList()).withMaterials { it.withTexture(red) }.surfaces)
    }

    /** Answers that name the point and the normal. */
    private val named = AmbientVisibility { x, y, z, nx, ny, nz ->
        x + 10f * y + 100f * z + 1000f * nx + 10_000f * ny + 100_000f * nz
    }

    private fun assertTurns(scene: Scene, up: UpAxis, shift: Vector3d) {
        val point = Vector3d(1.0, 2.0, 3.0).add(shift)
        val turned = scene.withUpAxis(up)
        val p = up.toWorld(point).add(up.toWorld(scene.origin)).sub(turned.origin)
        val n = up.toWorld(Vector3d(4.0, 5.0, 6.0))
        val answer = turned.ambientVisibility!!.at(
            p.x.toFloat(), p.y.toFloat(), p.z.toFloat(), n.x.toFloat(), n.y.toFloat(), n.z.toFloat(),
        )
        val expected = named.at(point.x.toFloat(), point.y.toFloat(), point.z.toFloat(), 4f, 5f, 6f)
        assertEquals(expected, answer) { "$up" }
    }

    /** A custom surface can become one with an origin; points are relative to the origin of their scene. */
    @Test
    fun theVisibilityIsAskedAboutPointsRelativeToItsOwnOrigin() {
        val home = Vector3d(8.0, 16.0, 32.0)
        val custom = object : Surface {
            override val bounds: Box? = null

            override fun primitives(setUp: SetUp): Sequence<Primitive> = emptySequence()

            override fun withUpAxis(up: UpAxis): Surface = square(home).withUpAxis(up)
        }
        for (up in UpAxis.entries) assertTurns(Scene(listOf(custom)).withAmbientVisibility(named), up, home)
    }

    @Test
    fun aTurnedSceneWithHollowsLooksTheSame() {
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 3.0, 1.0, 8.0)
        val light = listOf(Light.Ambient(Rgba.WHITE))
        val scene = Scene(listOf(square(Vector3d())), light, camera)
        val hollow = scene.withAmbientVisibility { x, y, _, _, _, _ -> if (x > 0.1f && y > -0.3f) 0.25f else 1f }
        val expected = ZBufferRenderer().render(hollow.frame(40, 40))
        assertNotEquals(expected, ZBufferRenderer().render(scene.frame(40, 40)))
        for (up in UpAxis.entries) {
            assertEquals(expected, ZBufferRenderer().render(hollow.withUpAxis(up).frame(40, 40))) { "$up" }
        }
    }
}
