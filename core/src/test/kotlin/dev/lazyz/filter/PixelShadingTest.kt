package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.ShadingRate
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Camera
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.concurrent.ConcurrentHashMap
import kotlin.math.sqrt
import kotlin.random.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Contract rule 6.12: textures of primitives that are shaded once a pixel have the footprint of a pixel. */
class PixelShadingTest {
    private val raster = Raster(48, 36)

    private fun chequers(mipFilter: MipFilter, shader: Shader? = null) = Material(
        texture = Texture(64, 64, IntArray(64 * 64) { if ((it / 2 xor it / 128) and 1 == 0) -1 else 0xFF shl 24 })
            .withMipFilter(mipFilter),
        shading = Shading.CONSTANT,
        shader = shader,
    )

    /** A floor to the horizon, with a texture of both sets that is too fine for most samples. */
    private fun floor(material: Material): Mesh {
        val uvs = floatArrayOf(0f, 0f, 8f, 0f, 8f, 40f, 0f, 40f)
        return Mesh(
            floatArrayOf(-8f, -1f, 4f, 8f, -1f, 4f, 8f, -1f, -80f, -8f, -1f, -80f), intArrayOf(0, 1, 2, 0, 2, 3),
            material, uvs = uvs, uvs2 = FloatArray(8) { uvs[it] / 3 },
        )
    }

    private fun ball(material: Material) = Sphere(Vector3d(0.5, 0.2, -1.0), 0.8, material)

    private val camera =
        Camera.perspective(Vector3d(0.0, 0.6, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 45.0, 0.5, 100.0)

    private fun scene(vararg surfaces: Surface) = Scene(surfaces.toList(), viewpoint = camera)

    private fun square(number: Int): Int = number * number

    @Test
    fun rule_6_12_texturesHaveNoMoreErrorThanWithOneSampleAPixel() {
        for (surface in listOf(floor(chequers(MipFilter.ANISOTROPIC)), ball(chequers(MipFilter.TRILINEAR)))) {
            val truth = SuperSampling(16).frame(scene(surface), raster).render(TiledRenderer()).argb
            fun error(sampling: SuperSampling): Double {
                val argb = sampling.frame(scene(surface), raster).render(TiledRenderer()).argb
                return sqrt(argb.indices.sumOf { square((argb[it] and 0xFF) - (truth[it] and 0xFF)) }.toDouble())
            }
            val once = error(SuperSampling(4, rate = ShadingRate.PIXEL))
            val plain = error(SuperSampling.NONE)
            assertTrue(once <= plain) { "$surface: $once, and $plain with one sample a pixel" }
        }
    }

    /** Keeps the derivatives that it sees, by sample. */
    private class Derivatives : BatchShader {
        val seen = ConcurrentHashMap<Pair<Int, Int>, FloatArray>()

        override fun shade(batch: FragmentBatch) {
            for (i in 0 until batch.size) {
                seen[batch.x[i] to batch.y[i]] = floatArrayOf(
                    batch.dudx[i], batch.dvdx[i], batch.dudy[i], batch.dvdy[i],
                    batch.du2dx[i], batch.dv2dx[i], batch.du2dy[i], batch.dv2dy[i],
                )
            }
        }
    }

    @Test
    fun rule_6_12_shadersGetTheDerivativesOfAPixel() {
        for (factor in listOf(2, 3, 4)) {
            for (surface in listOf<(Material) -> Surface>(::floor, ::ball)) {
                val (sample, pixel, plain) = List(3) { Derivatives() }
                fun render(shader: Shader, rate: ShadingRate) {
                    val shown = scene(surface(chequers(MipFilter.TRILINEAR, shader)))
                    SuperSampling(factor, rate = rate).frame(shown, raster).render(TiledRenderer())
                }
                render(sample, ShadingRate.SAMPLE)
                render(pixel, ShadingRate.PIXEL)
                render({ plain.shade(it) }, ShadingRate.PIXEL)
                assertTrue(pixel.seen.size > 100)
                assertEquals(pixel.seen.keys, plain.seen.keys)
                for ((place, actual) in pixel.seen) {
                    assertArrayEquals(plain.seen[place], actual)
                    for ((k, one) in sample.seen.getValue(place).withIndex()) {
                        assertEquals(factor * one, actual[k], Math.ulp(factor * one)) { "$place, $k" }
                    }
                }
            }
        }
    }

    @Test
    fun rule_6_12_allRenderersReadTexturesOnceAPixelInTheSameWay() {
        val scene = scene(floor(chequers(MipFilter.ANISOTROPIC)), ball(chequers(MipFilter.TRILINEAR)))
        val frame = SuperSampling(3, rate = ShadingRate.PIXEL).frame(scene, raster)
        val expected = frame.render(ZBufferRenderer())
        val region = Region(7, 9, 40, 31)
        for (renderer in Renderers.builtIn) {
            assertEquals(expected, frame.render(renderer)) { renderer.id }
            val part = frame.within(region).render(renderer)
            for (y in region.rowStart until region.rowEnd) {
                for (x in region.columnStart until region.columnEnd) {
                    assertEquals(expected.argb(x, y), part.argb(x, y)) { "${renderer.id} at ($x, $y)" }
                }
            }
        }
    }

    /** Small triangles, points, lines and spheres of all kinds of materials, one over the other. */
    private fun mixture(): Scene {
        val random = Random(5)
        fun place() = (random.nextDouble() * 4.0 - 2.0).toFloat()
        val picture = Texture(16, 16, IntArray(256) { random.nextInt() })
        val batched = BatchShader { batch ->
            for (i in 0 until batch.size) {
                batch.red[i] = batch.worldX[i] - batch.worldY[i]
                batch.green[i] = batch.vertexGreen[i]
                batch.blue[i] = (batch.x[i] and 7) / 7f
            }
        }
        val materials = listOf(
            Material(), Material(shading = Shading.FLAT), Material(shading = Shading.GOURAUD),
            Material(texture = picture), Material(texture = picture, shading = Shading.CONSTANT),
            Material().withMetallicRoughness(MetallicRoughness(0.5f, 0.4f)), Material(shader = batched),
            Material(shader = { it.setColor(it.worldX, it.normalZ, it.u) }),
            Material(texture = picture, alphaMode = AlphaMode.MASK, alphaCutoff = 0.3f),
        )
        val meshes = materials.map { material ->
            val corners = 3 * 60
            val positions = FloatArray(3 * corners)
            for (triangle in 0 until corners / 3) {
                val center = FloatArray(3) { place() }
                for (i in 0 until 9) positions[9 * triangle + i] = center[i % 3] + place() / 6
            }
            fun numbers(count: Int) = FloatArray(count * corners) { random.nextFloat() }
            val colors = numbers(4).also { for (i in 3 until it.size step 4) it[i] = 1f }
            Mesh(positions, IntArray(corners) { it }, material, numbers(3), numbers(2), colors)
        }
        val points = Points(FloatArray(90) { place() }, size = 3.0)
        val lines = Lines(FloatArray(60) { place() }, IntArray(20) { it }, width = 1.5)
        return scene(*meshes.toTypedArray(), points, lines, ball(Material()))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_12_pixelsHaveTheColoursOfTheirMiddleSamples() {
        for ((factor, pixels) in mapOf(2 to raster, 3 to raster, 4 to Raster(300, 40), 64 to Raster(3, 2))) {
            for (filter in listOf(PixelFilter.BOX, PixelFilter.MITCHELL)) {
                val actual = SuperSampling(factor, filter, ShadingRate.PIXEL).frame(mixture(), pixels)
                val samples = SuperSampling(factor, filter).frame(mixture(), pixels).frame
                val taps = FilterTaps(filter, factor)
                val collector = Image.Collector(actual.pixels)
                val sink = FilterSink(taps, samples, actual.pixels, collector)
                withMiddleColors(ZBufferRenderer().render(samples), factor, sink)
                val expected = collector.toImage(Counters.NONE)
                assertTrue(expected.primitive.toSet().size > pixels.height)
                assertEquals(expected, actual.render(TiledRenderer())) { "$factor, $filter" }
            }
        }
    }

    /** Passes the [samples] on, each with the colour of the middle one of those of its pixel and primitive. */
    private fun withMiddleColors(samples: Image, factor: Int, sink: RowSink) {
        fun fromMiddle(at: Int): Int = square(2 * (at % factor) + 1 - factor)
        val rows = IntArray(samples.width * samples.height)
        for (top in 0 until samples.height step factor) {
            for (left in 0 until samples.width step factor) {
                val places = (0 until factor * factor).map { Pair(left + it % factor, top + it / factor) }
                val colors = HashMap<Int, Int>()
                for ((x, y) in places.sortedBy { fromMiddle(it.first) + fromMiddle(it.second) }) {
                    rows[y * samples.width + x] = colors.getOrPut(samples.primitive(x, y)) { samples.argb(x, y) }
                }
            }
        }
        for (y in 0 until samples.height) {
            val row = y * samples.width until (y + 1) * samples.width
            sink.row(y, rows.sliceArray(row), samples.depth.sliceArray(row), samples.primitive.sliceArray(row))
        }
    }
}
