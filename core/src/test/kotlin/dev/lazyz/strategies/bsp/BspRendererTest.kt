package dev.lazyz.strategies.bsp

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.behindAll
import dev.lazyz.setup.triangleBatch
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import kotlin.random.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotSame
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class BspRendererTest {
    /** How many fragments on covered samples the tree decides, and for how many depths are compared. */
    private class Decided {
        var byTree = 0L
        var byDepth = 0L

        /** Adds those of a frame that shows no background in front of a primitive. */
        fun add(frame: Frame) {
            val image = BspRenderer().render(frame)
            assertEquals(ListsRenderer().render(frame), image, "$frame")
            val compared = (image.counters.depthEvaluations - image.visible) / 2
            byDepth += compared
            byTree += image.counters.fragments - image.visible - compared
        }

        override fun toString() = "$byTree by the tree, $byDepth by depth"
    }

    /** A sheet of 2 [n]^2 triangles over -1..1 in x and y, whose height is [z]. */
    private fun sheet(n: Int, material: Material = Material(), z: (x: Double, y: Double) -> Double): Mesh =
        SampleScenes.sheet(n + 1, material) { column, row, axis ->
            val (x, y) = 2.0 * column / n - 1 to 2.0 * row / n - 1
            listOf(x, y, z(x, y))[axis]
        }

    private fun camera(random: Random): Camera {
        val eye = Vector3d(random.nextDouble(-3.0, 3.0), random.nextDouble(-3.0, 3.0), random.nextDouble(-3.0, 3.0))
        val up = Vector3d(0.1, 1.0, 0.2)
        val far = listOf(10.0, 1e4, 1e7).random(random)
        return when (random.nextInt(4)) {
            0 -> Camera.orthographic(eye, Vector3d(), up, random.nextDouble(1.0, 4.0), 0.1, far)
            1 -> Camera.orthographic(Vector3d(0.0, 0.0, 2.0), Vector3d(), up, 2.0, 0.0, far)
            else -> Camera.perspective(eye, Vector3d(), up, random.nextDouble(10.0, 90.0), 0.1, far)
        }
    }

    private fun raster(random: Random, side: Int): Raster {
        val test = DepthTest.entries.random(random)
        val convention = DepthConvention.entries.random(random)
        val background = if (random.nextInt(4) == 0) random.nextInt(Int.MAX_VALUE) else test.behindAll
        return Raster(1 + random.nextInt(side), 1 + random.nextInt(side), Rgba.WHITE, convention, test, background)
    }

    /** Sheets that nearly coincide, cross, and touch in one plane; soup; other surfaces. */
    private fun hardScene(random: Random): Scene {
        val scene = Scene.builder()
        if (random.nextInt(4) == 0) scene.add(Mesh(FloatArray(0), IntArray(0)))
        repeat(1 + random.nextInt(4)) {
            val gap = listOf(0.0, 1e-6, 1e-4, 1e-2, 0.3).random(random)
            val slope = listOf(0.0, 1.0, 1e-5).random(random)
            val bend = if (random.nextBoolean()) 0.0 else random.nextDouble()
            scene.add(sheet(1 + random.nextInt(9)) { x, y -> it * gap + slope * x + bend * StrictMath.sin(5 * x + y) })
        }
        if (random.nextBoolean()) scene.add(SampleScenes.soup(java.util.Random(random.nextLong()), 20, Material(), 1.5))
        if (random.nextInt(4) == 0) scene.add(Sphere(Vector3d(0.2, 0.1, 0.0), 0.6, Material()))
        if (random.nextInt(4) == 0) {
            val glass = Material(Rgba.WHITE.withAlpha(0.5f), alphaMode = AlphaMode.BLEND)
            scene.add(sheet(3, glass) { x, y -> x * y })
            scene.add(sheet(2, glass) { x, y -> x + y })
        }
        return scene.build()
    }

    @Test
    fun rule_7_1_whereSnappingMovesTrianglesAcrossPlanesDepthsAreCompared() {
        for (seed in 0 until 300) {
            val random = Random(seed)
            val scene = hardScene(random)
            repeat(3) {
                val raster = raster(random, listOf(3, 20, 90).random(random))
                val frame = scene.withViewpoint(camera(random)).frame(raster)
                assertEquals(ListsRenderer().render(frame), BspRenderer().render(frame), "$seed $it $raster")
                val x = random.nextInt(raster.width)
                val y = random.nextInt(raster.height)
                val part = frame.within(Region(x, y, x + 1 + random.nextInt(raster.width - x), y + 1))
                assertEquals(ListsRenderer().render(part), BspRenderer().render(part), "$seed $it $part")
            }
        }
    }

    /** Triangles that are a grid step wide have one depth, which is not that of their planes. */
    @Test
    fun rule_3_4_sliversAreComparedByTheirOneDepth() {
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 2.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 0.5, 3.5)
        var steep = 0
        for (seed in 0 until 200) {
            val random = Random(seed)
            val positions = FloatArray(9 * 40) {
                val reach = if (it % 3 == 0 && it < 9 * 20) 0.01 else 1.5
                (random.nextDouble(-1.0, 1.0) * reach).toFloat()
            }
            val mesh = Mesh(positions, IntArray(3 * 40) { it })
            val frame = Scene(listOf(mesh), viewpoint = camera).frame(Raster(15, 40))
            assertEquals(ListsRenderer().render(frame), BspRenderer().render(frame), "$seed")
            val samples = OwnedSamples(frame, Coherence.DIRECT, Counters.Builder())
            steep += ListPriority(frame, listOf(frame.content.triangleBatch(0)), samples).apply { draw() }.steep.size
        }
        assertTrue(steep > 200, "$steep")
    }

    /** The figures of docs/algorithms/bsp.md. */
    @Test
    fun theTreeDecidesMostOfATurntable() {
        val shells = listOf(0.5, 0.7, 0.9).map { ball(40, it) }
        val decided = Decided()
        for (step in 0 until 12) {
            val angle = step * StrictMath.PI / 6
            val eye = Vector3d(4 * StrictMath.sin(angle), 1.0, 4 * StrictMath.cos(angle))
            val camera = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 30.0, 1.0, 8.0)
            decided.add(Scene(shells, viewpoint = camera).frame(200, 200))
        }
        assertTrue(decided.byTree > 5 * decided.byDepth, "$decided")
    }

    private fun ball(n: Int, radius: Double): Mesh {
        val flat = sheet(n) { _, _ -> 0.0 }
        val positions = flat.positions.copyOf()
        for (i in positions.indices step 3) {
            val along = StrictMath.PI * positions[i]
            val down = StrictMath.PI / 2 * positions[i + 1]
            positions[i] = (radius * StrictMath.cos(down) * StrictMath.sin(along)).toFloat()
            positions[i + 1] = (radius * StrictMath.sin(down)).toFloat()
            positions[i + 2] = (radius * StrictMath.cos(down) * StrictMath.cos(along)).toFloat()
        }
        return Mesh(positions, flat.triangles)
    }

    /** Sheets apart from each other, whose planes are those of the tree: no depths but those of the picture. */
    @Test
    fun wallsBehindWallsNeedNoDepths() {
        for (test in DepthTest.entries) {
            for (convention in DepthConvention.entries) {
                val walls = List(20) { sheet(1) { _, _ -> 0.05 * (7 * it % 20) } }
                val eye = Vector3d(0.0, 0.0, 5.0)
                val camera = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 20.0, 1.0, 8.0)
                val raster = Raster(40, 30, Rgba.WHITE, convention, test, test.behindAll)
                val frame = Scene(walls, viewpoint = camera).frame(raster)
                val decided = Decided().apply { add(frame) }
                assertTrue(decided.byTree > 10 * decided.byDepth, "$test $convention $decided")
            }
        }
    }

    @Test
    fun theTreeIsMadeOnceForTheArraysOfTheMeshes() {
        val mesh = ball(10, 1.0)
        val tree = PlaneTree.of(listOf(mesh))
        assertSame(tree, PlaneTree.of(listOf(mesh.withName("another camera, another colour"))))
        val turned = Mesh(mesh.positions, mesh.triangles.reversedArray())
        assertEquals(mesh.triangleCount, PlaneTree.of(listOf(turned)).start(PlaneTree.of(listOf(turned)).size))
        assertNotSame(tree, PlaneTree.of(listOf(turned)))
        assertEquals(2 * mesh.triangleCount, PlaneTree.of(listOf(mesh, turned)).run { start(size) })
    }

    /** Each triangle is at one node, and those below are on their side, but for the rounding of positions. */
    @Test
    fun planesDivideTheTrianglesBelow() {
        val mesh = SampleScenes.soup(java.util.Random(1980), 500, Material())
        val tree = PlaneTree.of(listOf(mesh))
        assertEquals(List(500) { it }, List(500) { tree.face(it) }.sorted())
        assertTrue((0 until tree.size).any { tree.isInner(it) })
        for (node in 0 until tree.size) {
            if (!tree.isInner(node)) continue
            val positive = tree.below(node, true)
            for (place in tree.start(tree.below(node, false)) until tree.start(positive)) {
                for (vertex in 0 until 3) assertTrue(height(tree, node, mesh, 3 * tree.face(place) + vertex) < 1e-5)
            }
            for (vertex in 0 until 3) {
                assertTrue(height(tree, node, mesh, 3 * tree.face(tree.start(positive)) + vertex) > -1e-5)
            }
        }
    }

    private fun height(tree: PlaneTree, node: Int, mesh: Mesh, vertex: Int): Double =
        (0 until 3).sumOf { tree.plane(node, it) * mesh.positions[3 * vertex + it] } + tree.plane(node, 3)
}
