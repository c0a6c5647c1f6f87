package dev.lazyz.lighting

import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import kotlin.math.abs
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Contract rule 6.13, and how near the visibility is to what geometry says. */
class AmbientOcclusionTest {
    /** A level square at height [y], from -[half] to [half]. */
    private fun floor(
        half: Float,
        y: Float = 0f,
        material: Material = Material(),
        origin: Vector3d = Vector3d(),
    ) = Mesh(
        floatArrayOf(-half, y, half, half, y, half, half, y, -half, -half, y, -half),
        intArrayOf(0, 1, 2, 0, 2, 3), material, origin = origin,
    )

    /** A square along the y axis, through x = 0. */
    private fun wall(half: Float) = Mesh(
        floatArrayOf(0f, -half, half, 0f, half, half, 0f, half, -half, 0f, -half, -half),
        intArrayOf(0, 1, 2, 0, 2, 3),
    )

    private fun upward(surfaces: List<Surface>, x: Float, y: Float, z: Float, directions: Int = 512, size: Int = 256) =
        AmbientOcclusion.of(Scene(surfaces), directions, size).at(x, y, z, 0f, 1f, 0f)

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun nothingHidesALevelFloor() {
        val occlusion = AmbientOcclusion.of(Scene(listOf(floor(1f))))
        for (x in -9..9) for (z in -9..9) assertEquals(1f, occlusion.at(x / 10f, 0f, z / 10f, 0f, 1f, 0f))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aSphereDoesNotHideItself() {
        for (radius in listOf(1e-9, 1.0, 1e12)) {
            val occlusion = AmbientOcclusion.of(Scene(listOf(Sphere(Vector3d(), radius, Material()))), 128, 256)
            for (n in SphereDirections.everywhere(20)) {
                val x = n.x.toFloat()
                val y = n.y.toFloat()
                val z = n.z.toFloat()
                val r = radius.toFloat()
                assertTrue(occlusion.at(x * r, y * r, z * r, x, y, z) > 0.98f) { "radius $radius, $n" }
            }
        }
    }

    /** A point next to a wall sees half of the sky. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aHighWallHidesHalfOfTheSky() {
        val seen = upward(listOf(floor(0.1f), wall(10f)), 0.5f, 0f, 0f)
        assertEquals(0.5f, seen, 0.03f)
    }

    /** The part of Lambert's light that comes from a sphere straight above is (radius / distance)^2. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aSphereAboveHidesWhatItsFormFactorSays() {
        for (height in listOf(1.5, 2.0, 3.0)) {
            val sphere = Sphere(Vector3d(0.0, height, 0.0), 1.0, Material())
            val seen = upward(listOf(floor(2f), sphere), 0f, 0f, 0f, directions = 1024)
            assertEquals(1.0 - 1.0 / (height * height), seen.toDouble(), 0.02) { "height $height" }
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun translucentSurfacesPointsAndMissingSurfacesHideNothing() {
        val glass = floor(10f, y = 1f, Material(Rgba(1f, 1f, 1f, 0.5f), alphaMode = AlphaMode.BLEND))
        val points = Points(floatArrayOf(0f, 1f, 0f, 0.1f, 1f, 0f), 500.0)
        assertEquals(1f, upward(listOf(floor(1f), glass, points), 0f, 0f, 0f, directions = 64))
        assertEquals(0f, upward(listOf(floor(1f), floor(20f, y = 0.5f)), 0f, 0f, 0f, directions = 64), 0.02f)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_13_theNumberOfThreadsHasNoEffect() {
        val scene = Scene(listOf(floor(1f), Sphere(Vector3d(0.1, 0.5, 0.2), 0.4, Material())))
        val all = listOf(1, 2, 7).map { AmbientOcclusion.of(scene, 64, 64, RenderOptions(threads = it)) }
        for (x in -20..20) {
            val seen = all.map { it.at(x / 20f, 0f, 0.1f, 0.1f, 0.99f, 0.05f).toRawBits() }
            assertEquals(1, seen.toSet().size)
        }
    }

    private fun scene(material: Material): Scene {
        val surfaces = listOf(
            floor(1f, material = material), Sphere(Vector3d(0.1, 0.5, 0.2), 0.4, material),
            Sphere(Vector3d(-0.5, 0.2, 0.2), 0.2, material),
        )
        return Scene(surfaces, viewpoint = Camera.fit(20.0, 30.0)).let {
            it.withAmbientVisibility(AmbientOcclusion.of(it, 32, 64))
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rule_6_13_allRenderersGiveTheSamePicture() {
        val lit = scene(Material(Rgba(0.8f, 0.5f, 0.3f)).asMetallicRoughness())
        val shadow = GroundShadow.of(lit)
        val camera = shadow.camera(lit.camera(60, 45))
        val frame = lit.withSurfaces(lit.surfaces + shadow).withViewpoint(camera).frame(60, 45)
        val expected = ZBufferRenderer().render(frame)
        for (renderer in Renderers.builtIn) assertEquals(expected, renderer.render(frame)) { renderer.id }
        assertNotEquals(expected, ZBufferRenderer().render(lit.withAmbientVisibility(null).frame(60, 45)))
    }

    /** Ambient light is multiplied by the visibility; other light is not. */
    @Test
    fun rule_6_13_classicalMaterialsLoseAmbientLight() {
        val half = { _: Float, _: Float, _: Float, _: Float, _: Float, _: Float -> 0.5f }
        val light = listOf(Light.Ambient(Rgba(0.4f, 0.2f, 0.8f)), Light.Directional(Vector3d(0.0, -1.0, 0.0), GREY))
        for (shading in Shading.entries) {
            val material = Material(shading = shading)
            val scene = Scene(listOf(floor(1f, material = material)), light, Camera.fit(0.0, 90.0))
            val seen = color(scene.withAmbientVisibility(half).frame(9, 9))
            val expected = if (shading == Shading.CONSTANT) Rgba.WHITE else Rgba(0.45f, 0.35f, 0.65f)
            assertEquals(expected.toArgb(), seen) { "$shading" }
        }
    }

    /** A black surface reflects nothing into hollows; a white one so much that they are hardly darker. */
    @Test
    fun rule_6_13_lightIsReflectedIntoHollows() {
        fun factor(albedo: Float, open: Float): Double {
            val material = Material(Rgba(albedo, albedo, albedo)).asMetallicRoughness()
            val above = Camera.fit(0.0, 90.0)
            val scene = Scene(listOf(floor(1f, material = material)), listOf(Light.Ambient(GREY)), above)
                .withEnvironment(Environment.NONE).withToneMapping(ToneMapping.NONE)
            val frames = listOf(scene, scene.withAmbientVisibility { _, _, _, _, _, _ -> open })
            val (all, part) = frames.map { Rgba.ofArgb(color(it.frame(9, 9))).red.toDouble() }
            return part / all
        }
        for (open in listOf(0.2f, 0.5f, 0.8f)) {
            val factors = listOf(0.05f, 0.3f, 0.6f, 0.9f).map { factor(it, open) }
            assertEquals(factors.sorted(), factors) { "brighter walls reflect more" }
            assertTrue(factors.all { it in open - 0.02..1.0 }) { "$factors" }
        }

        // The published formula: a cubic in the openness, for an albedo of 0.9
        val formula = ((0.5 * (2.0404 * 0.9 - 0.3324) - 4.7951 * 0.9 + 0.6417) * 0.5 + 2.7552 * 0.9 + 0.6903) * 0.5
        assertTrue(abs(factor(0.9f, 0.5f) - formula) < 0.03) { "$formula" }
    }

    private fun color(frame: Frame): Int = ZBufferRenderer().render(frame).argb(4, 4)

    @Test
    fun whatCannotBeComputedIsRefused() {
        val scene = Scene(listOf(floor(1f)))
        assertThrows(IllegalArgumentException::class.java) { AmbientOcclusion.of(scene, directions = 7) }
        assertThrows(IllegalArgumentException::class.java) { AmbientOcclusion.of(scene, size = 4097) }
        assertThrows(IllegalArgumentException::class.java) { AmbientOcclusion.of(Scene(emptyList())) }
        assertThrows(IllegalArgumentException::class.java) {
            AmbientOcclusion.of(scene.withViewpoint(Camera.screen()))
        }
    }

    /** Shadows are computed in single precision. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun scenesTooLargeForSinglePrecisionHaveNoShadows() {
        fun sphere(x: Double, radius: Double) = Scene(listOf(Sphere(Vector3d(x, 0.0, 0.0), radius, Material())))
        for (tooLarge in listOf(sphere(0.0, 1.01e38), sphere(0.9e38, 0.2e38), sphere(-1e60, 1e59))) {
            val problem = checkNotNull(AmbientOcclusion.obstacle(tooLarge))
            for (compute in listOf<(Scene) -> Any>({ AmbientOcclusion.of(it, 8, 16) }, { GroundShadow.of(it) })) {
                val error = assertThrows(IllegalArgumentException::class.java) { compute(tooLarge) }
                assertEquals(problem, error.message)
            }
        }
        val large = sphere(0.0, 1e38)
        assertNull(AmbientOcclusion.obstacle(large))
        assertTrue(AmbientOcclusion.of(large, 8, 16).at(0f, 1e38f, 0f, 0f, 1f, 0f) > 0.9f)
        val shadow = GroundShadow.of(large)
        for (kind in Fit.entries) {
            val camera = shadow.camera(Camera.fit(kind = kind).camera(large, 1.0))
            val image = ZBufferRenderer().render(Scene(large.surfaces + shadow, viewpoint = camera).frame(20, 20))
            assertTrue(image.primitive.indices.any { image.primitive[it] >= 1 && image.argb[it] and 0xFF < 250 })
        }
    }

    /** A scene without height or width, and a single point, have shadows of nothing. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun flatScenesAreComputed() {
        val flat = listOf(floor(1f), wall(1f), Points(floatArrayOf(1f, 2f, 3f)), floor(0f))
        for (surface in flat) {
            val scene = Scene(listOf(surface))
            val seen = AmbientOcclusion.of(scene, 16, 16).at(0f, 0f, 0f, 0f, 1f, 0f)
            assertTrue(seen in 0f..1f) { "$surface: $seen" }
            val shadow = GroundShadow.of(scene)
            val camera = shadow.camera(scene.camera(20, 20))
            ZBufferRenderer().render(scene.withSurfaces(listOf(surface, shadow)).withViewpoint(camera).frame(20, 20))
        }
    }

    private companion object {
        val GREY = Rgba(0.25f, 0.25f, 0.25f)
    }
}
