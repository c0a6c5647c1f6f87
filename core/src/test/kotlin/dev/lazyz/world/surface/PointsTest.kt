package dev.lazyz.world.surface

import dev.lazyz.Depth
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.SampleSet
import dev.lazyz.samples
import dev.lazyz.samplesByCursor
import dev.lazyz.setup.setUp
import dev.lazyz.spi.Fragment
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 2.9: points. */
class PointsTest {
    private val raster = Raster(16, 12)
    private val onScreen = setUp(raster, Camera.screen(), emptyList())

    private fun point(x: Double, y: Double, z: Double, size: Double, material: Material = Material()): Primitive =
        onScreen.points(Points(floatArrayOf(x.toFloat(), y.toFloat(), z.toFloat()), size, material)).single()

    @Property(seed = "1995", tries = 500, edgeCases = EdgeCasesMode.NONE)
    fun rule_2_9_aPointIsASquareAroundItsVertex(@ForAll random: Random) {
        val x = random.nextInt(20 * 256) - 512
        val y = random.nextInt(16 * 256) - 512
        val size = listOf(0.01, 0.5, 1.0, 1.5, 2.0, 3.0, 7.3, 40.0)[random.nextInt(8)]
        val half = maxOf(StrictMath.floor(128 * size + 0.5).toLong(), 128L)
        val primitive = point(x / 256.0, y / 256.0, 0.25, size)
        val expected = SampleSet.where(raster.width, raster.height) { column, row ->
            256 * column + 128 - x in -half until half && 256 * row + 128 - y in -half until half
        }
        assertEquals(expected, primitive.samples(raster))
        assertEquals(expected, primitive.samplesByCursor(raster, 0))
        for (row in 0 until raster.height) {
            for (column in 0 until raster.width) {
                if (expected[column, row]) assertEquals(Depth.ofUnit(0.25), primitive.depth(column, row))
            }
        }
    }

    @Test
    fun rule_2_9_aPointOutsideThePlanesCoversNothing() {
        assertEquals(1, point(3.5, 3.5, 0.0, 1.0).samples(raster).size)
        assertEquals(1, point(3.5, 3.5, 1.0, 1.0).samples(raster).size)
        assertEquals(0, point(3.5, 3.5, -0.01, 1.0).samples(raster).size)
        assertEquals(0, point(3.5, 3.5, 1.01, 1.0).samples(raster).size)
        assertEquals(0, point(3.5, Double.NaN, 0.5, 1.0).samples(raster).size)
        assertEquals(0, point(Double.POSITIVE_INFINITY, 3.5, 0.5, 1.0).samples(raster).size)
        assertEquals(0, point(1e30, 3.5, 0.5, 1.0).samples(raster).size)
    }

    @Test
    fun rule_6_7_withoutNormalsAPointShowsItsOwnColour() {
        val material = Material(
            Rgba(0.5f, 1f, 1f), SampleScenes.checks, Shading.PHONG, Rgba.WHITE, emission = Rgba(0f, 0f, 0.25f),
        )
        val points =
            Points(floatArrayOf(3.5f, 3.5f, 0.5f), 1.0, material, colors = floatArrayOf(0.5f, 0.25f, 0.5f, 0.5f))
        val fragment = shaded(onScreen.points(points).single())
        assertEquals(listOf(0.25f, 0.25f, 0.75f, 1f), colour(fragment))
    }

    @Test
    fun rule_6_7_aPointWithANormalIsLitLikeASphereThere() {
        val light = Light.Directional(Vector3d(-1.0, -2.0, -3.0), Rgba(0.7f, 0.6f, 0.5f))
        for (shading in Shading.entries) {
            val material = Material(Rgba(0.5f, 0.4f, 0.3f), null, shading, Rgba.WHITE, 5)
            val camera = SampleScenes.camera
            val setUp = setUp(Raster(64, 64), camera, listOf(light))
            val sphere = setUp.sphere(Sphere(Vector3d(), 1.0, material))
            val seen = Fragment().also { it.moveTo(30, 30) }
            sphere.shade(seen)
            for (turn in listOf(1f, -3f)) {
                val normals = floatArrayOf(turn * seen.normalX, turn * seen.normalY, turn * seen.normalZ)
                val positions = floatArrayOf(seen.worldX, seen.worldY, seen.worldZ)
                val own = shaded(setUp.points(Points(positions, 1.0, material, normals)).single(), 30, 30)
                for ((a, b) in colour(seen).zip(colour(own))) assertEquals(a, b, 1e-5f) { "$shading, $turn" }
            }
        }
    }

    @Test
    fun rule_6_7_ofOneSidedPointsThoseTurnedAwayCoverNothing() {
        val positions = FloatArray(9)
        val normals = floatArrayOf(0f, 0f, 1f, 0f, 0f, -1f, 0f, 0f, 0f)
        val setUp = setUp(raster, SampleScenes.camera, emptyList())
        fun sizes(sides: Sides) =
            setUp.points(Points(positions, 1.0, Material(sides = sides), normals)).map {
                it.samples(raster).size
            }.toList()
        assertEquals(listOf(1, 1, 1), sizes(Sides.BOTH))
        assertEquals(listOf(1, 0, 1), sizes(Sides.FRONT))
    }

    @Test
    fun rule_2_7_aMaskTakesOrLeavesAPointAsAWhole() {
        val material = Material(Rgba(1f, 1f, 1f, 0.5f), alphaMode = AlphaMode.MASK, alphaCutoff = 0.25f)
        val positions = floatArrayOf(3f, 3f, 0.5f, 6f, 3f, 0.5f, 9f, 3f, 0.5f)
        val colors = FloatArray(12) { listOf(0.5f, 0.49f, Float.NaN)[it / 4] }
        val covered = onScreen.points(Points(positions, 2.0, material, colors = colors)).map { it.samples(raster).size }
        assertEquals(listOf(4, 0, 0), covered.toList())
    }

    @Test
    fun rule_5_6_aPointSaysWhetherItIsTranslucent() {
        val colors = floatArrayOf(1f, 1f, 1f, 1f, 1f, 1f, 1f, 0.5f)
        val positions = floatArrayOf(3f, 3f, 0.5f, 6f, 3f, 0.5f)
        fun translucent(material: Material) =
            onScreen.points(Points(positions, 1.0, material, colors = colors)).map { it.isTranslucent }.toList()
        assertEquals(listOf(false, false), translucent(Material()))
        assertEquals(listOf(false, true), translucent(Material(alphaMode = AlphaMode.BLEND)))
        assertEquals(listOf(true, true), translucent(Material(Rgba(1f, 1f, 1f, 0.5f), alphaMode = AlphaMode.BLEND)))
        val textured = Material(texture = SampleScenes.checks, alphaMode = AlphaMode.BLEND)
        assertEquals(
            listOf(false, false),
            onScreen.points(Points(positions, 1.0, textured)).map { it.isTranslucent }.toList(),
        )
    }

    @Test
    fun wrongPointsAreRefused() {
        fun refused(message: String, make: () -> Points) {
            val thrown = assertThrows(IllegalArgumentException::class.java) { make() }
            assertTrue(thrown.message!!.contains(message)) { thrown.message }
        }
        refused("triples") { Points(FloatArray(4)) }
        refused("size") { Points(FloatArray(3), 0.0) }
        refused("size") { Points(FloatArray(3), Double.NaN) }
        refused("size") { Points(FloatArray(3), 4096.5) }
        refused("normals") { Points(FloatArray(3), normals = FloatArray(2)) }
        refused("colors") { Points(FloatArray(3), colors = FloatArray(3)) }
    }

    private fun shaded(primitive: Primitive, x: Int = 3, y: Int = 3): Fragment =
        Fragment().also { it.moveTo(x, y) }.also { primitive.shade(it) }

    private fun colour(fragment: Fragment) = listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha)
}
