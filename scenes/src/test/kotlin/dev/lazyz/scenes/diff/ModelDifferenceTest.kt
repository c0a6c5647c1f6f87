package dev.lazyz.scenes.diff

import dev.lazyz.Rgba
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.diff.ModelDifference.Change
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.CutPlane
import dev.lazyz.scenes.pictures.NoPictureException
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.FittedViewpoint.View
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class ModelDifferenceTest {
    private val settings = PictureSettings(60, 40)

    /** A cube with sides of 2 around a point. */
    private fun cube(
        x: Double = 0.0,
        color: Rgba = Rgba.WHITE,
        name: String = "",
        origin: Vector3dc = Vector3d(),
        side: Float = 2f,
    ): Mesh {
        val corners = FloatArray(24) { i ->
            val sign = if (i / 3 shr i % 3 and 1 == 0) -side / 2 else side / 2
            if (i % 3 == 0) (x + sign).toFloat() else sign
        }
        return Mesh(corners, FACES, Material(color), origin = origin, name = name)
    }

    private fun model(vararg surfaces: Surface) =
        LoadedScene(Scene(surfaces.asList()), emptyList(), format = SceneFormat.OBJ)

    private fun between(old: LoadedScene, new: LoadedScene, asked: PictureSettings = settings) =
        ModelDifference.between(old, new, asked)

    private fun ModelDifference.counts() = Change.entries.filter { it != Change.SAME && count(it) > 0 }

    @Test
    fun modelsWithTheSameBitsAreEqual() {
        val first = between(model(cube()), model(cube()))
        assertTrue(first.isEqual)
        assertEquals(first.before, first.after)
        assertEquals(60L * 40, first.count(Change.SAME))

        // Neither the order of triangles nor the first corner matters
        val shuffled = FACES.toList().chunked(3).reversed().flatMap { (a, b, c) -> listOf(b, c, a) }.toIntArray()
        val other = Mesh(cube().positions, shuffled)
        assertTrue(between(model(cube()), model(other)).isEqual)

        val moved = cube().positions.clone().also { it[0] = Math.nextUp(it[0]) }
        val least = between(model(cube()), model(Mesh(moved, FACES)))
        assertFalse(least.isEqual)
        assertFalse(least.whole.isEqual)
    }

    @Test
    fun numbersAreThoseOfSolids() {
        val numbers = between(model(cube(side = 4f), cube(9.0)), model(cube(side = 4f), cube(9.0))).whole.before!!
        assertEquals(
            listOf(72.0, 120.0, -2.0, -2.0, -2.0, 10.0, 2.0, 2.0, 16.0, 24.0, 2.0, 0.0, 2.0, 0.0),
            Measure.entries.map { numbers[it] },
        )
        val open = Mesh(cube().positions, FACES.copyOf(33), Material())
        val difference = between(model(cube()), model(open))
        assertNull(difference.whole.after!![Measure.VOLUME])
        assertNull(difference.whole.difference(Measure.VOLUME))
        assertEquals(3.0, difference.whole.after!![Measure.OPEN_EDGES])
        assertNull(difference.whole.after!![Measure.HOLES])
        assertEquals(-2.0, difference.whole.difference(Measure.AREA))
        assertEquals(8.0, ModelNumbers(listOf(cube(origin = Vector3d(1e7, 0.0, 0.0))))[Measure.VOLUME])

        // Two halves of a cube, one of them relative to another origin
        val half = FACES.size / 2
        val far = cube(-5.0, origin = Vector3d(5.0, 0.0, 0.0))
        val halves = listOf(
            Mesh(cube().positions, FACES.copyOf(half)),
            Mesh(far.positions, FACES.copyOfRange(half, FACES.size), origin = far.origin),
        )
        assertEquals(8.0, ModelNumbers(halves)[Measure.VOLUME])

        // A ring, a triangle of it twisted to one point
        val ring = Mesh(
            FloatArray(3 * 4 * 3) { (it * it * 7 % 31).toFloat() },
            (0 until 12).flatMap { at ->
                val (next, up) = (at + 4) % 12 to at / 4 * 4 + (at + 1) % 4
                val far = (up + 4) % 12
                listOf(at, next, far, at, far, up)
            }.toIntArray() + intArrayOf(5, 5, 5),
        )
        val ofRing = ModelNumbers(listOf(ring, cube(9.0)))
        assertEquals(
            listOf(0.0, 2.0, 1.0),
            listOf(Measure.OPEN_EDGES, Measure.SHELLS, Measure.HOLES).map {
                ofRing[it]
            }
        )
        val broken = cube().positions.clone().also { it[0] = Float.NaN }
        assertNull(ModelNumbers(listOf(Mesh(broken, FACES)))[Measure.VOLUME])
        assertNull(ModelNumbers(emptyList())[Measure.MIN_X])
        Thread.currentThread().interrupt()
        assertThrows(InterruptedException::class.java) { ModelNumbers(listOf(cube())) }
    }

    @Test
    fun whatIsAddedAndRemovedIsSeen() {
        val one = model(cube())
        val two = model(cube(), cube(4.0))
        val more = between(one, two)
        assertEquals(listOf(Change.ADDED), more.counts())
        val less = between(two, one)
        assertEquals(listOf(Change.REMOVED), less.counts())
        assertEquals(more.count(Change.ADDED), less.count(Change.REMOVED))
        assertEquals(more.before, less.after, "one camera, which sees both")
        assertEquals(more.after, less.before)
        assertEquals(two.let { settings.frame(it).render(ZBufferRenderer()) }, more.after)
        assertFalse(more.isCropped)

        val x = (0 until 60).last { x -> (0 until 40).any { more.change(x, it) == Change.ADDED } }
        val y = (0 until 40).first { more.change(x, it) == Change.ADDED }
        val (red, green) = more.toImage().argb(x, y).let { (it shr 16 and 0xFF) to (it shr 8 and 0xFF) }
        assertEquals(0, red)
        assertTrue(green > 0x40)
        assertThrows(IllegalArgumentException::class.java) { more.change(60, 0) }
    }

    @Test
    fun anotherPlaceIsMovedAndAnotherColourRecolored() {
        val front = settings.with(PictureParameters.VIEW, View.FRONT)
        val old = model(cube(), cube(side = 1f))
        val deeper = between(old, model(cube(), cube(side = 1f).let { nearer(it) }), front)
        assertEquals(listOf(Change.MOVED), deeper.counts())
        val (flat, turned) = listOf(0f, 1e-6f).map { x ->
            Mesh(cube().positions, FACES, Material(), FloatArray(24) { if (it % 3 == 2) 1f else x })
        }
        assertEquals(listOf(Change.MOVED), between(model(flat), model(turned), front).counts(), "the normal alone")
        val red = between(model(cube()), model(cube(color = Rgba.ofRgb(0xFF0000))), front)
        assertEquals(listOf(Change.RECOLORED), red.counts())
        assertTrue(red.whole.isEqual)
        assertFalse(red.isEqual)
    }

    /** Returns [mesh], 1.5 nearer to the front. */
    private fun nearer(mesh: Mesh) =
        Mesh(FloatArray(24) { mesh.positions[it] + if (it % 3 == 2) 1.5f else 0f }, mesh.triangles, mesh.material)

    /** Lines and the shadow on the ground are shown, but do not hide what happened to the surfaces. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun linesAndShadowsMoveNothing() {
        val (old, new) = model(cube(), cube(4.0)) to model(cube(), cube(5.0))
        val plain = between(old, new)
        val extras = listOf(PictureParameters.EDGES, PictureParameters.GROUND_SHADOW)
        for (asked in extras.map { settings.with(it, true) }) {
            val drawn = between(old, new, asked)
            for (change in listOf(Change.ADDED, Change.REMOVED, Change.MOVED)) {
                if (asked[PictureParameters.GROUND_SHADOW] == true && change != Change.MOVED) {
                    assertTrue(drawn.count(change) > 0)
                } else {
                    assertEquals(plain.count(change), drawn.count(change), "$asked $change")
                }
            }
            assertTrue(drawn.count(Change.RECOLORED) > plain.count(Change.RECOLORED), "$asked")
            assertTrue(drawn.before.visible > plain.before.visible, "$asked")
        }
    }

    /** What is measured of one model alone would change what did not change. */
    @Test
    fun lightCutsAndCameraAreThoseOfBoth() {
        val dark = Rgba.ofRgb(0x101010)
        val light = between(model(cube(color = dark)), model(cube(color = dark), cube(4.0)))
        assertEquals(listOf(Change.ADDED), light.counts())
        val cut = settings.with(PictureParameters.CUT, listOf(CutPlane.parse("y=50%")!!))
        val high = between(model(cube()), model(cube(), nearer(cube())), cut)
        assertEquals(0, high.count(Change.REMOVED))
        val up = between(
            Scenes.load(STL.toByteArray(), SceneFormat.STL), Scenes.load(OBJ.toByteArray(), SceneFormat.OBJ),
        )
        assertEquals(0, up.count(Change.MOVED) + up.count(Change.ADDED), "z stays up in another format")
    }

    @Test
    fun partsAreMatchedByNameAndThenByOrder() {
        val old = model(cube(name = "a"), cube(3.0, name = "b"), cube(6.0, name = "a"), cube(9.0))
        val new = model(cube(3.0, name = "b"), cube(name = "a"), cube(7.0, name = "a"), cube(12.0, name = "c"))
        val parts = between(old, new).parts
        assertEquals(listOf("a", "b", "a (2)", "unnamed", "c"), parts.map { it.name })
        assertEquals(listOf(true, true, false, false, false), parts.map { it.isEqual })
        assertEquals(1.0, parts[2].difference(Measure.MAX_X))
        assertNull(parts[3].after)
        assertNull(parts[4].before)
        assertNull(parts[4].difference(Measure.AREA))
    }

    /** There are so many because one mesh is there 2400 times. */
    @Test
    fun moreTrianglesThanAnArrayHasEdgesAreRefused() {
        val mesh = Mesh(FloatArray(3), IntArray(900_000))
        val refused = assertThrows(NoPictureException::class.java) { ModelNumbers(List(2400) { mesh }) }
        assertEquals("models are compared up to 715827879 triangles, and one has 720000000", refused.message)
    }

    private companion object {
        val FACES = intArrayOf(
            0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
        )
        const val STL = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n" +
            "endfacet\nendsolid\n"
        const val OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    }
}
