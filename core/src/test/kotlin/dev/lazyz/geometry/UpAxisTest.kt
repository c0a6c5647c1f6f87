package dev.lazyz.geometry

import dev.lazyz.Rgba
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class UpAxisTest {
    private val positions = floatArrayOf(0.1f, 0.2f, 0.3f, 1f, 0f, 0f, 0f, 1f, Float.POSITIVE_INFINITY)
    private val turned = floatArrayOf(0.1f, 0.3f, -0.2f, 1f, 0f, -0f, 0f, Float.POSITIVE_INFINITY, -1f)

    private fun turn(surface: Surface) = Scene(listOf(surface)).withUpAxis(UpAxis.Z).surfaces.single()

    @Test
    fun meshesTurnWithoutRounding() {
        val mesh = turn(Mesh(positions, intArrayOf(0, 1, 2), normals = positions)) as Mesh
        assertArrayEquals(turned, mesh.positions)
        assertArrayEquals(turned, mesh.normals)
        assertArrayEquals(intArrayOf(0, 1, 2), mesh.triangles)
    }

    @Test
    fun spheresAndPolygonsTurn() {
        assertEquals(Vector3d(1.0, 3.0, -2.0), (turn(Sphere(Vector3d(1.0, 2.0, 3.0), 4.0)) as Sphere).center)
        val corner = (turn(Polygon(listOf(listOf(Vertex(1.0, 2.0, 3.0, 4f, 5f))))) as Polygon).contours[0][0]
        assertEquals(listOf(1.0, 3.0, -2.0), listOf(corner.x, corner.y, corner.z))
        assertEquals(listOf(4f, 5f), listOf(corner.u, corner.v))
    }

    @Test
    fun pointsAndLinesTurn() {
        val points = turn(Points(positions, 3.0, normals = positions)) as Points
        assertArrayEquals(turned, points.positions)
        assertArrayEquals(turned, points.normals)
        assertEquals(3.0, points.size)
        val lines = turn(Lines(positions, intArrayOf(0, 2), 3.0)) as Lines
        assertArrayEquals(turned, lines.positions)
        assertArrayEquals(intArrayOf(0, 2), lines.segments)
        assertEquals(3.0, lines.width)
    }

    @Test
    fun aCustomSurfaceThatCannotTurnIsRefused() {
        val unknown = object : Surface {
            override val bounds = null

            override fun primitives(setUp: SetUp) = emptySequence<Nothing>()
        }
        assertThrows(UnsupportedOperationException::class.java) { turn(unknown) }
        assertSame(unknown, unknown.withUpAxis(UpAxis.Y))
    }

    @Test
    fun aSceneWithItsOwnCameraAndLightsLooksTheSame() {
        val ball = Sphere(Vector3d(0.0, 0.0, 0.0), 1.0)
        val small = Sphere(Vector3d(0.5, 1.0, 0.25), 0.25)
        val lights = listOf(
            Light.Ambient(Rgba(0.1f, 0.1f, 0.1f)),
            Light.Directional(Vector3d(0.0, 0.0, -1.0), Rgba(0.5f, 0f, 0f)),
            Light.Point(Vector3d(4.0, 4.0, 0.0), Rgba(0f, 0.5f, 0f)),
        )
        val eye = Vector3d(0.0, 8.0, 0.0)
        val up = Vector3d(0.0, 0.0, 1.0)
        for (camera in listOf(
            Camera.perspective(eye, Vector3d(), up, 20.0, 1.0, 20.0),
            Camera.orthographic(eye, Vector3d(), up, 3.0, 1.0, 20.0),
        )) {
            val scene = Scene(listOf(ball, small), lights, camera)
            val upright = scene.withUpAxis(UpAxis.Z)
            assertEquals(ZBufferRenderer().render(scene.frame(60, 60)), ZBufferRenderer().render(upright.frame(60, 60)))
        }
    }

    /** Each rotation puts its axis on top, keeps lengths, and does not mirror. */
    @Test
    fun allSixAxesTurnUp() {
        val axes = listOf(Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, 1.0, 0.0), Vector3d(0.0, 0.0, 1.0))
        for (up in UpAxis.entries) {
            val (x, y, z) = axes.map(up::toWorld)
            assertEquals(0.0, Vector3d(x).cross(y).distance(z), "$up is a rotation")
            val name = up.id.removePrefix("-")
            val axis = Vector3d(axes["xyz".indexOf(name)]).mul(if (up.id == name) 1.0 else -1.0)
            assertEquals(1.0, up.toWorld(axis).y, "$up is on top")
            val numbers = up.toWorld(floatArrayOf(1f, 2f, 3f, 4f, 5f, 6f)).map { it.toDouble() }
            val last = up.toWorld(Vector3d(4.0, 5.0, 6.0))
            assertEquals(Vector3d(4.0, 5.0, 6.0), up.toModel(last))
            assertEquals(listOf(last.x, last.y, last.z), numbers.drop(3), "$up of arrays")
        }
    }

    @Test
    fun aSceneOnTheScreenCannotTurn() {
        val scene = Scene(emptyList(), viewpoint = Camera.screen())
        assertThrows(UnsupportedOperationException::class.java) { scene.withUpAxis(UpAxis.Z) }
    }
}
