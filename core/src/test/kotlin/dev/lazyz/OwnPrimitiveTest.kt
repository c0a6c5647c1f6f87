package dev.lazyz

import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.Box
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.sections.Section
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.scene
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.function.UnaryOperator
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Contract rule 2.8: custom primitives and surfaces. */
class OwnPrimitiveTest {
    /** A disk in screen space with the depth of a bowl: it has no linear form and no cursor of its own. */
    private class Disk(private val raster: Raster, private val middle: Int, private val radius: Int) : Primitive {
        override val rowStart: Int get() = maxOf(middle - radius, 0)
        override val rowEnd: Int get() = minOf(middle + radius + 1, raster.height)
        override val columnStart: Int get() = maxOf(middle - radius, 0)
        override val columnEnd: Int get() = minOf(middle + radius + 1, raster.width)

        override fun spans(y: Int, spans: Spans) {
            val rest = radius * radius - (y - middle) * (y - middle)
            if (rest < 0) return
            var half = 0
            while ((half + 1) * (half + 1) <= rest) half++
            spans.add(maxOf(middle - half, 0), minOf(middle + half + 1, raster.width))
        }

        override fun depth(x: Int, y: Int): Int {
            val dx = x - middle
            val dy = y - middle
            return (1 shl 30) + (dx * dx + dy * dy) * 1000
        }

        override fun shade(fragment: Fragment) {
            fragment.setColor(fragment.x / 16f, fragment.y / 16f, 0f)
        }
    }

    private val raster = Raster(16, 16)
    private val disk = Disk(raster, 8, 5)

    @Test
    fun rule_2_8_aDiskIsRendered() {
        val image = ZBufferRenderer().render(Frame(raster, listOf(disk)))
        val expected = SampleSet.where(16, 16) { x, y -> (x - 8) * (x - 8) + (y - 8) * (y - 8) <= 25 }
        assertEquals(expected, disk.samples(raster))
        assertEquals(expected, disk.samplesByCursor(raster, 0))
        assertEquals(
            expected,
            disk.samplesByCursor(raster, 7).also {
                for (y in 0 until 7) {
                    for (x in 0 until 16) {
                        it[x, y] = expected[x, y]
                    }
                }
            }
        )
        assertEquals(expected, SampleSet.where(16, 16) { x, y -> image.primitive(x, y) == 0 })
        assertEquals((1 shl 30) + 13_000, image.depth(10, 5))
        assertEquals(Rgba(10 / 16f, 5 / 16f, 0f).toArgb(), image.argb(10, 5))
    }

    /** A surface that consists of two spheres and a part that is never visible. */
    private class Dumbbell(override val material: Material) : Surface {
        private val left = Sphere(Vector3d(-1.0, 0.0, 0.0), 0.8, material)
        private val right = Sphere(Vector3d(1.0, 0.0, 0.0), 0.8, material)
        override val bounds: Box get() = left.bounds!!.union(right.bounds!!)

        override fun primitives(setUp: SetUp): Sequence<Primitive> =
            sequenceOf(left, Sphere(Vector3d(), 0.0), right).map { setUp.sphere(it) }

        override fun withMaterials(change: UnaryOperator<Material>): Surface = Dumbbell(change.apply(material))
    }

    @Test
    fun aSurfaceOfOnesOwnIsASurface() {
        val red = Material(shading = Shading.CONSTANT, baseColor = Rgba(1f, 0f, 0f))
        val scene = scene { add(Dumbbell(red)) }.withViewpoint(Camera.fit(0.0, 0.0))
        val image = ZBufferRenderer().render(scene.frame(64, 32))
        assertEquals(3, image.counters.primitives)
        assertEquals(setOf(-1, 0, 2), image.primitive.toSet())
        assertEquals(0, image.primitive(20, 16))
        assertEquals(2, image.primitive(44, 16))
        val blue = scene.withMaterials { it.withShader { f -> f.setColor(0f, 0f, 1f) } }
        assertEquals(0xFF0000FF.toInt(), ZBufferRenderer().render(blue.frame(64, 32)).argb(20, 16))
        assertEquals(0xFFFF0000.toInt(), image.argb(20, 16))
    }

    @Test
    fun surfacesThatHaveNoMaterialStayThemselves() {
        val bare = object : Surface {
            override val bounds: Box? get() = null
            override fun primitives(setUp: SetUp): Sequence<Primitive> = emptySequence()
        }
        assertEquals(bare, bare.withMaterials { Material() })
        assertEquals(0, scene { add(bare) }.frame(4, 4).primitives.size)
    }

    /** A custom surface that answers all that a scene asks its surfaces. */
    private class Flag(
        override val material: Material,
        override val origin: Vector3dc = Vector3d(),
        override val pixelSize: Double = 0.0,
    ) : Surface {
        override val bounds: Box get() = Box(-1.0, -1.0, -1.0, 1.0, 1.0, 1.0)
        override val setUpBytes: Long get() = 1_000_000

        override fun primitives(setUp: SetUp): Sequence<Primitive> =
            sequenceOf(setUp.sphere(Sphere(origin, 1.0, material)))

        override fun hasUvs(set: Int): Boolean = set == 1

        override fun withMaterials(change: UnaryOperator<Material>): Surface =
            Flag(change.apply(material), origin, pixelSize)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aSurfaceOfOnesOwnAnswersForItself() {
        // Its material decides about exposure, sections and shadows
        val metal = Scene(listOf(Flag(Material().asMetallicRoughness().withSides(Sides.FRONT))))
        assertEquals(ToneMapping.Curve.NEUTRAL, metal.effectiveToneMapping.curve)
        val cut = Section(listOf(Section.Plane.x(0.0))).of(metal).scene.surfaces.single()
        assertEquals(Sides.BOTH, cut.material?.sides)
        val glass = Material(Rgba(1f, 1f, 1f, 0.5f), alphaMode = AlphaMode.BLEND)
        val above = Camera.orthographic(Vector3d(0.0, 5.0, 0.0), Vector3d(), Vector3d(0.0, 0.0, -1.0), 6.0, 0.1, 10.0)
        fun seen(surfaces: List<Surface>) =
            TiledRenderer().render(Scene(surfaces, viewpoint = above).frame(16, 16)).pixelHash()
        fun shadow(of: Flag) = seen(listOf(GroundShadow.of(Scene(listOf(of)))))
        assertNotEquals(seen(emptyList()), shadow(Flag(Material())))
        for (light in listOf(Flag(glass), Flag(Material(), pixelSize = 2.0))) {
            assertEquals(seen(emptyList()), shadow(light))
        }

        // So do its origin, its size in samples, its memory and its texture coordinates
        val far = Vector3d(1e6, 2e6, 3e6)
        assertEquals(far, Scene(listOf(Flag(Material(), far))).origin)
        val wide = Scene(listOf(Flag(Material(), pixelSize = 3000.0)))
        assertTrue("3000.0" in SuperSampling(4).obstacle(wide, Raster(8, 8)).orEmpty())
        assertEquals(1_000_000, wide.setUpBytes)
        val both = Scene(listOf(Flag(Material()), Sphere(Vector3d(), 1.0)))
        val painted = both.withMaterials { it.withTexture(SampleScenes.checks) }
        assertEquals(listOf(null, SampleScenes.checks), painted.surfaces.map { it.material?.texture })
    }
}
