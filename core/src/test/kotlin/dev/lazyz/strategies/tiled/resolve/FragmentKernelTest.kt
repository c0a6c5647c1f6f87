package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Frame
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.samples
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.setup.ShadingPoints
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatch
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.tiled.Kernels
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/**
 * The loops over visible samples compute the attributes that [PlanarPrimitive] defines, bit for bit, for any number of
 * samples.
 */
class FragmentKernelTest {
    @Test
    fun attributesAreThoseOfThePrimitive() {
        val signs = HashSet<Double>()
        for (kernels in available()) {
            for (seed in 0L until 64L) {
                val kernel = kernels.fragments()
                for (isPerspective in listOf(false, true)) {
                    val mesh = mesh(Random(seed), minified)
                    val frame = Scene(listOf(mesh), emptyList(), camera(isPerspective)).frame(SIDE, SIDE)
                    assertEquals(SIDE * SIDE, ZBufferRenderer().render(frame).visible)
                    val primitive = frame.primitives.single() as PlanarPrimitive
                    val batch = frame.content.triangleBatch(0)
                    val face = Face().apply { fill(batch, 0, batch.faces(), Fragment()) }
                    val copy = Face().apply { fill(0, primitive, Fragment()) }
                    for (count in COUNTS) {
                        val what = "$kernels, seed $seed, $count samples, perspective: $isPerspective"
                        assertAttributes(kernel, face, primitive, count, what)
                        assertAttributes(kernel, copy, primitive, count, "$what, face of the primitive")
                    }
                    signs.add(face.normalSign)
                }
            }
        }
        assertEquals(setOf(-1.0, 1.0), signs)
    }

    @Test
    fun attributesOfScatteredFragmentsAreThoseOfTheirPrimitives() {
        val random = Random(1)
        repeat(64) { seed ->
            val surface = if (seed % 2 == 0) mesh(random) else twoSided(random)
            val frame = Scene(listOf(surface), emptyList(), camera(random.nextBoolean())).frame(SIDE, SIDE)
            val batch = frame.content.triangleBatch(0)
            val numbers = IntArray(FragmentBatch.CAPACITY) { random.nextInt(batch.count) }
            assertScattered(frame, batch, numbers, random, "seed $seed")
        }
    }

    /** Compares fragments at random samples that the first primitive covers, each of the triangle in [numbers]. */
    private fun assertScattered(frame: Frame, batch: TriangleBatch, numbers: IntArray, random: Random, what: String) {
        val faces = batch.faces()
        val fragments = WaitingFragments()
        fragments.batch.begin(faces.fields)
        val covered = frame.primitives.first().samples(frame.raster)
        val samples = List(SIDE * SIDE) { it % SIDE to it / SIDE }.filter { (x, y) -> covered[x, y] }
        val expected = numbers.map { number ->
            val (x, y) = samples[random.nextInt(samples.size)]
            Fragment().apply {
                moveTo(x, y)
                if (random.nextBoolean()) {
                    gridRight = random.nextInt(ScreenGrid.STEPS)
                    gridDown = random.nextInt(ScreenGrid.STEPS)
                }
                fragments.add(PrimitiveRuns.place(y, x), 1, x, y, ShadingPoints.point(gridRight, gridDown))
                (frame.primitives[number] as PlanarPrimitive).attributes(this)
            }
        }
        fragments.locate(0, 0)
        ScatteredAttributes().fill(fragments, 0, 0, batch, numbers, faces)
        val actual = Fragment()
        for (i in numbers.indices) {
            fragments.batch.moveTo(actual, i)
            assertEquals(attributes(expected[i]), attributes(actual)) { "$what, sample $i" }
        }
    }

    /**
     * Triangles from the size of the picture to that of the guard band, with vertices of any w: edge functions up to
     * the largest, and sums of weights near 0.
     */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun attributesAreExactUpToTheEdgesOfTheDomain() {
        val exact = HashSet<Boolean>()
        var leastRatio = 1.0
        for (seed in 0L until 256L) {
            val random = Random(seed)
            val frame = Scene(listOf(farReaching(random)), emptyList(), nearCamera).frame(SIDE, SIDE)
            val primitive = frame.primitives.single() as PlanarPrimitive
            val batch = frame.content.triangleBatch(0)
            assertTrue(batch.isDrawn(0))
            val spans = Spans().also { primitive.spans(ROW, it) }
            val face = Face().apply { fill(batch, 0, batch.faces(), Fragment()) }
            val copy = Face().apply { fill(0, primitive, Fragment()) }
            val ws = List(3) { primitive.vertices.get(primitive.corners[it], Vertices.W) }
            leastRatio = minOf(leastRatio, ws.min() / ws.max())
            exact += face.isExact
            for (kernels in available()) {
                for (count in COUNTS.filter { it <= spans.end(0) - spans.start(0) }) {
                    val what = "$kernels, seed $seed, $count samples"
                    val start = spans.start(0)
                    assertAttributes(kernels.fragments(), face, primitive, count, what, start)
                    assertAttributes(kernels.fragments(), copy, primitive, count, "$what, face of the primitive", start)
                }
            }
            assertScattered(frame, batch, IntArray(FragmentBatch.CAPACITY), random, "seed $seed")
        }
        assertEquals(setOf(false, true), exact)
        assertTrue(leastRatio < 1e-8) { "$leastRatio" }
    }

    /** Looks along -z from the origin; a pixel is 2 / [SIDE] units wide at distance 1. */
    private val nearCamera =
        Camera.perspective(Vector3d(), Vector3d(0.0, 0.0, -1.0), Vector3d(0.0, 1.0, 0.0), 90.0, 1e-9, 1e4)

    private fun farReaching(random: Random): Mesh {
        val reach = SIDE * StrictMath.pow(2.0, random.nextInt(13).toDouble())
        val positions = FloatArray(9)
        for ((corner, place) in listOf(-1.0 to -0.9, 1.0 to -0.8, 0.1 to 1.0).withIndex()) {
            val w = StrictMath.pow(10.0, random.nextInt(13) - 9 + random.nextDouble())
            positions[3 * corner] = (place.first * reach * 2 / SIDE * w).toFloat()
            positions[3 * corner + 1] = (place.second * reach * 2 / SIDE * w).toFloat()
            positions[3 * corner + 2] = -w.toFloat()
        }
        return Mesh(
            positions, intArrayOf(0, 1, 2), Material(shader = BatchShader { }),
            numbers(random, 3), numbers(random, 2), numbers(random, 4),
        )
    }

    /** Its texture makes all derivatives of texture coordinates necessary. */
    private val minified =
        Material(texture = Texture(1, 1, intArrayOf(-1), mipFilter = MipFilter.TRILINEAR), shader = BatchShader { })

    /** The mesh with a copy of its triangle in the opposite orientation. */
    private fun twoSided(random: Random): Mesh {
        val mesh = mesh(random)
        return Mesh(
            mesh.positions, intArrayOf(0, 1, 2, 0, 2, 1), mesh.material, mesh.normals, mesh.uvs, mesh.colors,
            uvs2 = mesh.uvs2, tangents = mesh.tangents,
        )
    }

    /** Compares [count] samples of the middle row from column [start] on; the primitive covers all of them. */
    private fun assertAttributes(
        kernel: FragmentKernel,
        face: Face,
        primitive: PlanarPrimitive,
        count: Int,
        what: String,
        start: Int = 0,
    ) {
        for (point in listOf(0, ShadingPoints.point(128, 128), ShadingPoints.point(1, 255))) {
            val fragments = WaitingFragments()
            fragments.batch.begin(face.fields)
            // Some fragments that were filled in before, so that the first index is not 0
            fragments.add(PrimitiveRuns.place(0, 0), DONE)
            if (point == 0) {
                fragments.add(PrimitiveRuns.place(ROW, start), count)
            } else {
                for (i in 0 until count) fragments.add(PrimitiveRuns.place(ROW, start + i), 1, start + i, ROW, point)
            }
            kernel.attributes(face, fragments, DONE, 0, 0, 1)
            val expected = Fragment()
            val actual = Fragment()
            fragments.locate(0, 0)
            expected.gridRight = ShadingPoints.right(point)
            expected.gridDown = ShadingPoints.down(point)
            for (i in 0 until count) {
                expected.moveTo(start + i, ROW)
                primitive.attributes(expected)
                fragments.batch.moveTo(actual, DONE + i)
                assertEquals(attributes(expected), attributes(actual)) { "$what, sample $i, point $point" }
            }
        }
    }

    private fun attributes(fragment: Fragment): List<Float> = listOf(
        fragment.worldX, fragment.worldY, fragment.worldZ, fragment.normalX, fragment.normalY, fragment.normalZ,
        fragment.u, fragment.v, fragment.vertexRed, fragment.vertexGreen, fragment.vertexBlue, fragment.vertexAlpha,
        fragment.u2, fragment.v2, fragment.tangentX, fragment.tangentY, fragment.tangentZ, fragment.tangentW,
        fragment.dudx, fragment.dvdx, fragment.dudy, fragment.dvdy,
        fragment.du2dx, fragment.dv2dx, fragment.du2dy, fragment.dv2dy,
    )

    /**
     * A triangle larger than the picture, seen from the front or the back; components of attributes are often equal at
     * all vertices.
     */
    private fun mesh(random: Random, material: Material = Material(shader = BatchShader { })): Mesh {
        val z = FloatArray(3) { if (random.nextBoolean()) 0f else random.nextFloat() - 0.5f }
        val positions = floatArrayOf(-9f, -9f, z[0], 9f, -9f, z[1], 0f, 15f, z[2])
        val triangle = if (random.nextBoolean()) intArrayOf(0, 1, 2) else intArrayOf(0, 2, 1)
        return Mesh(
            positions, triangle, material, numbers(random, 3), numbers(random, 2), numbers(random, 4),
            uvs2 = numbers(random, 2), tangents = numbers(random, 4),
        )
    }

    /** Returns [size] numbers for each of three vertices; each number may be the same for all vertices. */
    private fun numbers(random: Random, size: Int): FloatArray {
        val numbers = FloatArray(3 * size) { random.nextFloat() * 2 - 1 }
        for (k in 0 until size) {
            val same = when (random.nextInt(4)) {
                0 -> numbers[k]
                1 -> 0f
                2 -> -1f
                else -> continue
            }
            for (vertex in 0 until 3) numbers[size * vertex + k] = same
        }
        return numbers
    }

    private fun camera(isPerspective: Boolean): Camera {
        val eye = Vector3d(0.3, 0.4, 5.0)
        val up = Vector3d(0.0, 1.0, 0.0)
        return if (isPerspective) {
            Camera.perspective(eye, Vector3d(), up, 40.0, 1.0, 20.0)
        } else {
            Camera.orthographic(eye, Vector3d(), up, 4.0, 1.0, 20.0)
        }
    }

    private fun available(): List<Kernels> = listOf(Kernels.SCALAR, Kernels.best()).distinct()

    private companion object {
        const val SIDE = 80
        const val ROW = 37
        const val DONE = 3

        /** Values around the counts from which on kernels use loops over arrays: 4 and 12. */
        val COUNTS = listOf(1, 3, 4, 5, 11, 12, 13, 64)
    }
}
