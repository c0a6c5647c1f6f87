package dev.lazyz.conformance.slow

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.ShadingRate
import dev.lazyz.conformance.slow.SlowRenderer.Filter
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.Texture.Wrap
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/**
 * Pictures of the usual kind compared with those of [SlowRenderer]. Errors are in codes of 0..255: the mean of all
 * components, and the largest. Rounding to a code alone makes a mean of 0.25.
 */
class SlowRendererTest {
    private val sun = Light.Directional(Vector3d(-0.5, -0.7, -0.6), Rgba(0.9f, 0.8f, 0.7f))

    /** From behind, so that it grazes what is seen. */
    private val rim = Light.Directional(Vector3d(0.6, -0.2, 0.8), Rgba(0.5f, 0.6f, 0.7f))

    /** The same 16 samples. Vertices on a grid of 1/256 sample move the edges of texels over some of them. */
    @Test
    fun texelsAreWhereTheyBelong() {
        for (wrap in Wrap.entries) {
            for (filter in Texture.Filter.entries) {
                val image = noise(8, filter, wrap, Wrap.entries[(wrap.ordinal + 1) % 3], MipFilter.NONE)
                val transform = UvTransform(0.8, 1.3, 25.0, 0.35, -0.2)
                val scene = floor(constant(TextureMap(image, 0, transform)), 3f)
                val isNearest = filter == Texture.Filter.NEAREST
                compare("$wrap, $filter", scene, 4, Tolerance(0.3, if (isNearest) 16.0 else 1.2))
            }
        }
    }

    /** Levels have 8 bits a component, and the logarithm of a footprint is linear between powers of two. */
    @Test
    fun mipLevelsAreThoseOfTheFootprint() {
        val image = noise(64, Texture.Filter.BILINEAR, Wrap.REPEAT, Wrap.REPEAT, MipFilter.TRILINEAR)
        val scene = floor(constant(TextureMap(image, 0, UvTransform(12.0, 12.0, 30.0))), 20f)
        compare("levels", scene, 4, Tolerance(0.4, 3.0), Filter.LEVELS)
    }

    /**
     * Compared with the mean of 256 texels a pixel. The filter is not a square but a row of triangles, which are wider;
     * near the horizon, where a pixel has thousands of texels, the 256 are a sample, too.
     */
    @Test
    fun aFloorToTheHorizonHasItsMeanColours() {
        val image = noise(64, Texture.Filter.BILINEAR, Wrap.REPEAT, Wrap.REPEAT, MipFilter.ANISOTROPIC)
        val scene = floor(constant(TextureMap(image, 0, UvTransform(12.0, 12.0, 30.0))), 20f)
        compare("horizon", scene, 16, Tolerance(1.4, 12.0))
    }

    /** The same 16 samples, of which the grid may move the four of a row over an edge. */
    @Test
    fun pointsAndLinesHaveTheirWidths() {
        val random = Random(3)
        fun numbers(scale: Double) = FloatArray(36) { ((random.nextDouble() - 0.5) * scale).toFloat() }
        fun colors() = FloatArray(48) { if (it % 4 == 3) 1f else random.nextFloat() }
        val surfaces = listOf(
            Points(numbers(2.0), 5.0, Material(), null, colors()),
            Points(numbers(2.0), 2.25, Material(Rgba(0.9f, 0.5f, 0.2f))),
            Lines(numbers(2.4), IntArray(16) { it % 12 }, 3.0, Material(), colors()),
            Lines(numbers(2.4), IntArray(16) { it % 12 }, 1.5, Material(Rgba(0.1f, 0.7f, 0.3f))),
        )
        val eye = Vector3d(0.5, 0.4, 3.0)
        val parallel = Camera.orthographic(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 0.1, 100.0)
        for (camera in listOf(perspective(eye), parallel)) {
            compare("$camera", scene(surfaces, camera), 4, Tolerance(0.5, 64.0))
        }
    }

    /** The same samples: two translucent squares above each other, and holes in the ground. */
    @Test
    fun whatIsBehindShowsThrough() {
        val random = Random(5)
        val holes = IntArray(64) { random.nextInt() or if (random.nextBoolean()) 0 else 0xFF shl 24 }
        val image = Texture(8, 8, holes, Texture.Filter.NEAREST)
        val ground = constant(TextureMap(image)).withAlphaMode(AlphaMode.MASK)
        val glass = listOf(Rgba(0.9f, 0.3f, 0.1f, 0.4f), Rgba(0.1f, 0.3f, 0.9f, 0.7f)).mapIndexed { i, color ->
            val material = Material(color, shading = Material.Shading.CONSTANT).withAlphaMode(AlphaMode.BLEND)
            square(1f - 0.3f * i, 0.3f + 0.3f * i, material)
        }
        compare("layers", scene(listOf(square(2f, 0f, ground)) + glass, usual), 4, Tolerance(0.3, 16.0))
    }

    /** One sample a pixel, so nothing is left but rounding. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun lightsAreThoseOfTheSpecification() {
        val lights = listOf(
            sun,
            Light.Point(Vector3d(0.5, 1.2, 2.5), Rgba(4f, 5f, 6f), Falloff.inverseSquare(4.0)),
            Light.Spot(
                Vector3d(0.0, 0.5, 4.0), Vector3d(0.0, -0.1, -1.0), Rgba(8f, 7f, 6f), 8.0, 20.0,
                Falloff.inverseSquare(),
            ),
        )
        for (light in lights) compare("$light", lit(balls(), light), 1, Tolerance(0.3, 1.2))
        val neutral = lit(balls(), lights[1]).withToneMapping(ToneMapping(ToneMapping.Curve.NEUTRAL, 0.5))
        compare("neutral", neutral, 1, Tolerance(0.3, 1.2))
    }

    /** Highlights of Phong and Blinn, with all kinds of light; a ball, and a square with maps, also from behind. */
    @Test
    fun highlightsAreThoseOfTextbooks() {
        val numbers = noise(8, Texture.Filter.BILINEAR, Wrap.REPEAT, Wrap.REPEAT, MipFilter.NONE)
            .withEncoding(Texture.Encoding.LINEAR)
        for ((shading, y) in listOf(Material.Shading.PHONG to 1.0, Material.Shading.BLINN_PHONG to -1.0)) {
            val lights = listOf(
                Light.Ambient(Rgba(0.1f, 0.2f, 0.15f)),
                Light.Directional(Vector3d(-0.5, -0.7 * y, -0.6), Rgba(0.5f, 0.4f, 0.3f)),
                Light.Point(Vector3d(0.5, 1.2 * y, 2.5), Rgba(4f, 5f, 6f), Falloff.inverseSquare(4.0)),
                Light.Spot(Vector3d(0.0, 1.5 * y, 4.0), Vector3d(0.0, -0.3 * y, -1.0), BROWN, 4.0, 15.0),
            )
            fun seen(surface: Surface) = lit(listOf(surface), sun).withLights(lights)
                .withViewpoint(perspective(Vector3d(0.0, 0.9 * y, 5.0)))
            val plain = Material(BROWN, null, shading, Rgba(0.5f, 0.6f, 0.7f), 20, Rgba(0.05f, 0.1f, 0.02f))
            compare("$shading", seen(ball(0f, 0f, 1.7f, plain)), 1, Tolerance(0.3, 1.2))
            val mapped = plain.withNormalMap(NormalMap(TextureMap(numbers), 0.2f))
                .withOcclusionMap(OcclusionMap(TextureMap(numbers, 1), 0.8f))
            compare("$shading with maps", seen(square(2f, 0f, mapped)), 1, Tolerance(0.4, 2.5))
        }
    }

    /** A coloured reflection takes its own part from each colour of the diffuse light, not the largest from all. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun lobesAreThoseOfTheSpecifications() {
        val lobes = listOf(
            Lobes(Lobes.Specular(0.7f, Rgba.WHITE, 2.2f)), Lobes(clearcoat = Lobes.Clearcoat(0.8f, 0.3f)),
            Lobes(sheen = Lobes.Sheen(Rgba(0.9f, 0.4f, 0.3f), 0.5f)),
        )
        for (lobe in lobes) {
            compare("$lobe", lit(balls(lobe), sun), 1, Tolerance(0.3, 1.2))
            val plastic = Material(BROWN).withMetallicRoughness(MetallicRoughness(0f, 0.5f, null, lobe))
            compare("large, $lobe", lit(listOf(ball(0f, 0f, 1.7f, plastic)), sun), 1, Tolerance(0.3, 1.2))
        }
        val colored = balls(Lobes(Lobes.Specular(0.7f, Rgba(1f, 0.4f, 0.2f), 2.2f)))
        compare("coloured", lit(listOf(0, 3, 6).map(colored::get), sun), 1, Tolerance(3.0, 6.0))
    }

    /** Light that is mirrored: there, the angle between the viewer and the normal is that to the microfacets. */
    @Test
    fun filmsAreThoseOfTheSpecification() {
        for (thickness in listOf(120f, 380f, 700f)) {
            val film = Lobes(iridescence = Lobes.Iridescence(0.8f, 1.7f, thickness))
            val metal = Material(BROWN).withMetallicRoughness(MetallicRoughness(1f, 0.5f, null, film))
            val plastic = Material(Rgba.BLACK).withMetallicRoughness(MetallicRoughness(0f, 0.5f, null, film))
            for ((material, degrees) in listOf(metal to 5.0, metal to 35.0, metal to 60.0, plastic to 5.0)) {
                val pane = listOf(square(2f, 0f, material))
                val (y, z) = Math.toRadians(degrees).let { Math.cos(it) to Math.sin(it) }
                val up = Vector3d(0.0, 1.0, 0.0)
                val camera = Camera.orthographic(Vector3d(0.0, 5 * y, 5 * z), Vector3d(), up, 1.0, 0.1, 100.0)
                val mirrored = Light.Directional(Vector3d(0.0, -y, z), Rgba(0.2f, 0.2f, 0.2f))
                val scene = scene(pane, camera).withLights(listOf(mirrored)).withEnvironment(Environment.NONE)
                compare("$thickness, $degrees", scene.withToneMapping(ToneMapping.NONE), 1, Tolerance(0.7, 1.2))
            }
        }
    }

    /** Elsewhere, a film has the colour that the viewer's direction gives, not that of each light. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun filmsOnBallsHaveTheirColours() {
        val film = Lobes(iridescence = Lobes.Iridescence(0.8f, 1.7f, 380f))
        compare("metal", lit(listOf(2, 5, 8).map(balls(film)::get), sun), 1, Tolerance(3.0, 17.0))
        compare("matt", lit(listOf(0, 3, 6).map(balls(film)::get), sun), 1, Tolerance(2.3, 7.0))
    }

    @Test
    fun stretchedHighlightsAreThoseOfTheSpecification() {
        val stretched = balls(Lobes(anisotropy = Lobes.Anisotropy(0.7f, 30f)))
        compare("stretched", lit(stretched, sun), 1, Tolerance(0.3, 1.2))
    }

    /** Light that passes a pane: exact for grey glass; one opacity for all colours cannot be right for others. */
    @Test
    fun glassShowsWhatIsBehindIt() {
        fun seen(ground: Rgba, color: Rgba): Scene {
            val glass = Lobes(transmission = Lobes.Transmission(0.9f, null, 0.4f, null, color, 0.8f))
            val model = MetallicRoughness(0f, 0.1f, null, glass)
            val pane = Material(Rgba(0.9f, 0.9f, 0.9f)).withAlphaMode(AlphaMode.BLEND).withMetallicRoughness(model)
            val floor = square(3f, -0.1f, Material(ground, shading = Material.Shading.CONSTANT))
            return scene(listOf(floor, square(2f, 0f, pane)), usual).withToneMapping(ToneMapping.NONE)
        }
        for (ground in listOf(Rgba(0.2f, 0.25f, 0.3f), Rgba.WHITE)) {
            val grey = seen(ground, Rgba(0.4f, 0.4f, 0.4f))
            compare("grey", grey.withEnvironment(Environment.NONE), 1, Tolerance(0.5, 1.2))
            compare("grey in the studio", grey, 1, Tolerance(1.9, 17.0))
            val isWhite = ground == Rgba.WHITE
            val blue = if (isWhite) Tolerance(22.0, 42.0) else Tolerance(4.5, 17.0)
            compare("blue", seen(ground, Rgba(0.1f, 0.3f, 1f)), 1, blue)
        }
    }

    /** Neighbouring texels of the normal map differ much, which multiplies what single precision loses. */
    @Test
    fun mapsChangeTheSurface() {
        val image = noise(8, Texture.Filter.BILINEAR, Wrap.REPEAT, Wrap.REPEAT, MipFilter.NONE)
        val numbers = image.withEncoding(Texture.Encoding.LINEAR)
        val map = TextureMap(numbers, 1, UvTransform(1.5, 1.5, 10.0))
        val material = Material(emission = Rgba(0.2f, 0.1f, 0.3f)).withTextureMap(TextureMap(image, 1))
            .withMetallicRoughness(MetallicRoughness(0.8f, 0.9f, map)).withEmissionMap(TextureMap(image))
            .withNormalMap(NormalMap(TextureMap(numbers), 0.5f))
        compare("maps", lit(listOf(square(2f, 0f, material)), sun), 1, Tolerance(0.4, 2.5))
    }

    /** A matt surface receives the first nine harmonics of the light; a black one shows the reflection above it. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun mattSurfacesReflectTheStudio() {
        for (eye in listOf(Vector3d(0.0, 0.0, 5.0), Vector3d(3.0, 1.0, 4.0))) {
            compare("matt", studio(eye, listOf(0, 3, 6)), 1, Tolerance(2.0, 6.0))
        }
        compare("black", studio(Vector3d(0.0, 0.0, 5.0), listOf(3, 6), Rgba.BLACK), 1, Tolerance(3.8, 9.0))
    }

    /** Sheen and a clear coat on matt surfaces; a film and stretched highlights on metals. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun lobesReflectTheStudio() {
        val eye = Vector3d(3.0, 1.0, 4.0)
        fun seen(lobes: Lobes, numbers: List<Int>) =
            scene(numbers.map(balls(lobes)::get), perspective(eye)).withToneMapping(ToneMapping.NONE)
        val (matt, metal) = listOf(0, 3, 6) to listOf(2, 5, 8)
        val sheen = Lobes(sheen = Lobes.Sheen(Rgba(0.9f, 0.4f, 0.3f), 0.5f))
        compare("sheen", seen(sheen, matt), 1, Tolerance(2.4, 10.0))
        compare("coat", seen(Lobes(clearcoat = Lobes.Clearcoat(0.8f, 0.3f)), matt), 1, Tolerance(1.6, 5.0))
        val film = Lobes(iridescence = Lobes.Iridescence(0.8f, 1.7f, 380f))
        compare("film", seen(film, metal), 1, Tolerance(11.0, 42.0))
        compare("stretched", seen(Lobes(anisotropy = Lobes.Anisotropy(0.7f, 30f)), metal), 1, Tolerance(12.5, 58.0))
    }

    /** Light that is blurred by roughness has a simple form, and is the same from all sides of a reflected ray. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun metalsReflectTheStudio() {
        compare("metals", studio(Vector3d(3.0, 1.0, 4.0), listOf(2, 5, 8)), 1, Tolerance(9.0, 35.0))
    }

    private class Tolerance(val mean: Double, val largest: Double)

    /** Compares pixels; with one sample, those around which the same surface is. */
    private fun compare(
        name: String,
        scene: Scene,
        side: Int,
        tolerance: Tolerance,
        filter: Filter = Filter.TEXELS,
    ) {
        val size = 32
        val sampling = SuperSampling(if (side == 1) 1 else 4, PixelFilter.BOX, ShadingRate.AUTO)
        val image = sampling.frame(scene, Raster(size, size, scene.background)).render(TiledRenderer())
        val slow = SlowRenderer(scene, size, size, side, filter)
        val front = List(size * size) { if (side == 1) slow.front(it % size + 0.5, it / size + 0.5) else null }
        val errors = ArrayList<Double>()
        var worst = ""
        for (at in 0 until size * size) {
            val (x, y) = at % size to at / size
            if (side == 1 && !isInside(front, size, x, y)) continue
            slow.pixel(x, y).forEachIndexed { k, light ->
                val expected = 255 * SlowRenderer.encoded(light)
                errors.add(Math.abs((image.argb(x, y) ushr (16 - 8 * k) and 0xFF) - expected))
                if (errors.last() == errors.max()) worst = "($x, $y): %08x, not %.1f".format(image.argb(x, y), expected)
            }
        }
        val isRight = errors.size >= 60 && errors.average() <= tolerance.mean && errors.max() <= tolerance.largest
        assertTrue(isRight) { "$name: mean ${errors.average()}, largest ${errors.max()} of ${errors.size} $worst" }
    }

    private fun isInside(front: List<Material?>, size: Int, x: Int, y: Int): Boolean {
        if (minOf(x, y) < 1 || maxOf(x, y) > size - 2 || front[y * size + x] == null) return false
        val around = listOf(-1, 0, 1).flatMap { listOf(it - size, it, it + size) }
        return around.all { front[y * size + x + it] === front[y * size + x] }
    }

    private fun perspective(eye: Vector3d) =
        Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 45.0, 0.05, 100.0)

    private val usual = perspective(Vector3d(0.3, 1.4, 2.6))

    private fun scene(surfaces: List<Surface>, camera: Camera): Scene = Scene.builder().viewpoint(camera)
        .background(Rgba(0.2f, 0.25f, 0.3f)).build().withSurfaces(surfaces)

    private fun lit(surfaces: List<Surface>, light: Light): Scene =
        scene(surfaces, perspective(Vector3d(0.0, 0.7, 5.0))).withLights(listOf(light, rim))
            .withEnvironment(Environment.NONE).withToneMapping(ToneMapping.NONE)

    private fun studio(eye: Vector3d, numbers: List<Int>, color: Rgba = BROWN): Scene =
        scene(numbers.map(balls(null, color)::get), perspective(eye)).withToneMapping(ToneMapping.NONE)

    private fun floor(material: Material, half: Float): Scene = scene(listOf(square(half, 0f, material)), usual)

    private fun constant(map: TextureMap): Material =
        Material(shading = Material.Shading.CONSTANT).withTextureMap(map)

    /** A level square. */
    private fun square(half: Float, y: Float, material: Material): Mesh {
        val corners = floatArrayOf(-half, y, -half, half, y, -half, half, y, half, -half, y, half)
        val uvs = floatArrayOf(-1f, -1f, 2f, -1f, 2f, 2f, -1f, 2f)
        val others = floatArrayOf(0f, 0f, 1f, 0.2f, 0.7f, 1f, 0f, 1.5f)
        val normals = FloatArray(12) { if (it % 3 == 1) 1f else 0f }
        return Mesh(corners, intArrayOf(0, 2, 1, 0, 3, 2), material, normals, uvs, uvs2 = others).withTangents()
    }

    private fun noise(size: Int, filter: Texture.Filter, wrapU: Wrap, wrapV: Wrap, mipFilter: MipFilter): Texture {
        val random = Random(1)
        val texels = IntArray(size * size) { random.nextInt() or (0xFF shl 24) }
        return Texture(size, size, texels, filter, wrapU, wrapV, "", mipFilter)
    }

    /** Nine balls: from left to right more of a metal, from the top rougher. */
    private fun balls(lobes: Lobes? = null, color: Rgba = BROWN): List<Surface> = (0 until 9).map {
        val model = MetallicRoughness(it % 3 / 2f, 0.3f + it / 3 * 0.3f, null, lobes)
        val material = Material(color).withMetallicRoughness(model)
        ball((it % 3 - 1) * 1.2f, (1 - it / 3) * 1.2f, 0.55f, material)
    }

    private fun ball(x: Float, y: Float, radius: Float, material: Material): Mesh {
        val (rows, columns) = 12 to 24
        val normals = FloatArray(3 * (rows + 1) * columns) {
            val polar = Math.PI * (it / 3 / columns) / rows
            val angle = 2 * Math.PI * (it / 3 % columns) / columns
            when (it % 3) {
                0 -> Math.sin(polar) * Math.cos(angle)
                1 -> Math.cos(polar)
                else -> Math.sin(polar) * Math.sin(angle)
            }.toFloat()
        }
        val positions = FloatArray(normals.size) { normals[it] * radius + floatArrayOf(x, y, 0f)[it % 3] }
        val triangles = (0 until rows * columns).flatMap {
            val next = it / columns * columns + (it + 1) % columns
            listOf(it, next, it + columns, next, next + columns, it + columns)
        }
        val tangents = FloatArray(normals.size / 3 * 4) {
            val angle = 2 * Math.PI * (it / 4 % columns) / columns
            floatArrayOf(-Math.sin(angle).toFloat(), 0f, Math.cos(angle).toFloat(), -1f)[it % 4]
        }
        return Mesh(positions, triangles.toIntArray(), material, normals, tangents = tangents)
    }

    private companion object {
        val BROWN = Rgba(0.8f, 0.5f, 0.25f)
    }
}
