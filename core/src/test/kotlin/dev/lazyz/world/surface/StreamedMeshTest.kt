package dev.lazyz.world.surface

import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightMeter
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import java.util.Random
import java.util.concurrent.atomic.AtomicInteger
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Meshes that are read part by part give the picture of the same mesh in memory. */
class StreamedMeshTest {
    private val streaming: List<Renderer> = listOf(
        TiledRenderer(), TiledRenderer(RenderOptions(threads = 1, tileSize = 8)), ZBufferRenderer(), HybridRenderer(),
        HybridRenderer(RenderOptions(memoryBudget = 500)), HierarchicalRenderer(),
    )

    /** Large and small triangles that cross, with some that are equal, so that the order of submission decides. */
    private fun mesh(seed: Long, origin: Vector3d = Vector3d()): Mesh {
        val random = Random(seed)
        val positions = FloatArray(3 * 200) { random.nextFloat() * 2 - 1 }
        val triangles = ArrayList<Int>()
        repeat(150) {
            val one = List(3) { random.nextInt(if (it == 0) 200 else 30) }
            triangles += one
            if (random.nextInt(4) == 0) triangles += one
        }
        val colors = FloatArray(4 * 200) { if (it % 4 == 3) 1f else random.nextFloat() }
        return Mesh(positions, triangles.toIntArray(), colors = colors, origin = origin)
    }

    private fun sphere() = Sphere(Vector3d(0.3, 0.1, 0.5), 0.4, Material(Rgba(1f, 0f, 0f)))

    private fun assertSame(expected: Image, actual: Image, what: String) {
        assertEquals(expected.pixelHash(), actual.pixelHash(), what)
        val region = expected.region
        for (y in region.rowStart until region.rowEnd) {
            for (x in region.columnStart until region.columnEnd) {
                assertEquals(expected.depth(x, y), actual.depth(x, y), what)
                assertEquals(expected.primitive(x, y), actual.primitive(x, y), what)
            }
        }
        assertEquals(expected.counters.primitives, actual.counters.primitives, what)
    }

    @Test
    fun theyGiveThePictureOfAMeshInMemory() {
        for (seed in 1L..3L) {
            val whole = mesh(seed)
            for (size in listOf(1, 7, 64, 1000)) {
                val parts = StreamedMesh(Pieces(whole, size))
                val expected = Scene(listOf(sphere(), whole, sphere(), whole)).frame(70, 53)
                val actual = Scene(listOf(sphere(), parts, sphere(), parts)).frame(70, 53)
                assertTrue(actual.isStreamed)
                for (renderer in streaming) {
                    assertSame(renderer.render(expected), renderer.render(actual), "$renderer, $seed, $size")
                }
            }
        }
    }

    @Test
    fun regionsOptionsAndFiltersGiveTheSamePictures() {
        val whole = mesh(8, Vector3d(4e6, 0.0, -2e5))
        val material = Material(Rgba(0.5f, 0.9f, 0.8f))
        for (up in listOf(UpAxis.Y, UpAxis.Z, UpAxis.MINUS_X)) {
            val expected = Scene(listOf(whole.withMaterials { material })).withUpAxis(up)
            val actual = Scene(listOf(StreamedMesh(Pieces(whole, 20)))).withMaterials { material }.withUpAxis(up)
            val region = Region(11, 9, 50, 44)
            for (renderer in streaming) {
                assertSame(
                    renderer.render(expected.frame(61, 47).within(region)),
                    renderer.render(actual.frame(61, 47).within(region)), "$renderer, $up",
                )
                val sampling = SuperSampling(3)
                assertSame(
                    sampling.frame(expected, Raster(31, 17)).render(renderer),
                    sampling.frame(actual, Raster(31, 17)).render(renderer), "$renderer, $up, filtered",
                )
            }
        }
    }

    @Test
    fun eachRenderingReadsTheTrianglesOnce() {
        val pieces = Pieces(mesh(4), 50)
        val camera = Camera.fit().camera(Scene(listOf(mesh(4))), 1.0)
        val frame = Scene(listOf(StreamedMesh(pieces)), viewpoint = camera).frame(40, 40)
        for (renderer in streaming) {
            pieces.reads.set(0)
            renderer.render(frame)
            assertEquals(pieces.partCount, pieces.reads.get(), "$renderer")
        }
    }

    @Test
    fun translucentMeshesBlend() {
        val glass = Material(Rgba(1f, 1f, 1f, 0.5f)).withAlphaMode(AlphaMode.BLEND)
        val whole = mesh(5).withMaterials { glass }
        val parts = StreamedMesh(Pieces(mesh(5), 50), glass)
        val expected = TiledRenderer().render(Scene(listOf(sphere(), whole)).frame(60, 60))
        val frame = Scene(listOf(sphere(), parts)).frame(60, 60)
        for (renderer in streaming) {
            if (renderer is TiledRenderer) {
                assertSame(expected, renderer.render(frame), "$renderer")
            } else {
                val refused = assertThrows(IllegalArgumentException::class.java) { renderer.render(frame) }
                assertTrue("streamed" in refused.message!! && "use 'tiled'" in refused.message!!, refused.message)
            }
            renderer.render(frame.asOpaque())
        }
    }

    @Test
    fun primitivesCanOnlyBeIterated() {
        val frame = Scene(listOf(sphere(), StreamedMesh(Pieces(mesh(6), 50)))).frame(20, 20)
        assertEquals(frame.primitives.size, frame.primitives.count { true })
        assertThrows(IllegalArgumentException::class.java) { frame.primitives[0] }
    }

    @Test
    fun darkColoursAreMeteredLikeThoseInMemory() {
        val random = Random(9)
        val positions = FloatArray(3 * 1000) { random.nextFloat() }
        val colors = FloatArray(4 * 1000) { if (it % 4 == 3) 1f else random.nextFloat() / 10 }

        // Every third triangle is measured
        val dark = Mesh(positions, IntArray(3 * 140_000) { random.nextInt(1000) }, colors = colors)
        val expected = LightMeter.intensity(Scene(listOf(dark)))
        assertTrue(expected > 1f)
        for (size in listOf(1000, 7777, 200_000)) {
            assertEquals(expected, LightMeter.intensity(Scene(listOf(StreamedMesh(Pieces(dark, size))))))
        }
        val bright = StreamedMesh(Pieces(dark, 1000)).withoutColors()
        assertEquals(1f, LightMeter.intensity(Scene(listOf(bright))))
    }

    @Test
    fun theFarthestPointDoesNotDependOnTheParts() {
        // A grid has many points that are equally far; here the last of them in the order of x, y, z is the first
        val positions = FloatArray(3 * 1000) {
            val point = 999 - it / 3
            listOf(point / 100, point / 10 % 10, point % 10)[it % 3].toFloat()
        }
        val grid = Mesh(positions, IntArray(999) { it })
        for (direction in listOf(Vector3d(1.0, 0.0, 0.0), Vector3d(1.0, 1.0, 0.0), Vector3d(-1.0, 0.5, -0.0))) {
            val expected = grid.farthest(direction)
            for (size in listOf(3, 100)) assertEquals(expected, StreamedMesh(Pieces(grid, size)).farthest(direction))
        }
    }
}

/** The triangles of a mesh, in parts of [size]. Counts how often parts are read. */
internal class Pieces(private val mesh: Mesh, private val size: Int) : MeshSource {
    val reads = AtomicInteger()

    override val triangleCount: Int get() = mesh.triangleCount
    override val hasColors: Boolean get() = mesh.colors != null
    override val partCount: Int get() = (triangleCount + size - 1) / size
    override val origin: Vector3dc get() = mesh.origin

    override fun triangleCount(number: Int): Int = minOf(size, triangleCount - size * number)

    override fun bounds(number: Int): Box? = Box.around(positions(number, 1))

    override fun read(first: Int, count: Int): Mesh {
        reads.addAndGet(count)
        val corners = corners(first, count)
        val colors = mesh.colors?.let { all -> FloatArray(4 * corners.size) { all[4 * corners[it / 4] + it % 4] } }
        val numbers = IntArray(corners.size) { it }
        return Mesh(positions(first, count), numbers, colors = colors, origin = mesh.origin)
    }

    private fun corners(first: Int, count: Int): IntArray =
        mesh.triangles.copyOfRange(3 * size * first, minOf(3 * size * (first + count), 3 * triangleCount))

    private fun positions(first: Int, count: Int): FloatArray {
        val corners = corners(first, count)
        return FloatArray(3 * corners.size) { mesh.positions[3 * corners[it / 3] + it % 3] }
    }
}
