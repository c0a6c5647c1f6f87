package dev.lazyz.world.light

import dev.lazyz.RenderOptions
import dev.lazyz.shading.pbr.EnvironmentView
import dev.lazyz.shading.pbr.PhysicalSurface
import dev.lazyz.world.camera.Camera
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contract rule 6.17: the light of a picture. */
class EnvironmentMapTest {
    /** Sky that is brighter above, and a sun of a few texels that has about a third of all light. */
    private fun sky(width: Int, sun: Float): EnvironmentMap = EnvironmentMap.of(width, width / 2, picture(width, sun))

    private fun picture(width: Int, sun: Float): FloatArray {
        val height = width / 2
        return FloatArray(3 * width * height) {
            val row = it / 3 / width
            val column = it / 3 % width
            val isSun = row in height / 4 until height / 4 + 2 && column in width / 3 until width / 3 + 2
            val base = 0.2f + 0.6f * (height - row) / height + 0.3f * (column % (width / 4)) / width
            if (isSun) sun else base * (1f - 0.1f * (it % 3))
        }
    }

    private fun seen(map: EnvironmentMap, direction: Vector3d, roughness: Double): FloatArray = FloatArray(3).also {
        val (x, y, z) = listOf(direction.x, direction.y, direction.z).map { n -> n.toFloat() }
        map.light.radiance(x, y, z, roughness.toFloat(), it, 0)
    }

    private fun received(map: EnvironmentMap, direction: Vector3d): FloatArray = FloatArray(3).also {
        val (x, y, z) = listOf(direction.x, direction.y, direction.z).map { n -> n.toFloat() }
        map.light.irradiance(x, y, z, it, 0)
    }

    /** Directions that divide the sphere evenly (Fibonacci). */
    private fun sphere(count: Int) = List(count) {
        val y = 1.0 - (2.0 * it + 1.0) / count
        val angle = it * Math.PI * (3.0 - Math.sqrt(5.0))
        val level = Math.sqrt(1.0 - y * y)
        Vector3d(level * Math.cos(angle), y, level * Math.sin(angle))
    }

    private val directions = sphere(17)

    /** The green light that microfacets reflect from points between all texels, one by one, in double precision. */
    private fun blurred(picture: FloatArray, width: Int, axis: Vector3d, alpha: Double): Double {
        val height = width / 2
        fun texel(column: Int, row: Int) =
            picture[3 * (row.coerceIn(0, height - 1) * width + Math.floorMod(column, width)) + 1].toDouble()
        var sum = 0.0
        var all = 0.0
        for (row in 0 until FINE * height) {
            val polar = Math.PI * (row + 0.5) / (FINE * height)
            val v = (row + 0.5) / FINE - 0.5
            val j = Math.floor(v).toInt()
            for (column in 0 until FINE * width) {
                val light = toward(polar, 2 * Math.PI * ((column + 0.5) / (FINE * width) - 0.5))
                val cosine = light.dot(axis)
                if (cosine <= 0.0) continue
                val u = (column + 0.5) / FINE - 0.5
                val i = Math.floor(u).toInt()
                val upper = texel(i, j) + (texel(i + 1, j) - texel(i, j)) * (u - i)
                val lower = texel(i, j + 1) + (texel(i + 1, j + 1) - texel(i, j + 1)) * (u - i)
                val squareH = (1 + cosine) / 2
                val weight = cosine * Math.sin(polar) / Math.pow(squareH * (alpha * alpha - 1) + 1, 2.0)
                sum += weight * (upper + (lower - upper) * (v - j))
                all += weight
            }
        }
        return sum / all
    }

    private fun toward(polar: Double, turn: Double) =
        Vector3d(-Math.sin(polar) * Math.sin(turn), Math.cos(polar), Math.sin(polar) * Math.cos(turn))

    @Test
    fun rule_6_17_blurredLightIsTheMeanUnderTheLobe() {
        val width = 256
        val picture = picture(width, 100f)
        val map = EnvironmentMap.of(width, width / 2, picture)

        // The sun is around the corner of four texels
        val toSun = toward(Math.PI * 33 / 128, 2 * Math.PI * (86.0 / 256 - 0.5))
        fun roughness(level: Double) = (level + 2.5) / (43 - 3.5 * level)
        for ((level, most) in listOf(3 to 0.05, 5 to 0.02, 6 to 0.015, 8 to 0.015, 9 to 0.015)) {
            val roughness = roughness(level.toDouble())
            for (axis in sphere(4) + toSun) {
                val exact = blurred(picture, width, axis, roughness * roughness)
                assertEquals(exact, seen(map, axis, roughness)[1].toDouble(), most * exact) { "$roughness, $axis" }
            }
        }

        // Between the levels, it is interpolated, and a sun is little brighter than it should be
        for (level in 1 until 9) {
            for (axis in sphere(50) + toSun) {
                val (first, second) = listOf(level, level + 1).map { seen(map, axis, roughness(it.toDouble()))[1] }
                val between = seen(map, axis, roughness(level + 0.25))[1]
                assertEquals(0.75f * first + 0.25f * second, between, 1e-5f * first)
            }
            val roughness = roughness(maxOf(level, 2) + 0.5)
            val ratio = seen(map, toSun, roughness)[1] / blurred(picture, width, toSun, roughness * roughness)
            assertEquals(1.0, ratio, 0.2) { "$roughness" }
        }
        for (axis in sphere(50)) {
            val (first, second) = listOf(0.0, roughness(1.0)).map { seen(map, axis, it)[1] }
            assertEquals((first + second) / 2, seen(map, axis, roughness(1.0) / 2)[1], 1e-5f * first)
        }
    }

    /** Nothing is lost and nothing added, whatever the size of the picture. */
    @Test
    fun rule_6_17_uniformLightStaysUniform() {
        for ((width, height) in listOf(1 to 1, 3 to 7, 32 to 16)) {
            val map = EnvironmentMap.of(width, height, FloatArray(3 * width * height) { 0.25f + 0.5f * (it % 3) })
            for (direction in directions + Vector3d(0.0, -1.0, 0.0) + Vector3d(1.0, 0.0, 0.0)) {
                val white = floatArrayOf(0.25f, 0.75f, 1.25f)
                for (roughness in 0..16) assertArrayEquals(white, seen(map, direction, roughness / 16.0), 1e-5f)
                assertArrayEquals(white, received(map, direction), 1e-3f)
            }
        }
    }

    @Test
    fun rule_6_17_theNumberOfThreadsHasNoEffect() {
        val random = Random(617)
        val picture = FloatArray(3 * 48 * 24) { random.nextFloat() * if (it % 577 == 0) 65504f else 1f }
        val one = EnvironmentMap.of(48, 24, picture, RenderOptions(threads = 1))
        val four = EnvironmentMap.of(48, 24, picture, RenderOptions(threads = 4))
        for (direction in sphere(5000)) {
            val roughness = random.nextDouble()
            assertArrayEquals(seen(one, direction, roughness), seen(four, direction, roughness))
            assertArrayEquals(received(one, direction), received(four, direction))
        }
    }

    /** Up is up, the middle is in front, and what is right in the picture is right for whoever looks there. */
    @Test
    fun rule_6_17_directionsAreThoseOfThePicture() {
        val width = 32
        fun spot(column: Int, row: Int) = FloatArray(3 * width * width / 2) {
            val across = Math.floorMod(it / 3 % width - column + 2, width)
            if (across < 4 && it / 3 / width in row - 2 until row + 2) 1f else 0f
        }

        val maps = HashMap<Pair<Int, Int>, EnvironmentMap>()

        fun seen(column: Int, row: Int, rotation: Double, x: Double, y: Double, z: Double): Float {
            val map = maps.getOrPut(column to row) { EnvironmentMap.of(width, width / 2, spot(column, row)) }
            val up = Vector3d(0.0, 1.0, 0.0)
            val camera = Camera.perspective(Vector3d(1.0, 2.0, 3.0), Vector3d(), up, 45.0, 1.0, 10.0)
            val surface = FloatArray(PhysicalSurface.SIZE)
            EnvironmentView.of(Environment.of(map, 2f, rotation), camera)!!
                .radiance(x.toFloat(), y.toFloat(), z.toFloat(), 0f, surface)
            return surface[PhysicalSurface.RADIANCE]
        }
        assertEquals(2f, seen(16, 8, 0.0, 0.0, 0.0, 1.0), 0.1f)
        assertEquals(2f, seen(24, 8, 0.0, -1.0, 0.0, 0.0), 0.1f)
        assertEquals(2f, seen(8, 8, 0.0, 1.0, 0.0, 0.0), 0.1f)
        assertEquals(2f, seen(0, 8, 0.0, 0.0, 0.0, -1.0), 0.1f)
        assertEquals(2f, seen(16, 4, 0.0, 0.0, Math.sqrt(0.5), Math.sqrt(0.5)), 0.1f)
        assertEquals(2f, seen(16, 8, 90.0, 1.0, 0.0, 0.0), 0.1f)
        assertEquals(2f, seen(16, 8, -90.0, -1.0, 0.0, 0.0), 0.1f)
        assertEquals(0f, seen(16, 8, 90.0, 0.0, 0.0, 1.0), 0.1f)
    }

    /** A sun of the greatest strength gives numbers, and no spots: neighbours differ by what the lobe changes. */
    @Test
    fun rule_6_17_brightSunsGiveSmoothLight() {
        val map = sky(64, EnvironmentMap.MOST)
        for (roughness in listOf(0.25, 0.5, 0.75, 1.0)) {
            var before = Double.NaN
            for (step in 0..2000) {
                val angle = step * Math.PI / 1000
                val light = seen(map, Vector3d(Math.cos(angle), 0.3, Math.sin(angle)).normalize(), roughness)
                for (channel in light) assertTrue(channel.isFinite() && channel >= 0f)
                val own = Math.log(1e6 + light[1])
                if (!before.isNaN()) assertTrue(Math.abs(own - before) < 0.25) { "$roughness at $step: $before, $own" }
                before = own
            }
        }
    }

    @Test
    fun wrongPicturesAreRefused() {
        for (wrong in listOf(-0.001f, Float.NaN, Float.POSITIVE_INFINITY, 1.1e9f)) {
            val error = assertThrows(IllegalArgumentException::class.java) {
                EnvironmentMap.of(2, 1, floatArrayOf(0f, 1f, 2f, 3f, 4f, wrong))
            }
            assertTrue("of texel 1" in error.message.orEmpty(), error.message)
        }
        assertThrows(IllegalArgumentException::class.java) { EnvironmentMap.of(2, 2, FloatArray(6)) }
        assertThrows(IllegalArgumentException::class.java) { EnvironmentMap.of(0, 1, FloatArray(0)) }
        assertThrows(InterruptedException::class.java) {
            Thread.currentThread().interrupt()
            sky(64, 1f)
        }
    }

    private companion object {
        /** Points that are tried for each texel, across and down. */
        const val FINE = 2
    }
}
