package dev.lazyz.world.surface

import dev.lazyz.Depth
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.SampleSet
import dev.lazyz.samples
import dev.lazyz.setup.setUp
import dev.lazyz.spi.Fragment
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 2.10: lines. */
class LinesTest {
    private val raster = Raster(24, 18)
    private val onScreen = setUp(raster, Camera.screen(), emptyList())

    private fun line(
        from: Vector3d,
        to: Vector3d,
        width: Double,
        material: Material = Material(),
        setUp: SetUp = onScreen,
    ): Primitive {
        val positions = listOf(from, to).flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }
        return setUp.lines(Lines(positions.toFloatArray(), intArrayOf(0, 1), width, material)).single()
    }

    @Test
    fun rule_9_7_aLineIsCutAtThePlanesBeforeItIsWidened() {
        // From z = -1 to 1 in screen space: half of it is in front of the near plane, and the cut is at its centre
        val cut = line(Vector3d(4.5, 9.5, -1.0), Vector3d(20.5, 9.5, 1.0), 1.0)
        assertEquals(SampleSet.where(24, 18) { x, y -> y == 9 && x in 12..20 }, cut.samples(raster))
        assertEquals(Depth.NEAR, cut.depth(12, 9))
        assertEquals(0, line(Vector3d(4.5, 9.5, -1.0), Vector3d(20.5, 9.5, -0.5), 1.0).samples(raster).size)
        assertEquals(0, line(Vector3d(4.5, 9.5, 2.0), Vector3d(20.5, 9.5, 1.5), 1.0).samples(raster).size)
        assertEquals(0, line(Vector3d(4.5, 9.5, Double.NaN), Vector3d(20.5, 9.5, 0.5), 1.0).samples(raster).size)

        // Starts far outside the guard band
        val long = line(Vector3d(-1e9, 9.5, 0.5), Vector3d(1e9, 9.5, 0.5), 3.0)
        assertEquals(SampleSet.where(24, 18) { _, y -> y in 8..10 }, long.samples(raster))
    }

    @Test
    fun rule_3_6_attributesAreThoseOfTheSegmentInSpace() {
        // Along the line of sight; its centre in space is far from its centre on the screen; clipped at the near plane
        val camera = Camera.perspective(Vector3d(), Vector3d(0.0, 0.0, -1.0), Vector3d(0.0, 1.0, 0.0), 90.0, 1.0, 100.0)
        val place = Material(shader = { it.setColor(it.worldX, it.worldZ, it.vertexRed, it.vertexAlpha) })
        val ends = floatArrayOf(-0.5f, 0f, 0.5f, 2f, 0f, -9f)
        val colors = floatArrayOf(0f, 0f, 0f, 0.5f, 1f, 0f, 0f, 0.5f)
        val setUp = setUp(Raster(100, 100), camera, emptyList())
        val line = setUp.lines(Lines(ends, intArrayOf(0, 1), 1.0, place, colors)).single()
        val samples = line.samples(Raster(100, 100))
        val fragment = Fragment()
        for (x in 45 until 61) {
            fragment.moveTo(x, (0 until 100).first { samples[x, it] })
            line.shade(fragment)

            // The point where the ray through the column meets the segment, which is at x = -0.5 + 2.5 s, z = 0.5 - 9.5
            // s
            val tangent = (x + 0.5) / 50 - 1
            val s = (0.5 - 0.5 * tangent) / (2.5 - 9.5 * tangent)
            assertEquals(-0.5 + 2.5 * s, fragment.red.toDouble(), 0.01 + 0.05 * s)
            assertEquals(0.5 - 9.5 * s, fragment.green.toDouble(), 0.01 + 0.05 * s)
            assertEquals(s, fragment.blue.toDouble(), 0.01)
            assertEquals(0.5f, fragment.alpha)
        }
    }

    @Test
    fun rule_6_7_aLineShowsItsOwnColour() {
        val material =
            Material(Rgba(0.5f, 1f, 1f), SampleScenes.checks, Shading.PHONG, Rgba.WHITE, emission = Rgba(0f, 0f, 0.25f))
        val line = line(Vector3d(2.5, 3.5, 0.5), Vector3d(20.5, 3.5, 0.5), 1.0, material)
        val fragment = Fragment().also { it.moveTo(5, 3) }
        line.shade(fragment)
        assertEquals(listOf(0.5f, 1f, 1.25f, 1f), listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha))
    }

    @Test
    fun rule_2_7_aMaskCutsALine() {
        val material = Material(alphaMode = AlphaMode.MASK, alphaCutoff = 0.5f)
        val lines = Lines(
            floatArrayOf(0.5f, 3.5f, 0.5f, 20.5f, 3.5f, 0.5f), intArrayOf(0, 1), 1.0, material,
            floatArrayOf(1f, 1f, 1f, 0f, 1f, 1f, 1f, 1f),
        )
        val samples = onScreen.lines(lines).single().samples(raster)
        assertEquals(SampleSet.where(24, 18) { x, y -> y == 3 && x in 10..20 }, samples)
    }

    @Test
    fun rule_5_6_aLineSaysWhetherItIsTranslucent() {
        val ends = floatArrayOf(0.5f, 3.5f, 0.5f, 20.5f, 3.5f, 0.5f, 9f, 9f, 0.5f)
        val colors = FloatArray(12) { if (it == 11) 0.5f else 1f }
        fun translucent(material: Material) =
            onScreen.lines(Lines(ends, intArrayOf(0, 1, 1, 2), 1.0, material, colors)).map { it.isTranslucent }.toList()
        assertEquals(listOf(false, false), translucent(Material()))
        assertEquals(listOf(false, true), translucent(Material(alphaMode = AlphaMode.BLEND)))
        assertEquals(listOf(true, true), translucent(Material(Rgba(1f, 1f, 1f, 0.5f), alphaMode = AlphaMode.BLEND)))
    }

    @Test
    fun wrongLinesAreRefused() {
        fun refused(message: String, make: () -> Lines) {
            val thrown = assertThrows(IllegalArgumentException::class.java) { make() }
            assertTrue(thrown.message!!.contains(message)) { thrown.message }
        }
        refused("triples") { Lines(FloatArray(4), IntArray(0)) }
        refused("pairs") { Lines(FloatArray(3), IntArray(1)) }
        refused("width") { Lines(FloatArray(3), IntArray(0), 0.0) }
        refused("width") { Lines(FloatArray(3), IntArray(0), Double.POSITIVE_INFINITY) }
        refused("colors") { Lines(FloatArray(3), IntArray(0), colors = FloatArray(3)) }
        refused("0..0: 1") { Lines(FloatArray(3), intArrayOf(0, 1)) }
    }
}
