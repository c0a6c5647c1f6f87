package dev.lazyz.world

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.asOpaque
import dev.lazyz.geometry.Box
import dev.lazyz.setup.setUp
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Meshes far from the world's origin keep their details. */
class OriginTest {
    /** A power of two, so that adding it to small integers and subtracting it again causes no rounding. */
    private val far = Vector3d(1048576.0, -4194304.0, 524288.0)

    @Test
    fun surfacesOfAllKindsAndLightsHaveTheirPlaceAroundTheOrigin() {
        val home = everything(Vector3d()).frame(64, 64)
        val away = everything(far).frame(64, 64)
        for (strategy in Renderers.builtIn) {
            val expected = strategy.render(home.asOpaque())
            val actual = strategy.render(away.asOpaque())
            assertTrue(expected.visible > 1000)
            assertEquals(expected.pixelHash(), actual.pixelHash(), strategy.id)
        }
    }

    @Test
    fun transformationsMoveTheOriginAlong() {
        val mesh = bumps(far)
        val back = mesh.transformed(Matrix4d().translation(-far.x, -far.y, -far.z))
        assertEquals(Vector3d(), back.origin)
        assertTrue(bumps(Vector3d()).positions.contentEquals(back.positions))

        val again = back.transformed(Matrix4d().translation(far.x, far.y, far.z))
        assertNotEquals(Vector3d(), again.origin)
        assertTrue(far.distance(again.origin) < 4.0)
        assertEquals(far.x - 1.0, again.bounds!!.minX)
    }

    @Test
    fun boxesThatAreFarAwayForTheirSizeHaveAnOrigin() {
        assertEquals(Vector3d(), Box(63.0, 0.0, 0.0, 64.0, 1.0, 1.0).origin())
        assertEquals(Vector3d(64.5, 0.5, 0.5), Box(64.0, 0.0, 0.0, 65.0, 1.0, 1.0).origin())
        assertEquals(Vector3d(0.5, 0.5, -64.5), Box(0.0, 0.0, -65.0, 1.0, 1.0, -64.0).origin())
        assertEquals(Vector3d(), Box(0.0, 0.0, 0.0, 0.0, 0.0, 0.0).origin())
    }

    @Test
    fun whatIsFartherAwayThanNumbersCanTellIsNotSeen() {
        val corners = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)
        for (away in listOf(1e17, 1e300, Double.MAX_VALUE)) {
            val mesh = Mesh(corners, intArrayOf(0, 1, 2), origin = Vector3d(away, away, away))
            for (x in listOf(0.0, -0.9 * away)) {
                val eye = Vector3d(x, 0.0, 5.0)
                val target = Vector3d(x, 0.0, 0.0)
                val camera = Camera.perspective(eye, target, Vector3d(0.0, 1.0, 0.0), 30.0, 1.0, 9.0)
                val frame = Scene(listOf(mesh, Sphere(target, 1.0)), viewpoint = camera).frame(8, 8)
                for (strategy in Renderers.builtIn) strategy.render(frame)
            }
        }
    }

    @Test
    fun originsAreFinite() {
        assertThrows(IllegalArgumentException::class.java) {
            Mesh(FloatArray(3), IntArray(0), origin = Vector3d(Double.NaN, 0.0, 0.0))
        }
        assertThrows(IllegalArgumentException::class.java) {
            setUp(Raster(1, 1), Camera.fit().camera(Scene(emptyList()), 1.0), emptyList(), Vector3d(0.0, 1e999, 0.0))
        }
        assertThrows(IllegalArgumentException::class.java) {
            setUp(Raster(1, 1), Camera.screen(), emptyList(), Vector3d(0.0, 1.0, 0.0))
        }
    }

    private fun everything(place: Vector3d): Scene {
        val hill = bumps(place)
        val other = bumps(Vector3d(place).add(1.0, 1.0, 0.0))
        val flag = listOf(Vector3d(0.0, 0.0, 0.0), Vector3d(1.0, 0.0, 0.0), Vector3d(0.0, 1.5, 0.0))
            .map { it.add(place) }.map { Vertex(it.x, it.y, it.z) }
        return Scene(
            listOf(
                hill, other, Sphere(Vector3d(place).add(0.5, 0.5, 0.5), 0.5), Polygon(listOf(flag)),
                Points(CORNERS, 5.0, origin = Vector3d(place).add(0.0, 0.5, 0.0)),
                Lines(CORNERS, intArrayOf(0, 1, 1, 2), 3.0, origin = Vector3d(place).add(0.0, 0.5, 0.0)),
            ),
            listOf(Light.Point(Vector3d(place).add(2.0, 4.0, 2.0), Rgba.WHITE)),
        ).withCameraAt(place)
    }

    private fun Scene.withCameraAt(place: Vector3d): Scene = withViewpoint(
        Camera.perspective(
            Vector3d(place).add(3.0, 4.0, 5.0), Vector3d(place), Vector3d(0.0, 1.0, 0.0), 30.0, 1.0, 20.0,
        ),
    )

    /** A hilly square with sides of two units around [place]. */
    private fun bumps(place: Vector3d): Mesh {
        val positions = FloatArray(3 * SIDE * SIDE)
        for (i in 0 until SIDE * SIDE) {
            val x = (i % SIDE - SIDE / 2) / (SIDE / 2).toDouble()
            val z = (i / SIDE - SIDE / 2) / (SIDE / 2).toDouble()
            val y = ((i * 7) % 5) / 16.0
            positions[3 * i] = x.toFloat()
            positions[3 * i + 1] = y.toFloat()
            positions[3 * i + 2] = z.toFloat()
        }
        val triangles = ArrayList<Int>()
        for (i in 0 until SIDE * SIDE) {
            if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1) continue
            triangles += listOf(i, i + SIDE, i + 1, i + 1, i + SIDE, i + SIDE + 1)
        }
        return Mesh(positions, triangles.toIntArray(), origin = place)
    }

    private companion object {
        const val SIDE = 17
        val CORNERS = floatArrayOf(-1f, 0f, 1f, 1f, 0.5f, 1f, 1f, 1f, -1f)
    }
}
