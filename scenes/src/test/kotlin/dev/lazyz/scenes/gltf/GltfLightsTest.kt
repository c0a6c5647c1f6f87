package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.Scene
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `KHR_lights_punctual`. */
class GltfLightsTest {
    private val warnings = ArrayList<String>()

    /** A scene of a triangle around the origin, and one node for each of [lights], at (0, 0, 3), turned to face +x. */
    private fun scene(vararg lights: String): Scene {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(-1, -1, 0, 1, -1, 0, 1, 1, 0))
        val nodes = lights.indices.joinToString("") {
            """,{"translation":[0,0,3],"rotation":[0,-0.7071067811865476,0,0.7071067811865476],
                "extensions":{"KHR_lights_punctual":{"light":$it}}}"""
        }
        val json = files.json(
            """"nodes":[{"mesh":0}$nodes],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "extensions":{"KHR_lights_punctual":{"lights":[${lights.joinToString()}]}}""",
        )
        val source = TestSources.of(json)
        return GltfParser.parse(source).also { warnings.addAll(source.warnings) }
    }

    private fun assertVector(x: Double, y: Double, z: Double, actual: org.joml.Vector3dc) =
        assertTrue(Vector3d(x, y, z).distance(actual) < 1e-6) { "$actual" }

    @Test
    fun lightsOfHiddenNodesAreOff() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(-1, -1, 0, 1, -1, 0, 1, 1, 0))
        val light = """"KHR_lights_punctual":{"light":0}"""
        val hidden = """"KHR_node_visibility":{"visible":false}"""
        val json = files.json(
            """"nodes":[{"mesh":0},{"extensions":{$light,$hidden}}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}}""",
        )
        assertEquals(0, GltfParser.parse(TestSources.of(json)).lights.size)
    }

    @Test
    fun illuminanceOverPiIsTheColour() {
        val scene = scene("""{"type":"directional","color":[1,0.5,0],"intensity":3}""")
        val light = scene.lights.single() as Light.Directional
        assertVector(1.0, 0.0, 0.0, light.direction)
        assertEquals(3 / Math.PI, light.color.red.toDouble(), 1e-6)
        assertEquals(1.5 / Math.PI, light.color.green.toDouble(), 1e-6)
        assertEquals(0f, light.color.blue)
    }

    @Test
    fun pointsAndSpotsFallOff() {
        val cone = """"spot":{"innerConeAngle":0.2,"outerConeAngle":0.5}"""
        val spotLight = """{"type":"spot","intensity":20,"range":9,$cone}"""
        val lights = scene("""{"type":"point","intensity":20}""", spotLight).lights
        val point = lights[0] as Light.Point
        assertVector(0.0, 0.0, 3.0, point.position)
        assertEquals(Falloff.inverseSquare(), point.falloff)
        assertEquals(20 / Math.PI, point.color.blue.toDouble(), 1e-5)
        val spot = lights[1] as Light.Spot
        assertVector(1.0, 0.0, 0.0, spot.direction)
        assertEquals(Falloff.inverseSquare(9.0), spot.falloff)
        assertEquals(Math.toDegrees(0.2), spot.innerAngle, 1e-6)
        assertEquals(Math.toDegrees(0.5), spot.outerAngle, 1e-6)
    }

    @Test
    fun lightsOfAnotherUnitAreScaledTogether() {
        // Sunlight of 100000 lux and a weak lamp: the sum at the centre, 3 units from the lamp, becomes 1
        val sunlight = """{"type":"directional","intensity":100000}"""
        val lights = scene(sunlight, """{"type":"point","intensity":9000}""").lights
        val sun = lights[0].color.red.toDouble()
        val lamp = lights[1].color.red.toDouble()
        assertEquals(1.0, sun + lamp / 9, 1e-5)
        assertEquals(100000.0 / 9000.0, sun / lamp, 1e-3)
        val dim = scene("""{"type":"directional","intensity":0.01}""").lights.single()
        assertEquals(1.0, dim.color.red.toDouble(), 1e-5)
        assertEquals(0f, scene("""{"type":"directional","intensity":0}""").lights.single().color.red)
    }

    @Test
    fun invalidLightsArePassedOver() {
        val cone = """"spot":{"innerConeAngle":0.5,"outerConeAngle":0.5}"""
        val behind = """{"type":"point","range":-1}"""
        for (light in listOf("""{"type":"area"}""", "{}", """{"type":"spot",$cone}""", behind)) {
            warnings.clear()
            assertEquals(emptyList<Light>(), scene(light).lights)
            assertTrue("lights[0] is passed over" in warnings.single()) { "$light: $warnings" }
        }
    }
}
