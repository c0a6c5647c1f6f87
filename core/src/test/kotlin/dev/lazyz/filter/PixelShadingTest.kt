package dev.lazyz.filter

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.ShadingRate
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Pieces
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface
import java.util.concurrent.ConcurrentHashMap
import kotlin.math.sqrt
import kotlin.random.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.12: primitives that are shaded once a pixel, with the footprint of a pixel. */
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

    /** A ball is shaded at samples, a floor also between them; with 3 x 3 samples, the centre of a pixel is one. */
    @Test
    fun rule_6_12_shadersGetTheDerivativesOfAPixel() {
        for ((factor, surface) in listOf(2 to ::ball, 3 to ::ball, 4 to ::ball, 3 to ::floor)) {
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
            for ((place, actual) in pixel.seen) assertArrayEquals(plain.seen[place], actual)
            val equal = pixel.seen.count { (place, actual) ->
                sample.seen[place]?.withIndex()?.all { (k, one) ->
                    Math.abs(factor * one - actual[k]) <= Math.ulp(factor * one)
                } ?: false
            }
            assertTrue(equal >= if (surface == ::ball) pixel.seen.size else pixel.seen.size * 9 / 10) {
                "$equal of ${pixel.seen.size}, $factor"
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
    private fun mixture(vararg glass: Material): Scene {
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
            Material(shader = { it.setColor(it.worldX, it.worldY, 0.5f, 0f) }),
            Material(texture = picture, alphaMode = AlphaMode.MASK, alphaCutoff = 0.3f),
        ) + glass
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

        // Not flat, and without alpha: its pixels have the colours of their upper left samples
        val clear = Material(shader = { it.setColor(it.normalX, it.normalY, 1f, 0f) })
        val bare = Sphere(Vector3d(-0.9, -0.3, 2.2), 0.3, clear)
        return scene(*meshes.toTypedArray(), points, lines, ball(Material()), bare)
    }

    private val glass = Material(Rgba(0.9f, 0.2f, 0.3f, 0.5f), alphaMode = AlphaMode.BLEND)

    /** The renderer that resolves pixels itself gives those that the filter makes of rows of samples. */
    @Test
    fun rule_6_12_pixelsAreResolvedAsTheirSamplesAreFiltered() {
        val sizes =
            mapOf(2 to raster, 3 to Raster(30, 20), 4 to Raster(48, 20), 8 to Raster(16, 12), 16 to Raster(5, 4))
        for ((factor, pixels) in sizes) {
            for (rate in ShadingRate.entries) {
                for (scene in listOf(mixture(), mixture(glass))) {
                    val frame = SuperSampling(factor, rate = rate).frame(scene, pixels)
                    val region = Region(1, 1, pixels.width - 1, pixels.height)
                    val expected = frame.render(ListsRenderer())
                    assertTrue(expected.primitive.toSet().size > pixels.height)
                    val part = frame.within(region)
                    val expectedPart = part.render(ListsRenderer())
                    for (tile in listOf(8, 64, 512)) {
                        val renderer = TiledRenderer(RenderOptions(tileSize = tile, threads = 2))
                        assertEquals(expected, frame.render(renderer)) { "$factor, $rate, $tile" }
                        assertEquals(expectedPart, part.render(renderer)) { "$factor, $rate, $tile" }
                    }
                }
            }
        }
    }

    /** A primitive's colour in a pixel depends on nothing but that primitive, so streamed and filtered frames agree. */
    @Test
    fun rule_6_12_allWaysToRenderAgree() {
        val mesh = (mixture().surfaces.first() as Mesh).let { Mesh(it.positions, it.triangles, colors = it.colors) }
        for (rate in ShadingRate.entries) {
            for (filter in PixelFilter.entries) {
                val sampling = SuperSampling(4, filter, rate)
                val expected = sampling.frame(scene(mesh), raster).render(ZBufferRenderer())
                for (renderer in Renderers.builtIn) {
                    assertEquals(expected, sampling.frame(scene(mesh), raster).render(renderer)) { renderer.id }
                }
                val streamed = sampling.frame(scene(StreamedMesh(Pieces(mesh, 40))), raster)
                assertEquals(expected, streamed.render(TiledRenderer())) { "$rate, $filter" }
                assertEquals(expected, streamed.render(ZBufferRenderer())) { "$rate, $filter" }
            }
        }
    }

    /** Where a primitive is shaded goes with it, into whatever frame it is put. */
    @Test
    fun rule_6_12_primitivesOfOtherFramesKeepTheirColours() {
        for (rate in listOf(ShadingRate.PIXEL, ShadingRate.AUTO)) {
            val frame = SuperSampling(4, rate = rate).frame(mixture(), raster).frame
            val expected = frame.render(ZBufferRenderer())
            assertEquals(expected, frame.keeping { true }.render(TiledRenderer())) { "$rate" }
            assertEquals(expected, Frame(frame.raster, frame.primitives).render(TiledRenderer())) { "$rate" }
        }
    }

    private fun Frame.render(renderer: Renderer): Image = renderer.render(this)

    /** In parallel projection, what is linear on a triangle is at the mean of samples the mean of what it is there. */
    @Test
    fun rule_6_12_aTriangleIsShadedAtTheMeanOfItsSamplesInAPixel() {
        val level = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 0.5, 100.0)
        val scene = Scene(mixture().surfaces.take(1).map { it.withMaterials { Material(shader = ::xOfWorld) } })
        for (factor in listOf(2, 3, 4, 5)) {
            val frame = SuperSampling(factor, rate = ShadingRate.PIXEL).frame(scene.withViewpoint(level), raster).frame
            var checked = 0
            val fragment = Fragment()
            for (primitive in frame.primitives) {
                val samples = HashMap<Pair<Int, Int>, MutableList<Pair<Int, Int>>>()
                for (y in primitive.rowStart until primitive.rowEnd) {
                    val spans = Spans().also { primitive.spans(y, it) }
                    for (i in 0 until spans.count) {
                        for (x in spans.start(i) until spans.end(i)) {
                            samples.getOrPut(x / factor to y / factor) { ArrayList() } += x to y
                        }
                    }
                }
                for (covered in samples.values) {
                    val mean = covered.map { (x, y) ->
                        fragment.moveTo(x, y)
                        primitive.geometry(fragment)
                        fragment.worldX.toDouble()
                    }.average()
                    val colors = covered.map { (x, y) ->
                        fragment.moveTo(x, y)
                        primitive.shade(fragment)
                        fragment.red
                    }.toSet()
                    // A sample on an edge is in both triangles beside it, and one covers it: hence the tolerance
                    assertEquals(mean, colors.single().toDouble(), 0.01)
                    checked++
                }
            }
            assertTrue(checked > 200) { "$checked" }
        }
    }

    private fun xOfWorld(fragment: Fragment) = fragment.setColor(fragment.worldX, 0f, 0f)

    @Test
    fun rule_6_12_onlySmoothTrianglesAreShadedOnceByThemselves() {
        val texture = Texture(1, 1, intArrayOf(-1))
        val smooth = listOf(
            Material(), Material(shading = Shading.FLAT), Material(specular = Rgba.WHITE, shininess = 64),
            Material().withMetallicRoughness(MetallicRoughness(0.5f, 0.4f)),
        )
        val rough = listOf(
            Material(texture = texture), Material(shader = ::xOfWorld), Material(specular = Rgba.WHITE, shininess = 65),
            Material().withMetallicRoughness(MetallicRoughness(0.5f, 0.2f)),
            Material().withEmissionMap(TextureMap(texture)),
        )
        for (material in smooth + rough) {
            val calls = listOf(ShadingRate.PIXEL, ShadingRate.AUTO, ShadingRate.SAMPLE).map { rate ->
                SuperSampling(4, rate = rate).frame(scene(floor(material)), raster).render(TiledRenderer())
                    .counters.shadingCalls
            }
            assertEquals(if (material in smooth) calls[0] else calls[2], calls[1]) { "$material: $calls" }
            assertTrue(calls[0] < calls[2] / 10)
        }
    }
}
