package dev.lazyz.strategies.tiled

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
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Srgb
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.statistics.Statistics
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test

/**
 * Contract rules 5, 7 and 8 for meshes, which are drawn and shaded from arrays: with all kernels and various threads
 * and tiles.
 */
class TiledMeshProperties {
    @Property(tries = 25, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_meshesComeOutAsTheirTrianglesOneByOne(@ForAll seed: Long) {
        val frame = frame(Random(seed))
        assertFalse(frame.content.batches.isEmpty())
        val expected = ZBufferRenderer().render(frame)
        val oneByOne = Frame(frame.raster, frame.primitives.toList(), frame.region)
        Statistics.label("something hidden").collect(expected.counters.fragments > expected.visible)
        Statistics.label("has exceptions").collect(frame.content.batches.any { it.exceptions.isNotEmpty() })
        for (tileSize in SIZES) {
            val counters = HashSet<String>()
            for ((name, kernel) in kernels()) {
                for (threads in listOf(1, THREADS[1 + Math.floorMod(seed + tileSize, 3)])) {
                    val tiled = TiledRenderer(Coherence.DIRECT, threads, tileSize, kernel)
                    val image = tiled.render(frame)
                    assertEquals(expected, image) { "seed $seed, $name, $threads threads, tileSize $tileSize" }
                    assertEquals(expected, tiled.render(oneByOne)) { "$seed one by one, $name, $threads, $tileSize" }
                    assertTrue(image.counters.fragments <= expected.counters.fragments)
                    assertEquals(image.visible.toLong(), image.counters.shadingCalls)
                    counters += work(image.counters)
                }
            }
            assertEquals(1, counters.size) { "seed $seed, tileSize $tileSize: $counters" }
        }
    }

    @Property(tries = 30, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_meshesBehindGlassComeOutAsTheirTrianglesOneByOne(@ForAll seed: Long) {
        val frame = frame(Random(seed), alpha = 0.4f)
        val expected = ListsRenderer().render(frame)
        for (kernel in kernels().values) {
            for (tileSize in listOf(8, 64)) {
                val image = TiledRenderer(Coherence.DIRECT, 2, tileSize, kernel).render(frame)
                assertEquals(expected, image) { "seed $seed, tileSize $tileSize" }
            }
        }
    }

    @Property(tries = 60, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_5_coherenceChangesNothing(@ForAll seed: Long, @ForAll coherence: Coherence) {
        val frame = frame(Random(seed))
        val expected = ZBufferRenderer().render(frame)
        assertEquals(expected, TiledRenderer(coherence, 2, 16).render(frame)) { "seed $seed, $coherence" }
    }

    @Property(tries = 100, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_whatARendererHasRenderedBeforeChangesNothing(@ForAll seed: Long) {
        val random = Random(seed)
        val frame = frame(random)
        val expected = TiledRenderer(Coherence.DIRECT, 2, 16).render(frame)
        for (used in USED) {
            val image = used.render(frame)
            assertEquals(expected, image) { "seed $seed, $used" }
            assertEquals(work(expected.counters), work(image.counters))
        }
    }

    @Test
    fun aShaderOfMeshesWithAndWithoutAnAttributeSeesNoneWhereThereIsNone() {
        // Shared by both meshes, so that one batch could hold samples of both
        val shader = BatchShader { batch ->
            for (i in 0 until batch.size) {
                batch.red[i] = batch.u[i]
                batch.green[i] = batch.vertexGreen[i]
                batch.blue[i] = 1f
            }
        }
        val material = Material(shader = shader)
        val left = floatArrayOf(-1f, -1f, 0f, 0f, -1f, 0f, -1f, 1f, 0f)
        val right = FloatArray(9) { if (it % 3 == 0) left[it] + 1f else left[it] }
        val corners = intArrayOf(0, 1, 2)
        val with = Mesh(left, corners, material, uvs = FloatArray(6) { 0.7f }, colors = FloatArray(12) { 0.4f })
        val without = Mesh(right, corners, material)
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 9.0)
        for (surfaces in listOf(listOf(with, without), listOf(without, with))) {
            val frame = Scene(surfaces, emptyList(), camera).frame(16, 16)
            assertEquals(ZBufferRenderer().render(frame), TiledRenderer(Coherence.DIRECT, 1, 64).render(frame))
        }
    }

    @Property(tries = 5, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_trianglesOfASampleOrTwoHaveAllAttributes(@ForAll seed: Long) = assertAttributes(Random(seed), 60, 50)

    @Property(tries = 4, seed = "1995", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_manyTrianglesOfATileHaveAllAttributes(@ForAll seed: Long) = assertAttributes(Random(seed), 34, 160)

    /**
     * Renders a sheet of [side] x [side] vertices at random heights, with all attributes, in one tile of [size] x
     * [size].
     */
    private fun assertAttributes(random: Random, side: Int, size: Int) {
        val sheet = SampleScenes.sheet(side) { column, row, axis ->
            if (axis < 2) (listOf(column, row)[axis] + random.nextFloat()) / side * 4 - 2 else random.nextFloat() * 0.1f
        }

        fun numbers(size: Int) = FloatArray(size * side * side) { random.nextFloat() * 2 - 1 }
        for (shader in SHADERS) {
            val (material, normals, uvs) = Triple(Material(shader = shader), numbers(3), numbers(2))
            val mesh = Mesh(sheet.positions, sheet.triangles, material, normals, uvs, numbers(4))
            val frame = Scene(listOf(mesh), emptyList(), SampleScenes.camera).frame(size, size)
            val expected = ZBufferRenderer().render(frame)
            assertTrue(expected.visible > size * size / 5)
            for (kernel in kernels().values) {
                assertEquals(expected, TiledRenderer(Coherence.DIRECT, 1, 256, kernel).render(frame))
            }
        }
    }

    @Property(tries = 3, seed = "1999", edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_largeTrianglesThatHideEachOtherAreTheSameForAnyThreads(
        @ForAll seed: Long,
        @ForAll depthTest: DepthTest,
    ) {
        // More triangles than one thread takes at a time; some cover whole tiles, and some edges lie on tile borders
        val random = Random(seed)
        val count = 9000
        val positions = FloatArray(9 * count)
        for (triangle in 0 until count) {
            val reach = if (random.nextBoolean()) 4f else 0.5f
            val center = FloatArray(3) { random.nextFloat() * 2 - 1 }
            for (i in 0 until 9) {
                val isDepth = i % 3 == 2
                val value = center[i % 3] + (random.nextFloat() - 0.5f) * if (isDepth) 0.2f else reach
                positions[9 * triangle + i] = if (triangle % 3 == 0 && !isDepth) Math.round(value * 4) / 4f else value
            }
        }
        val mesh = Mesh(positions, IntArray(3 * count) { it }, Material(Rgba(1f, 0.5f, 0f)))
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 9.0)
        val isGreater = depthTest == DepthTest.GREATER || depthTest == DepthTest.GREATER_OR_EQUAL
        val background = if (isGreater) 0 else Int.MAX_VALUE
        val raster = Raster(64, 64, depthTest = depthTest, backgroundDepth = background)
        val frame = Scene(listOf(mesh), emptyList(), camera).frame(raster)
        val expected = ZBufferRenderer().render(frame)
        for (tileSize in listOf(4, 16)) {
            val counters = HashSet<String>()
            for (threads in THREADS) {
                val image = TiledRenderer(Coherence.DIRECT, threads, tileSize).render(frame)
                assertEquals(expected, image) { "seed $seed, $depthTest, tileSize $tileSize, $threads threads" }
                counters += work(image.counters)
            }
            assertEquals(1, counters.size) { "seed $seed, $depthTest, tileSize $tileSize: $counters" }
        }
    }

    @Test
    fun aConstantTriangleBehindGlassHasItsColor() {
        val corners = listOf(Vertex(-1.0, -1.0, 1.0), Vertex(1.0, -1.0, 1.0), Vertex(1.0, 1.0, 1.0))
        val glass = Polygon(listOf(corners), Material(Rgba(0f, 0.4f, 0f, 0.5f), alphaMode = AlphaMode.BLEND))
        val positions = floatArrayOf(-1f, -1f, 0f, 1f, -1f, 0f, 1f, 1f, 0f)
        val material = Material(Rgba(1f, 0.5f, 0f), shading = Shading.FLAT)
        val mesh = Mesh(positions, intArrayOf(0, 1, 2), material)
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 9.0)
        val frame = Scene(listOf(glass, mesh), listOf(Light.Ambient(Rgba.WHITE)), camera).frame(16, 16)
        assertEquals(ListsRenderer().render(frame), TiledRenderer(Coherence.DIRECT, 1, 64).render(frame))
    }

    @Test
    fun colorsArePackedTheSameByAllKernels() {
        assumeTrue(kernels().size > 1, "needs the module jdk.incubator.vector")
        val special = floatArrayOf(
            Float.NaN, Float.NEGATIVE_INFINITY, -1f, -0f, 0f, Float.MIN_VALUE, Math.nextDown(Srgb.LEAST), Srgb.LEAST,
            Math.nextDown(1f), 1f, Math.nextUp(1f), 2f, Float.POSITIVE_INFINITY,
        )
        val leastOfCode = FloatArray(256) { code ->
            // Positive floats have the same order as their bits
            var low = 0
            var high = 1f.toRawBits()
            while (low < high) {
                val middle = (low + high) / 2
                if (Srgb.encode(Float.fromBits(middle)) < code) low = middle + 1 else high = middle
            }
            Float.fromBits(low)
        }
        val random = Random(1)
        val batch = FragmentBatch(FragmentBatch.CAPACITY + FragmentBatch.SPARE)
        repeat(1000) { round ->
            batch.size = 1 + random.nextInt(FragmentBatch.CAPACITY)
            for (channel in listOf(batch.red, batch.green, batch.blue)) {
                for (i in 0 until batch.size) {
                    // Often just below or above the border between two codes
                    val edge = leastOfCode[1 + random.nextInt(255)]
                    channel[i] = when (random.nextInt(4)) {
                        0 -> special[random.nextInt(special.size)]
                        1 -> edge
                        2 -> Math.nextDown(edge)
                        else -> random.nextFloat()
                    }
                }
            }
            batch.alpha.fill(1f)
            if (round % 4 == 0) batch.alpha[random.nextInt(batch.size)] = random.nextFloat()
            val (scalar, vector) = kernels().values.map { kernels ->
                val argb = IntArray(batch.red.size)
                kernels().fragments().pack(batch, argb)
                argb.take(batch.size)
            }
            assertEquals(scalar, vector)
        }
    }

    /**
     * Meshes of triangles from less than a sample to more than the picture, and other surfaces among them, including
     * panes of the opacity [alpha].
     */
    private fun frame(random: Random, alpha: Float = 1f): Frame {
        val surfaces = ArrayList<Surface>()
        repeat(1 + random.nextInt(3)) {
            surfaces += mesh(random)
            if (random.nextInt(3) == 0) surfaces += Sphere(Vector3d(0.2, 0.1, 0.0), 0.6, Material(Rgba(1f, 0.5f, 0f)))
            if (random.nextInt(3) == 0) surfaces += pane(random, alpha)
        }
        val camera = if (random.nextBoolean()) {
            SampleScenes.camera
        } else {
            Camera.orthographic(Vector3d(0.3, 0.4, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 20.0)
        }
        val convention = DepthConvention.entries[random.nextInt(2)]
        val test = DepthTest.entries[random.nextInt(4)]
        val raster = Raster(
            1 + random.nextInt(150), 1 + random.nextInt(100), Rgba(0.2f, 0.3f, 0.4f), convention, test,
            if (random.nextInt(4) == 0) 1 shl 30 else test.behindAll,
        )
        val lights = listOf(
            Light.Ambient(Rgba(0.1f, 0.1f, 0.2f)),
            Light.Directional(Vector3d(-1.0, -2.0, -3.0), Rgba(0.7f, 0.6f, 0.5f)),
            Light.Point(Vector3d(2.0, 2.0, 2.0), Rgba(0.2f, 0.3f, 0.4f)),
        )
        val frame = Scene(surfaces, lights, camera).frame(raster)
        if (random.nextBoolean()) return frame
        val x = random.nextInt(raster.width)
        val y = random.nextInt(raster.height)
        return frame.within(
            Region(x, y, x + 1 + random.nextInt(raster.width - x), y + 1 + random.nextInt(raster.height - y)),
        )
    }

    /** An inclined pentagon of one colour. */
    private fun pane(random: Random, alpha: Float): Surface {
        val z = random.nextDouble() * 4 - 2
        val slope = random.nextDouble() * 2 - 1
        val color = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat())
        val places = listOf(-1.0 to -1.0, 1.0 to -1.0, 1.7 to 0.2, 1.0 to 1.0, -1.0 to 1.0)
        val corners = places.map { (x, y) -> Vertex(x, y, z + slope * x, color = color) }
        return Polygon(listOf(corners), Material(Rgba(0.3f, 0.4f, 0.7f, alpha), alphaMode = AlphaMode.BLEND))
    }

    /** Triangles around random places, scaled by a random power of two; one coordinate may be NaN. */
    private fun mesh(random: Random): Mesh {
        val triangles = 1 + random.nextInt(if (random.nextInt(4) == 0) 400 else 40)
        val soup = SampleScenes.soup(random, triangles, material(random))
        val positions = soup.positions
        for (triangle in 0 until triangles) {
            val size = StrictMath.pow(2.0, -random.nextInt(9).toDouble()).toFloat()
            for (axis in 0 until 3) {
                val center = positions[9 * triangle + axis]
                for (corner in 0 until 3) {
                    val at = 9 * triangle + 3 * corner + axis
                    positions[at] = center + size * (positions[at] - center)
                }
            }
        }
        if (random.nextInt(8) == 0) positions[random.nextInt(positions.size)] = Float.NaN

        // Behind the eye, or behind the far plane
        if (random.nextInt(4) == 0) {
            positions[3 * random.nextInt(3 * triangles) + 2] = if (random.nextBoolean()) 30f else -30f
        }
        return when (random.nextInt(3)) {
            0 -> soup
            1 -> Mesh(positions, soup.triangles, soup.material, colors = same(soup.colors!!, 4))
            else -> Mesh(positions, soup.triangles, soup.material, same(soup.normals!!, 3), soup.uvs, soup.colors)
        }
    }

    /** Gives all vertices of each triangle the [size] numbers of its first vertex. */
    private fun same(numbers: FloatArray, size: Int): FloatArray =
        FloatArray(numbers.size) { numbers[it / (3 * size) * (3 * size) + it % size] }

    private fun material(random: Random): Material {
        val sides = Sides.entries[random.nextInt(2)]
        val base = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat())
        return when (random.nextInt(8)) {
            0 -> Material(
                base, sides = sides,
                shader = Shader {
                    it.setColor(it.u, it.worldX, it.normalY + it.x * 0.01f)
                }
            )
            1 -> Material(base, sides = sides, shader = ROUNDS)
            2 -> Material(base, SampleScenes.checks, Shading.GOURAUD, sides = sides)
            else -> Material(base, shading = Shading.entries[random.nextInt(Shading.entries.size)], sides = sides)
        }
    }

    private fun kernels(): Map<String, () -> Kernels> {
        val kernels = linkedMapOf("scalar" to { Kernels.SCALAR })
        if (Kernels.best() == Kernels.VECTOR) kernels["vector"] = { Kernels.VECTOR }
        return kernels
    }

    /** All counters except the one that depends on the number of threads. */
    private fun work(counters: Counters): String = counters.toBuilder().apply { peakBytes = 0 }.toString()

    private companion object {
        val SIZES = listOf(1, 8, 16, 64, 512)
        val THREADS = listOf(1, 2, 3, 8)

        /** Together these read all attributes. */
        val SHADERS = listOf(
            Shader { it.setColor(it.worldX + 0.5f, it.worldY + 0.5f, it.worldZ * 8) },
            Shader { it.setColor(it.normalX, it.normalY, it.normalZ) },
            Shader { it.setColor(it.u, it.v, it.vertexAlpha) },
            Shader { it.setColor(it.vertexRed, it.vertexGreen, it.vertexBlue) },
        )

        /** Renderers that keep arrays from one try to the next. */
        val USED = THREADS.map { TiledRenderer(Coherence.DIRECT, it, 16) }

        val ROUNDS = BatchShader { batch ->
            for (i in 0 until batch.size) {
                batch.red[i] = batch.vertexRed[i] * batch.u[i] + batch.y[i] * 0.001f
                batch.green[i] = batch.normalZ[i] * batch.worldY[i]
                batch.blue[i] = batch.x[i] * 0.01f
            }
        }
    }
}
