package dev.lazyz.shading

import dev.lazyz.Rgba
import dev.lazyz.setup.lightOf
import dev.lazyz.shading.light.LightVectors
import dev.lazyz.shading.pbr.BatchPhysicalLighting
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rules 6.1 and 6.5: fragments that are lit together have the bits of fragments that are lit one by one. */
class BatchLightingTest {
    private val random = Random(65)
    private val eye = Vector3d(0.3, 0.4, 4.0)
    private val perspective = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 1.0, 10.0)
    private val parallel = Camera.orthographic(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 10.0)
    private val picture = Texture(2, 2, intArrayOf(-0x1, 0x40ff0000, 0x4000ff00, -0xffff01), Texture.Filter.BILINEAR)
    private val map = TextureMap(picture)

    private fun color() = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat(), random.nextFloat())

    private fun place() = Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())

    private fun light(): Light = when (random.nextInt(5)) {
        0 -> Light.Ambient(color())
        1 -> Light.Directional(place(), color())
        2 -> Light.Point(place(), color())
        3 -> Light.Point(place(), color(), Falloff.inverseSquare(3.0))
        else -> Light.Spot(place(), place(), color(), 10.0 + random.nextInt(20), 30.0 + random.nextInt(50))
    }

    private fun material(shading: Shading): Material {
        var material = Material(
            color(), null, shading,
            if (random.nextInt(4) == 0) Rgba.BLACK else color(),
            1 + random.nextInt(70), color(),
            AlphaMode.entries[random.nextInt(3)],
        )
        if (random.nextBoolean()) material = material.withTextureMap(map)
        if (random.nextInt(3) == 0) material = material.withNormalMap(NormalMap(map, 0.7f))
        if (random.nextInt(3) == 0) material = material.withOcclusionMap(OcclusionMap(map, 0.6f))
        if (random.nextInt(3) == 0) material = material.withEmissionMap(map)
        return material
    }

    private fun model() = MetallicRoughness(
        random.nextInt(3) * 0.5f,
        if (random.nextInt(4) == 0) random.nextInt(2).toFloat() else random.nextFloat(),
        if (random.nextBoolean()) map else null,
    )

    private fun sceneLight(
        lights: List<Light>,
        curve: ToneMapping.Curve?,
        visibility: AmbientVisibility?,
        environment: Environment = Environment.NONE,
    ): SceneLight {
        val tones = if (curve == null) ToneMapping.NONE else ToneMapping(curve, 0.5)
        return SceneLight(lights, lights, environment, tones, visibility)
    }

    /** A batch of [count] fragments with random attributes. */
    private fun batch(count: Int): FragmentBatch {
        val batch = FragmentBatch.of(count)
        val signed = listOf(
            batch.worldX, batch.worldY, batch.worldZ, batch.normalX, batch.normalY, batch.normalZ,
            batch.tangentX, batch.tangentY, batch.tangentZ, batch.tangentW,
        )
        for (array in signed) for (i in 0 until count) array[i] = random.nextGaussian().toFloat()
        val unsigned = listOf(batch.u, batch.v, batch.vertexRed, batch.vertexGreen, batch.vertexBlue, batch.vertexAlpha)
        for (array in unsigned) for (i in 0 until count) array[i] = random.nextFloat()
        return batch
    }

    private fun assertAsOneByOne(batch: FragmentBatch, shader: MaterialShader, what: () -> String) {
        batch.alpha.fill(1f, 0, batch.size)
        shader.shade(batch)
        val fragment = Fragment()
        for (i in 0 until batch.size) {
            batch.moveTo(fragment, i)
            shader.shade(fragment)
            val expected = listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha)
            assertEquals(expected, listOf(batch.red[i], batch.green[i], batch.blue[i], batch.alpha[i])) {
                "fragment $i: ${what()}"
            }
        }
    }

    @Test
    fun rule_6_5_randomFragmentsHaveTheSameBits() {
        for (trial in 0 until 600) {
            randomFragmentsHaveTheSameBits(
                material(if (trial % 2 == 0) Shading.PHONG else Shading.BLINN_PHONG),
                Environment.NONE,
            )
        }
    }

    @Test
    fun rule_6_8_randomFragmentsHaveTheSameBits() {
        for (trial in 0 until 600) {
            val environment = if (trial % 3 == 0) Environment.NONE else Environment.studio(random.nextFloat())
            randomFragmentsHaveTheSameBits(material(Shading.PHONG).withMetallicRoughness(model()), environment)
        }
    }

    private fun randomFragmentsHaveTheSameBits(material: Material, environment: Environment) {
        val lights = List(random.nextInt(4)) { light() }
        val curve = (ToneMapping.Curve.entries + null)[random.nextInt(ToneMapping.Curve.entries.size + 1)]
        val visibility =
            if (random.nextInt(3) == 0) AmbientVisibility { x, _, _, nx, _, _ -> (x + nx) * 0.1f } else null
        val light = Lighting(
            sceneLight(lights, curve, visibility, environment),
            if (random.nextBoolean()) perspective else parallel,
        )
        val batch = batch(1 + random.nextInt(FragmentBatch.CAPACITY))
        assertAsOneByOne(batch, MaterialShader(material, light, isPrelit = false)) { "$material, $lights, $curve" }
    }

    /** The places where a cosine is 0, a vector has no length, or a light is infinite. */
    @Test
    fun rule_6_5_edgesOfTheDomainHaveTheSameBits() = edgesOfTheDomainHaveTheSameBits { it }

    /** The same, and mirrors, surfaces without any gloss, and rays along the planes of the soft boxes. */
    @Test
    fun rule_6_8_edgesOfTheDomainHaveTheSameBits() = edgesOfTheDomainHaveTheSameBits {
        it.withMetallicRoughness(MetallicRoughness(random.nextInt(2).toFloat(), random.nextInt(3) * 0.5f))
    }

    private fun edgesOfTheDomainHaveTheSameBits(change: (Material) -> Material) {
        val x = Vector3d(1.0, 0.0, 0.0)
        val huge = Rgba(Float.MAX_VALUE, 1f, 0f)
        val lights = listOf(
            Light.Directional(x, Rgba.WHITE), Light.Directional(Vector3d(0.0, 0.0, 1.0), Rgba.WHITE),
            Light.Point(Vector3d(), Rgba.WHITE), Light.Point(Vector3d(), huge, Falloff.inverseSquare(3.0)),
            Light.Point(eye, huge), Light.Spot(Vector3d(), x, huge, 10.0, 20.0), Light.Ambient(huge),
        )
        val numbers = floatArrayOf(
            0f, -0f, 1f, -1f, Float.MIN_VALUE, -Float.MIN_VALUE, 1e-30f, 1e20f, Float.MAX_VALUE,
            Float.POSITIVE_INFINITY, Float.NaN, 0.3f, 0.4f, 4f,
        )
        for (trial in 0 until 4000) {
            val batch = batch(BatchLighting.FEWEST + random.nextInt(3))
            val attributes = listOf(
                batch.worldX, batch.worldY, batch.worldZ, batch.normalX, batch.normalY, batch.normalZ, batch.vertexRed,
            )
            for (i in 0 until batch.size) {
                if (trial % 2 == 1 && i > 0) break
                for (array in attributes) if (random.nextBoolean()) array[i] = numbers[random.nextInt(numbers.size)]
            }
            val some = lights.filter { random.nextInt(if (trial % 4 == 0) 7 else 3) == 0 }
            val shading = if (random.nextBoolean()) Shading.PHONG else Shading.BLINN_PHONG
            val material = change(Material(Rgba.WHITE, null, shading, Rgba.WHITE, 1 + random.nextInt(3)))
            val environment = if (random.nextBoolean()) Environment.studio() else Environment.NONE
            // An answer that is a number, even if the normal is not: without lights, nothing else depends on it
            val visibility =
                if (random.nextBoolean()) {
                    AmbientVisibility { _, _, _, nx, _, _ ->
                        if (nx > 0f) 0.3f else 0.6f
                    }
                } else {
                    null
                }
            val lighting = Lighting(
                sceneLight(some, null, visibility, environment),
                if (random.nextBoolean()) perspective else parallel,
            )
            assertAsOneByOne(batch, MaterialShader(material, lighting, isPrelit = false)) { "$shading, $some" }
        }
    }

    /** Otherwise the tests above could compare [MaterialShader]'s single fragments with themselves. */
    @Test
    fun ordinaryFragmentsAreLitTogether() {
        val batch = batch(100)
        val lights = listOf(Light.Ambient(Rgba.WHITE), Light.Directional(place(), Rgba.WHITE))
        val lighting = Lighting(lightOf(lights), perspective).ofBatches
        batch.normalX.copyInto(batch.scratch(BatchLighting.ARRAYS)[LightVectors.NORMAL])
        batch.scratch(BatchLighting.ARRAYS)[LightVectors.OCCLUSION].fill(1f)
        for (array in listOf(batch.red, batch.green, batch.blue)) array.fill(0.5f)
        assertTrue(lighting.illuminate(batch, Material(specular = Rgba.WHITE), Rgba.BLACK))
        assertTrue((0 until 100).any { batch.red[it] > 0.5f })
    }

    @Test
    fun ordinaryMetalIsLitTogether() {
        val batch = batch(100)
        val lights = listOf(Light.Ambient(Rgba.WHITE), Light.Directional(place(), Rgba.WHITE))
        val lighting = Lighting(sceneLight(lights, null, null, Environment.studio()), perspective).physical.ofBatches
        val scratch = batch.scratch(BatchPhysicalLighting.ARRAYS)
        batch.normalX.copyInto(scratch[LightVectors.NORMAL])
        scratch[LightVectors.OCCLUSION].fill(1f)
        for (channel in 0 until 3) scratch[BatchPhysicalLighting.REFLECTANCE + channel].fill(0.9f)
        scratch[BatchPhysicalLighting.ROUGHNESS].fill(0.3f)
        assertTrue(lighting.illuminate(batch))
        assertTrue((0 until 100).all { batch.red[it] > 0.1f })
    }
}
