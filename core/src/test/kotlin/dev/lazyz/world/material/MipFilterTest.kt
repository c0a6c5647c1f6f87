package dev.lazyz.world.material

import dev.lazyz.Primitive
import dev.lazyz.spi.Fragment
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import kotlin.math.abs
import kotlin.math.hypot
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.6: footprints of samples, and textures that are read with them. */
class MipFilterTest {
    private val stripes = texture(64, 64) { x, _ -> if (x % 2 == 0) WHITE else BLACK }

    private fun texture(width: Int, height: Int, texel: (Int, Int) -> Int): Texture =
        Texture(width, height, IntArray(width * height) { texel(it % width, it / width) })

    private fun read(texture: Texture, u: Double, v: Double, footprint: List<Double>): FloatArray =
        FloatArray(4).also {
            val (dudx, dvdx, dudy, dvdy) = footprint.map(Double::toFloat)
            texture.sample(u.toFloat(), v.toFloat(), dudx, dvdx, dudy, dvdy, it)
        }

    private fun plain(texture: Texture, u: Double, v: Double): FloatArray =
        FloatArray(4).also { texture.sample(u.toFloat(), v.toFloat(), it) }

    @Test
    fun rule_6_6_aSmallFootprintReadsTheTextureItself() {
        val random = Random(1)
        for (filter in MipFilter.entries) {
            val texture = stripes.withMipFilter(filter)
            repeat(200) {
                val (u, v) = List(2) { random.nextDouble() * 3 - 1 }
                val angle = random.nextDouble() * 7
                val across = random.nextDouble() / 64
                val footprint = listOf(
                    across * Math.cos(angle), across * Math.sin(angle), -across * Math.sin(angle),
                    across * Math.cos(angle),
                )
                assertArrayEquals(plain(texture, u, v), read(texture, u, v, footprint))
                assertArrayEquals(plain(texture, u, v), read(texture, u, v, List(4) { Double.NaN }))
            }
        }
    }

    @Test
    fun rule_6_6_levelsAreMeansInLinearLightWeightedByAlpha() {
        val image = texture(2, 2) { x, y -> if (x == y) 0xFFFF0000.toInt() else 0x00FFFFFF }
        val all = read(image.withMipFilter(MipFilter.TRILINEAR), 0.4, 0.7, listOf(9.0, 0.0, 0.0, 9.0))
        assertArrayEquals(floatArrayOf(1f, 0f, 0f, 128 / 255f), all, 1e-6f)
        val codes = texture(2, 1) { x, _ -> if (x == 0) WHITE else BLACK }.withMipFilter(MipFilter.TRILINEAR)
        val far = listOf(9.0, 0.0, 0.0, 9.0)
        assertEquals(0.5f, read(codes, 0.4, 0.7, far)[0], 0.005f)
        assertEquals(128 / 255f, read(codes.withEncoding(Texture.Encoding.LINEAR), 0.4, 0.7, far)[0], 1e-6f)
    }

    @Test
    fun rule_6_6_strangeFootprintsGiveColours() {
        val strange = listOf(0.0, 1e-30, 1.0, 1e9, 1e30, Double.POSITIVE_INFINITY, Double.NaN, -3.0)
        val random = Random(3)
        for (filter in MipFilter.entries) {
            for (texture in listOf(stripes, texture(3, 1) { _, _ -> WHITE })) {
                repeat(500) {
                    val footprint = List(4) { strange[random.nextInt(strange.size)] }
                    val result = read(texture.withMipFilter(filter), random.nextDouble(), 0.5, footprint)
                    assertTrue(result.all { it in 0f..1.000001f }) { "$footprint: ${result.toList()}" }
                }
            }
        }
    }

    private val minified = Material(texture = stripes.withMipFilter(MipFilter.ANISOTROPIC))

    private val camera = Camera.perspective(
        Vector3d(0.3, 0.4, 5.0), Vector3d(0.0, 0.1, 0.0), Vector3d(0.0, 1.0, 0.0), 40.0, 1.0, 20.0,
    )

    /** Compared with differences between the middles of a fine and of a finer raster. */
    @Test
    fun rule_6_6_derivativesAreThoseOfTheCoordinates() {
        val positions = floatArrayOf(-2f, -2f, 2f, 2f, -1.5f, -2f, 0f, 2f, 0.5f)
        val uvs = floatArrayOf(0f, 0f, 1f, 0.1f, 0.3f, 1f)
        val mesh = Mesh(
            positions, intArrayOf(0, 1, 2), minified, uvs = uvs, uvs2 = FloatArray(6) { 2f * uvs[it] - 1f },
        )
        assertDerivatives(mesh, 20 to 40)
        assertDerivatives(Sphere(Vector3d(0.1, 0.2, 0.3), 1.2, minified), 20 to 40)
    }

    /** The coordinates [fine] times as close to each other give differences that tend to the derivatives. */
    private fun assertDerivatives(surface: Surface, range: Pair<Int, Int>) {
        val fine = 1024
        for (viewpoint in listOf(camera, orthographic)) {
            val scene = Scene(listOf(surface), emptyList(), viewpoint)
            val coarse = scene.frame(SIDE, SIDE).primitives.single()
            val finer = scene.frame(SIDE * fine, SIDE * fine).primitives.single()
            for (y in range.first..range.second step 5) {
                for (x in range.first..range.second step 5) {
                    val at = at(coarse, x, y)
                    val middle = at(finer, x * fine + fine / 2, y * fine + fine / 2)
                    val right = at(finer, x * fine + fine / 2 + STEP, y * fine + fine / 2)
                    val below = at(finer, x * fine + fine / 2, y * fine + fine / 2 + STEP)
                    val scale = fine.toFloat() / STEP
                    val expected = listOf(
                        (right.u - middle.u) * scale, (right.v - middle.v) * scale,
                        (below.u - middle.u) * scale, (below.v - middle.v) * scale,
                    )
                    val actual = listOf(at.dudx, at.dvdx, at.dudy, at.dvdy)
                    val size = hypot(expected[0], expected[1]) + hypot(expected[2], expected[3])
                    for (k in 0 until 4) {
                        val off = abs(expected[k] - actual[k])
                        assertTrue(off < 0.05f * size) { "$surface at $x, $y: $actual, not $expected" }
                    }
                }
            }
        }
    }

    private val orthographic =
        Camera.orthographic(Vector3d(1.0, 0.4, 5.0), Vector3d(0.0, 0.1, 0.0), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 20.0)

    private fun at(primitive: Primitive, x: Int, y: Int): Fragment = Fragment().also {
        it.moveTo(x, y)
        primitive.shade(it)
    }

    private companion object {
        const val SIDE = 64

        /** Samples of the finer raster between which differences are taken, so that rounding does not matter. */
        const val STEP = 64
        val WHITE = 0xFFFFFFFF.toInt()
        val BLACK = 0xFF000000.toInt()
    }
}
