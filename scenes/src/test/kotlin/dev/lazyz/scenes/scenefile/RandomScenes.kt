package dev.lazyz.scenes.scenefile

import dev.lazyz.DepthTest
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.Tint
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.Viewpoint
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d

/** Scenes of all that a scene file can hold, with awkward numbers, names and shared materials. */
internal class RandomScenes(seed: Long) {
    private val random = Random(seed)
    private val materials = List(1 + random.nextInt(4)) { material() }

    fun scene(): Scene = Scene(
        surfaces = List(random.nextInt(5)) { surface() },
        lights = List(random.nextInt(4)) { light() },
        viewpoint = viewpoint(),
        background = color(),
    ).withEnvironment(environment()).withToneMapping(toneMapping()).withLightIntensity(pick(listOf(1f, 0f, 2.5f)))

    fun depth(): DepthRules {
        val convention = pick(DepthConvention.entries)
        val odd = DepthRules(convention, pick(DepthTest.entries), random.nextInt(Int.MAX_VALUE))
        return pick(listOf(DepthRules(), DepthRules(convention), odd))
    }

    private fun surface(): Surface = bare().withName(name())

    private fun bare(): Surface = when (random.nextInt(5)) {
        0 -> mesh()
        1 -> points()
        2 -> lines()
        3 -> Polygon(
            List(random.nextInt(3)) { List(random.nextInt(6)) { vertex() } }, pick(materials), pick(FillRule.entries),
        )
        else -> Sphere(Vector3d(double(), double(), double()), StrictMath.abs(double()), pick(materials))
    }

    private fun mesh(): Mesh {
        val vertices = random.nextInt(20)
        val triangles = if (vertices == 0) 0 else random.nextInt(10)
        fun some(count: Int): FloatArray? = if (random.nextBoolean()) FloatArray(count) { float() } else null
        return Mesh(
            FloatArray(3 * vertices) { float() },
            IntArray(3 * triangles) { random.nextInt(vertices) },
            pick(materials),
            some(3 * vertices),
            some(2 * vertices),
            some(4 * vertices),
            origin(),
        )
    }

    private fun points(): Points {
        val count = random.nextInt(20)
        return Points(
            FloatArray(3 * count) { float() },
            4096 * random.nextDouble() + Double.MIN_VALUE,
            pick(materials),
            if (random.nextBoolean()) FloatArray(3 * count) { float() } else null,
            if (random.nextBoolean()) FloatArray(4 * count) { float() } else null,
            origin(),
        )
    }

    private fun lines(): Lines {
        val vertices = 1 + random.nextInt(9)
        return Lines(
            FloatArray(3 * vertices) { float() },
            IntArray(2 * random.nextInt(9)) { random.nextInt(vertices) },
            4096 * random.nextDouble() + Double.MIN_VALUE,
            pick(materials),
            if (random.nextBoolean()) FloatArray(4 * vertices) { float() } else null,
            origin(),
        )
    }

    private fun origin(): Vector3d =
        if (random.nextBoolean()) Vector3d() else Vector3d(1e9 * random.nextGaussian(), random.nextGaussian(), -0.0)

    private fun vertex(): Vertex =
        if (random.nextBoolean()) {
            Vertex(double(), double(), double())
        } else {
            Vertex(double(), double(), double(), float(), float(), color())
        }

    private fun material(): Material = if (random.nextInt(4) == 0) {
        Material()
    } else {
        Material(
            color(), null, pick(Shading.entries), color(),
            1 + random.nextInt(1024), color(), pick(AlphaMode.entries), random.nextFloat(), pick(Sides.entries),
            if (random.nextInt(4) == 0) Tint(random.nextInt()) else null, name(),
        ).withTextureMap(map())
            .withMetallicRoughness(
                if (random.nextBoolean()) {
                    MetallicRoughness(random.nextFloat(), random.nextFloat(), map()).withLobes(lobes())
                } else {
                    null
                },
            )
            .withNormalMap(map()?.let { NormalMap(it, random.nextFloat()) })
            .withOcclusionMap(map()?.let { OcclusionMap(it, random.nextFloat()) })
            .withEmissionMap(map())
    }

    private fun lobes() = if (random.nextBoolean()) {
        null
    } else {
        Lobes(
            Lobes.Specular(random.nextFloat(), color(), 1f + random.nextFloat(), map(), map()),
            if (random.nextBoolean()) Lobes.Sheen(color(), random.nextFloat(), map(), map()) else null,
            Lobes.Clearcoat(
                random.nextFloat(), random.nextFloat(), map(), map(), map()?.let { NormalMap(it, random.nextFloat()) },
            ),
            Lobes.Transmission(
                random.nextFloat(), map(), random.nextFloat(), map(), color(),
                if (random.nextBoolean()) 1f + random.nextFloat() else Float.POSITIVE_INFINITY,
            ),
            Lobes.Iridescence(
                random.nextFloat(), 1f + random.nextFloat(), random.nextFloat(), random.nextFloat(), map(), map(),
            ),
            Lobes.Anisotropy(random.nextFloat(), 360f * random.nextFloat(), map()),
        )
    }

    private fun map(): TextureMap? = when (random.nextInt(3)) {
        0 -> null
        1 -> TextureMap(texture())
        else -> TextureMap(
            texture(), random.nextInt(2),
            UvTransform(
                random.nextGaussian(), random.nextDouble(), 1e3 * random.nextGaussian(), random.nextDouble(),
                -1.0 / 3.0,
            ),
        )
    }

    private fun texture(): Texture {
        val width = 1 + random.nextInt(5)
        val height = 1 + random.nextInt(5)
        return Texture(
            width, height, IntArray(width * height) { random.nextInt() }, pick(Texture.Filter.entries),
            pick(Texture.Wrap.entries), pick(Texture.Wrap.entries), name(), pick(MipFilter.entries),
            pick(Texture.Encoding.entries),
        )
    }

    private fun light(): Light = when (random.nextInt(4)) {
        0 -> Light.Ambient(color())
        1 -> Light.Directional(direction(), color())
        2 -> Light.Point(position(), color(), falloff())
        else -> {
            val inner = 89 * random.nextDouble()
            Light.Spot(position(), direction(), color(), inner, inner + 1.0 / 3.0, falloff())
        }
    }

    private fun position() = Vector3d(random.nextGaussian(), random.nextGaussian() * 1e9, 0.1)

    private fun falloff(): Falloff = when (random.nextInt(3)) {
        0 -> Falloff.NONE
        1 -> Falloff.inverseSquare()
        else -> Falloff.inverseSquare(1.0 - random.nextDouble())
    }

    private fun environment(): Environment? = when (random.nextInt(3)) {
        0 -> null
        1 -> Environment.NONE
        else -> Environment.studio(random.nextFloat())
    }

    private fun toneMapping(): ToneMapping? =
        if (random.nextBoolean()) null else ToneMapping(pick(ToneMapping.Curve.entries), 40 * random.nextDouble() - 20)

    private fun viewpoint(): Viewpoint {
        val eye = direction().mul(10.0)
        val target = direction()
        return when (random.nextInt(4)) {
            0 -> Camera.perspective(eye, target, direction(), 1.0 + 170 * random.nextDouble(), 0.1, 100.0 / 3.0)
            1 -> Camera.orthographic(eye, target, direction(), random.nextDouble() + 1e-3, -1.0 / 3.0, 10.0)
            2 -> random.nextGaussian().let { Camera.screen(it, it + 0.1 + random.nextDouble()) }
            else -> Camera.fit(
                random.nextGaussian() * 100,
                random.nextDouble() * 180 - 90,
                random.nextDouble() + 0.01,
                pick(Fit.entries),
                random.nextDouble() * 40,
                1.0 + 139 * random.nextDouble(),
            )
        }
    }

    private fun direction(): Vector3d = Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())

    private fun color(): Rgba = when (random.nextInt(3)) {
        0 -> Rgba.ofArgb(random.nextInt())
        1 -> Rgba(random.nextFloat(), random.nextFloat() * 100, 0f, pick(listOf(1f, random.nextFloat())))
        else -> Rgba.WHITE
    }

    private fun name(): String =
        pick(listOf("", "", "red", "material-1", "lamp \"A\"\\\n\t", "Grün", "\uD83C\uDF0D", "a.b[0]"))

    private fun float(): Float = when (random.nextInt(12)) {
        0 -> Float.NaN
        1 -> pick(listOf(Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.MIN_VALUE, Float.MAX_VALUE, -0f))
        2 -> random.nextInt(10).toFloat()
        3 -> Float.fromBits(random.nextInt()).let { if (it.isNaN()) 0f else it }
        else -> random.nextGaussian().toFloat()
    }

    private fun double(): Double = when (random.nextInt(12)) {
        0 -> Double.NaN
        1 -> pick(listOf(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.MIN_VALUE, -0.0))
        2 -> random.nextInt(10).toDouble()
        3 -> float().toDouble()
        else -> random.nextGaussian()
    }

    private fun <T> pick(from: List<T>): T = from[random.nextInt(from.size)]
}
