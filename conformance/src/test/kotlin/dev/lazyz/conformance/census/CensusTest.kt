package dev.lazyz.conformance.census

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Hollows
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.changed.Cutting
import dev.lazyz.conformance.frames.Plate
import dev.lazyz.conformance.frames.screen.screenCase
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Frames have exactly the traits that they were created with. */
class CensusTest {
    private val plain = Raster(8, 4)

    private fun plates(vararg sides: ClosedFloatingPointRange<Double>): Frame {
        val builder = FrameBuilder(plain)
        for (it in sides) Plate(it.start, 0.0, it.endInclusive, 4.0, 0.5, 0.5).piece().addTo(builder, 0)
        return builder.build()
    }

    private fun full(raster: Raster, count: Int): Frame =
        Frame(raster, List<Primitive>(count) { Cutting(Whole(raster), 0..<raster.width, 0..<raster.height) })

    /** Covers the whole raster, at the middle depth. */
    private class Whole(raster: Raster) :
        Primitive by screenCase(
            raster,
            listOf(Plate(-1.0, -1.0, raster.width + 1.0, raster.height + 1.0, 0.5, 0.5).piece()),
        ).frame.primitives.single()

    @Test
    fun samplesShowTraits() {
        assertTrue(FrameTrait.MEETING in Census.traits(plates(0.0..3.0, 3.0..8.0)))
        assertFalse(FrameTrait.MEETING in Census.traits(plates(0.0..4.0, 3.0..8.0)))
        assertFalse(FrameTrait.MEETING in Census.traits(plates(0.0..3.0, 4.0..8.0)))
        assertFalse(FrameTrait.DEEP in Census.traits(full(plain, 8)))
        assertTrue(FrameTrait.DEEP in Census.traits(full(plain, 9)))
        for ((teeth, isMany) in listOf(6 to false, 7 to true)) {
            val raster = Raster(20, 4)
            val comb = Plate(0.0, 0.0, 1.0, 4.0, 0.5, 0.5).comb(teeth, 2.0)
            val frame = FrameBuilder(raster).polygon(Rgba.WHITE, comb).build()
            assertEquals(isMany, FrameTrait.MANY_SPANS in Census.traits(frame))
        }
    }

    @Test
    fun rastersBringTraits() {
        for (test in DepthTest.entries) {
            val raster = Raster(8, 4, Rgba.WHITE, DepthConvention.LARGER_IS_NEARER, test, Rasters.behindAll(test))
            val traits = Census.traits(full(raster, 1))
            for (it in DepthTest.entries) assertEquals(it == test, FrameTrait.valueOf(it.name) in traits)
            assertTrue(FrameTrait.LARGER_IS_NEARER in traits)
            assertFalse(FrameTrait.BACKGROUND_DEPTH in traits)
        }
        val middle = Raster(8, 4, backgroundDepth = 7)
        assertTrue(FrameTrait.BACKGROUND_DEPTH in Census.traits(full(middle, 1)))
        assertTrue(FrameTrait.NARROW in Census.traits(full(Raster(1, 70), 1)))
        assertTrue(FrameTrait.SEVERAL_TILES in Census.traits(full(Raster(1, 70), 1)))
        val part = full(Raster(1, 70), 1).within(Region(0, 0, 1, 9))
        assertFalse(FrameTrait.SEVERAL_TILES in Census.traits(part))
        assertTrue(FrameTrait.REGION in Census.traits(part))
    }

    @Test
    fun scenesBringTraits() {
        val texture = Material(texture = Texture(1, 1, intArrayOf(-1)), alphaMode = AlphaMode.MASK)
        val near = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)
        val across = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 9f)
        val front = Polygon(listOf(listOf(Vertex(0.0, 0.0, 0.0), Vertex(1.0, 0.0, 0.0), Vertex(0.0, 1.0, 0.0))))
        assertEquals(setOf<FrameTrait>(), ofScene(Scene(listOf(front), viewpoint = camera)))
        val plain = Mesh(near, intArrayOf(0, 1, 2))
        assertEquals(setOf(FrameTrait.MESH), ofScene(Scene(listOf(plain), viewpoint = camera)))
        assertEquals(
            setOf(FrameTrait.MESH, FrameTrait.NEAR_PLANE, FrameTrait.TEXTURED, FrameTrait.MASKED),
            ofScene(Scene(listOf(Mesh(across, intArrayOf(0, 1, 2), texture)), viewpoint = camera)),
        )
        assertEquals(setOf(FrameTrait.SPHERE), ofScene(Scene(listOf(Sphere(Vector3d(), 1.0)), viewpoint = camera)))
        assertEquals(setOf(FrameTrait.POINTS), ofScene(Scene(listOf(Points(near)), viewpoint = camera)))
        assertEquals(
            setOf(FrameTrait.LINES, FrameTrait.MASKED),
            ofScene(Scene(listOf(Lines(near, intArrayOf(0, 1), material = texture)), viewpoint = camera)),
        )
        val onScreen = Scene(listOf(Mesh(near, intArrayOf(0, 1, 2), texture)), viewpoint = Camera.screen())
        assertEquals(setOf<FrameTrait>(), ofScene(onScreen))
    }

    @Test
    fun lightsBringTraits() {
        val up = Vector3d(0.0, 1.0, 0.0)
        fun of(vararg lights: Light) = ofScene(Scene(emptyList(), lights.toList(), camera))
        assertEquals(setOf(FrameTrait.LIT), of(Light.Point(up, Rgba.WHITE)))
        assertEquals(
            setOf(FrameTrait.LIT, FrameTrait.FALLOFF),
            of(Light.Point(up, Rgba.WHITE, Falloff.inverseSquare())),
        )
        assertEquals(setOf(FrameTrait.LIT, FrameTrait.SPOT), of(Light.Spot(up, up, Rgba.WHITE)))
        val exposed = Scene(emptyList(), viewpoint = camera).withToneMapping(ToneMapping(exposure = 1.0))
        assertEquals(setOf(FrameTrait.TONE_MAPPING), ofScene(exposed))
        val dark = Scene(emptyList(), viewpoint = camera).withLightIntensity(0.5f)
        assertEquals(setOf(FrameTrait.LIGHT_INTENSITY), ofScene(dark))
        val hollow = Scene(emptyList(), viewpoint = camera).withAmbientVisibility(Hollows(0))
        assertEquals(setOf(FrameTrait.AMBIENT_VISIBILITY), ofScene(hollow))
    }

    @Test
    fun mapsBringTraits() {
        val filtered = Texture(1, 1, intArrayOf(-1), mipFilter = MipFilter.TRILINEAR)
        val second = TextureMap(filtered, uvSet = 1)
        val mapped = Material().withNormalMap(NormalMap(second))
        val positions = FloatArray(9)
        val triangle = intArrayOf(0, 1, 2)
        fun of(surface: Surface) = ofScene(Scene(listOf(surface), viewpoint = camera))

        // A normal map needs tangents, and second coordinates must be there
        val bare = Mesh(positions, triangle, mapped)
        assertEquals(setOf(FrameTrait.MESH), of(bare))
        val whole = Mesh(positions, triangle, mapped, uvs2 = FloatArray(6), tangents = FloatArray(12))
        val traits = setOf(FrameTrait.MESH, FrameTrait.NORMAL_MAP, FrameTrait.SECOND_UVS, FrameTrait.MIP_FILTER)
        assertEquals(traits, of(whole))

        // Metals reflect a studio, beside lights, too; they are not lit with constant shading, nor without normals
        val sphere = Sphere(Vector3d(), 1.0, metal)
        val studio = setOf(FrameTrait.SPHERE, FrameTrait.PHYSICAL, FrameTrait.ENVIRONMENT, FrameTrait.TONE_MAPPING)
        assertEquals(studio, of(sphere))
        val lit = Scene(listOf(sphere), listOf(Light.Ambient(Rgba.WHITE)), camera)
        assertEquals(studio + FrameTrait.LIT, ofScene(lit))
        assertEquals(setOf(FrameTrait.SPHERE), of(Sphere(Vector3d(), 1.0, metal.withShading(Shading.CONSTANT))))
        assertFalse(FrameTrait.PHYSICAL in of(Points(positions, 1.0, metal)))
        assertTrue(FrameTrait.PHYSICAL in of(Points(positions, 1.0, metal, normals = positions)))
    }

    private val metal = Material().withMetallicRoughness(MetallicRoughness())
    private val eye = Vector3d(0.0, 0.0, 5.0)
    private val camera = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 0.5, 9.0)

    private fun ofScene(scene: Scene): Set<FrameTrait> = HashSet<FrameTrait>().also { addSceneTraits(scene, it) }

    @Test
    fun pairsAreCounted() {
        val census = Census()
        census.add(full(plain, 9))
        census.add(full(plain, 2), how = "options")
        val distribution = census.distribution()
        assertEquals(2, distribution.count(FrameTrait.TIE))
        assertEquals(1, distribution.count(FrameTrait.TIE, FrameTrait.DEEP))
        assertEquals(1, distribution.count(FrameTrait.CONFIGURED, FrameTrait.TIE))
        assertEquals(0, distribution.count(FrameTrait.CONFIGURED, FrameTrait.DEEP))
        assertEquals(2, (distribution + distribution).count(FrameTrait.DEEP, FrameTrait.TIE))
    }

    @Test
    fun largeFramesAreLookedAtInPart() {
        val large = full(Raster(300, 200), 12)
        assertTrue(Census.traits(large).containsAll(setOf(FrameTrait.DEEP, FrameTrait.TIE, FrameTrait.SEVERAL_TILES)))
        val census = Census()
        census.add(full(Raster(20_000, 1), 6))
        assertEquals(1, census.distribution().unexamined)
    }

    @Test
    fun impossiblePairsHaveReasons() {
        assertEquals("a raster has one depth test", PairsOfTraits.whyNever(FrameTrait.LESS, FrameTrait.GREATER))
        assertEquals(null, PairsOfTraits.whyNever(FrameTrait.TIE, FrameTrait.GREATER))
        assertEquals(null, PairsOfTraits.whyNever(FrameTrait.TIE, FrameTrait.TIE))
        assertTrue(PairsOfTraits.expected.size > 300)
    }
}
