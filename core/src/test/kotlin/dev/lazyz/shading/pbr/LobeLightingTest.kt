package dev.lazyz.shading.pbr

import dev.lazyz.Checkpoint
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.Workers
import dev.lazyz.setup.SceneSetUp
import dev.lazyz.spi.Fragment
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.MetallicRoughness
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.16: specular, sheen, clear coat and transmission, compared with the formulas in double precision. */
class LobeLightingTest {
    private val eye = Vector3d(0.9, 0.4, 4.0)
    private val camera = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 10.0)
    private val n = Vector3d(0.1, -0.2, 1.0).normalize()
    private val v = Vector3d(eye).normalize()
    private val l = Vector3d(-0.7, -0.6, 1.0).normalize()
    private val sun = Light.Directional(Vector3d(l).negate(), Rgba.WHITE)
    private val base = Material(Rgba(0.9f, 0.5f, 0.125f))

    private val tangent = Vector3d(0.8, 0.5, 0.3)

    /** The linear colour of a point at the world's origin, and its alpha. */
    private fun seen(
        material: Material,
        vararg lights: Light,
        normal: Vector3d = n,
        environment: Environment = Environment.NONE,
    ): Rgba {
        val light = SceneLight(lights.toList(), lights.toList(), environment, ToneMapping.NONE, null)
        val fragment = Fragment()
        fragment.normalX = normal.x.toFloat()
        fragment.normalY = normal.y.toFloat()
        fragment.normalZ = normal.z.toFloat()
        fragment.tangentX = tangent.x.toFloat()
        fragment.tangentY = tangent.y.toFloat()
        fragment.tangentZ = tangent.z.toFloat()
        fragment.tangentW = -1f
        SceneSetUp(Raster(1, 1), camera, light, Vector3d(), Workers.ALL, Checkpoint.NONE)
            .shader(material).shade(fragment)
        return Rgba(fragment.red, fragment.green, fragment.blue, fragment.alpha)
    }

    private fun material(lobes: Lobes?, metallic: Float = 0.25f, roughness: Float = 0.5f) =
        base.withMetallicRoughness(MetallicRoughness(metallic, roughness, null, lobes))

    private fun assertColor(expected: List<Double>, actual: Rgba) {
        for ((wanted, got) in expected.zip(listOf(actual.red, actual.green, actual.blue))) {
            assertEquals(wanted, got.toDouble(), 1e-5 * Math.max(1.0, wanted), "$expected, $actual")
        }
    }

    @Test
    fun rule_6_16_whatChangesNothingHasTheSameBits() {
        val lights = arrayOf(sun, Light.Ambient(Rgba.WHITE))
        val plain = seen(material(null), *lights)
        val nothing = listOf(
            Lobes(), Lobes(sheen = Lobes.Sheen(Rgba.BLACK)), Lobes(clearcoat = Lobes.Clearcoat(0f)),
            Lobes(anisotropy = Lobes.Anisotropy(0f)),
        )
        for (lobes in nothing) {
            assertEquals(plain, seen(material(lobes), *lights))
        }
        val opaque = seen(material(Lobes(transmission = Lobes.Transmission())), sun)
        assertEquals(seen(material(null), sun), opaque, "only blended materials are glass")
    }

    @Test
    fun rule_6_16_furnaceLobesReflectNoMoreThanAllLight() {
        val white = Material(Rgba.WHITE)
        for (roughness in listOf(0f, 0.25f, 0.5f, 1f)) {
            val lobes = Lobes(
                Lobes.Specular(refraction = 1.8f), Lobes.Sheen(Rgba.WHITE, roughness), Lobes.Clearcoat(1f, roughness),
            )
            val model = MetallicRoughness(0f, roughness, null, lobes)
            val actual = seen(white.withMetallicRoughness(model), Light.Ambient(Rgba.WHITE))
            assertTrue(actual.red in 0.98f..1.000002f) { "$roughness: $actual" }
        }
    }

    @Test
    fun rule_6_16_glassShowsWhatIsBehindIt() {
        val window = Lobes(transmission = Lobes.Transmission(1f, null, 2f, null, Rgba(0.5f, 0.25f, 1f), 4f))
        val clear = Material(Rgba.WHITE, alphaMode = AlphaMode.BLEND)
            .withMetallicRoughness(MetallicRoughness(0f, 0f, null, window))
        assertTrue(clear.isTranslucent)
        assertFalse(clear.withAlphaMode(AlphaMode.OPAQUE).isTranslucent)

        // Half of the thickness after which the colour is left: its square root passes, but for what is reflected
        val passed = ((Math.sqrt(0.5) + 0.5 + 1.0) / 3 + 0.5) / 2
        assertEquals(1 - passed * 0.955, seen(clear).alpha.toDouble(), 0.01)
        val tinted = seen(clear, Light.Ambient(Rgba.WHITE))
        val light = listOf(Math.sqrt(0.5), 0.5, 1.0).map { Math.max(it - passed, 0.0) * 0.955 + 0.045 }
        for ((wanted, got) in light.zip(listOf(tinted.red, tinted.green, tinted.blue))) {
            assertEquals(wanted, got * tinted.alpha.toDouble(), 0.01)
        }
    }

    /** The reflectance [f0] under a film, in one channel. */
    private fun covered(f0: Float, channel: Int, refraction: Float, thickness: Float, cosine: Float): Float {
        val surface = FloatArray(3) { f0 }
        ThinFilm.cover(surface, 0, 1f, refraction, thickness, cosine)
        return surface[channel]
    }

    @Test
    fun rule_6_16_filmsColourWhatIsReflected() {
        for (f0 in listOf(0.04f, 0.5f, 0.9f)) {
            for (channel in 0 until 3) {
                assertEquals(f0, covered(f0, channel, 1.8f, 0f, 0.7f), 1e-4f, "no film")
                for (thickness in 50..800 step 50) {
                    val film = covered(f0, channel, 1.3f, thickness.toFloat(), 1f)
                    assertTrue(film in 0f..1f) { "$f0, $thickness: $film" }
                }
            }
        }

        // A film of a quarter of the wavelength, whose index is between those of both sides, reflects least
        val greens = (50..250).associateWith { covered(0.04f, 1, 1.22f, it.toFloat(), 1f) }
        assertEquals(545 / 1.22 / 4, greens.minByOrNull { it.value }!!.key.toDouble(), 15.0)
        val lobes = Lobes(iridescence = Lobes.Iridescence(0.5f, 1.3f, 400f))
        val halves = listOf(0f, 1f).map { seen(material(Lobes(iridescence = Lobes.Iridescence(it, 1.3f, 400f))), sun) }
        val half = seen(material(lobes), sun)
        assertEquals((halves[0].red + halves[1].red) / 2, half.red, 1e-5f)
    }

    /** The direction [degrees] from the tangent toward the bitangent, whose sign is negative, and the one across it. */
    private fun directions(degrees: Double): Pair<Vector3d, Vector3d> {
        val t = Vector3d(tangent).sub(Vector3d(n).mul(n.dot(tangent))).normalize()
        val b = Vector3d(n).cross(t).negate()
        val turn = Math.toRadians(degrees)
        val along = t.mul(Math.cos(turn)).add(b.mul(Math.sin(turn)))
        return along to Vector3d(n).cross(along)
    }

    @Test
    fun rule_6_16_anisotropyBendsTheMirrorOfTheEnvironment() {
        val lobes = Lobes(anisotropy = Lobes.Anisotropy(1f, 30f))
        val mirror = Material(Rgba.WHITE)
        val across = directions(30.0).second
        val bent = Vector3d(v).sub(Vector3d(across).mul(across.dot(v))).normalize()
        val studio = Environment.studio(1f)
        fun seen(roughness: Float, lobes: Lobes?, normal: Vector3d) = seen(
            mirror.withMetallicRoughness(MetallicRoughness(1f, roughness, null, lobes)),
            normal = normal, environment = studio,
        ).run { listOf(red, green, blue).map { it.toDouble() } }
        assertColor(seen(0f, null, bent), Rgba.of(seen(0f, lobes, n)))
        assertColor(seen(1f, null, n), Rgba.of(seen(1f, lobes, n)))
        val even = Light.Ambient(Rgba.WHITE)
        val round = seen(material(null), even).run { listOf(red, green, blue) }
        assertColor(round.map { it.toDouble() }, seen(material(lobes), even))
    }

    private fun Rgba.Companion.of(light: List<Double>) =
        Rgba(light[0].toFloat(), light[1].toFloat(), light[2].toFloat())

    @Test
    fun numbersOutOfRangeAreRefused() {
        val wrong = listOf(
            { Lobes.Specular(1.5f) }, { Lobes.Specular(refraction = 0.5f) }, { Lobes.Sheen(Rgba.WHITE, -1f) },
            { Lobes.Clearcoat(2f) }, { Lobes.Clearcoat(roughness = Float.NaN) }, { Lobes.Transmission(-0.1f) },
            { Lobes.Transmission(thickness = -1f) }, { Lobes.Transmission(attenuationDistance = 0f) },
            { Lobes.Iridescence(refraction = 0.9f) }, { Lobes.Iridescence(thickness = -1f) },
            { Lobes.Anisotropy(1.5f) }, { Lobes.Anisotropy(1f, Float.NaN) },
        )
        for (make in wrong) assertThrows(IllegalArgumentException::class.java) { make() }
    }
}
