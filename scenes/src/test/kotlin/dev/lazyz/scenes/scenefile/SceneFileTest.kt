package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.shared.PictureWords
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.Viewpoint
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.EnvironmentMap
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.writeBytes
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class SceneFileTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun theLeastFileIsAnEmptyScene() {
        val loaded = parsed("""{"lazyz": 1}""")
        assertEquals(0, loaded.scene.surfaces.size)
        assertEquals(Rgba.WHITE, loaded.scene.background)
        assertEquals(null, loaded.size)
    }

    @Test
    fun coloursAreSrgbAsTextAndLinearAsNumbers() {
        assertEquals(Rgba.ofRgb(0x336699), background("\"#336699\""))
        assertEquals(Rgba.ofRgb(0x87CEEB), background("\"skyblue\""))
        assertEquals(Rgba(0.5f, 2f, 0f), background("[0.5, 2, 0]"))
        assertEquals(Rgba(0.5f, 2f, 0f, 0.25f), background("[0.5, 2, 0, 0.25]"))
    }

    @Test
    fun aFileThatPointsUpAlongZIsTurned() {
        val scene = parsed(
            """
            {"lazyz": 1, "up": "z",
             "camera": {"orthographic": {"eye": [1, 2, 3], "target": [0, 0, 0], "up": [0, 0, 1],
                                         "height": 2, "near": 1, "far": 9}},
             "lights": [{"point": {"position": [1, 2, 3]}}],
             "surfaces": [{"sphere": {"center": [1, 2, 3], "radius": 1}, "transform": [{"translate": [0, 0, 10]}]}]}
            """,
        ).scene
        assertEquals(Vector3d(1.0, 13.0, -2.0), (scene.surfaces.single() as Sphere).center)
        assertEquals(Vector3d(1.0, 3.0, -2.0), (scene.viewpoint as Camera).eye)
        assertEquals(Vector3d(1.0, 3.0, -2.0), (scene.lights.single() as Light.Point).position)
    }

    @Test
    fun glassIsTranslucentUnlessItSaysOtherwise() {
        fun modes(members: String) = parsed(
            """{"lazyz": 1, "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": {$members}}]}""",
        ).scene.surfaces.map { (it as Sphere).material.alphaMode }

        val glass = """"metallicRoughness": {"transmission": {}}"""
        assertEquals(listOf(Material.AlphaMode.BLEND), modes(glass))
        assertEquals(listOf(Material.AlphaMode.OPAQUE), modes(""""alphaMode": "opaque", $glass"""))
        assertEquals(listOf(Material.AlphaMode.OPAQUE), modes(""""metallicRoughness": {"sheen": {"color": "red"}}"""))
    }

    @Test
    fun surfacesShareTheMaterialThatTheyName() {
        val sphere = """{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "red"}"""
        val scene = parsed(
            """{"lazyz": 1, "materials": {"red": {"baseColor": "#ff0000"}}, "surfaces": [$sphere, $sphere]}""",
        ).scene
        val (first, second) = scene.surfaces.map { (it as Sphere).material }
        assertSame(first, second)
        assertEquals("red", first.name)
        assertEquals(Rgba(1f, 0f, 0f), first.baseColor)
    }

    @Test
    fun builtInScenesTakeTheirParameters() {
        val teapot = """{"name": "teapot", "segments": 2}"""
        val text = """{"lazyz": 1, "surfaces": [{"builtin": $teapot}, {"builtin": "cycle"}]}"""
        val surfaces = parsed(text).scene.surfaces
        assertEquals(64 * 4 - 16, (surfaces[0] as Mesh).triangleCount)
        assertEquals(4, surfaces.size)
    }

    @Test
    fun aFileIsWrittenAndReadBack() {
        val path = folder.resolve("a.json")
        val camera = Camera.perspective(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 33.3, 1.0, 9.0)
        SceneFile.write(Scene(emptyList(), viewpoint = camera), path, ImageSize(12, 34))
        val loaded = Scenes.load(path)
        assertEquals(ImageSize(12, 34), loaded.size)
        val projection = (loaded.scene.viewpoint as Camera).projection as Projection.Perspective
        assertEquals(33.3, projection.verticalFieldOfView)
        assertEquals(listOf(path), Files.list(folder).use { it.toList() })
    }

    @Test
    fun aNameMeansAnArrangementOfLights() {
        fun read(members: String) =
            parsed("""{"lazyz": 1, $members, "surfaces": [{"sphere": {"center": [1, 2, 3], "radius": 1}}]}""")
        for ((word, rig) in SceneFileNames.lightRigs) {
            for (view in listOf("", """, "up": "z", "camera": {"fit": {"azimuth": 200, "elevation": -40}}""")) {
                val loaded = read(""""lights": "$word"$view""")
                val scene = loaded.scene
                assertEquals(rig, loaded.lightRig)
                assertEquals(rig.environment, scene.environment)
                val expected = rig.lights(scene.camera(64, 9))
                assertEquals(expected.map { it.color }, scene.lights.map { it.color })
                for ((one, other) in expected.zip(scene.lights)) {
                    if (one is Light.Directional) {
                        assertTrue(one.direction.distance((other as Light.Directional).direction) < 1e-9)
                    }
                }
                assertEquals(rig, loaded.withScene(scene).lightRig)
            }
        }

        // An environment of the file replaces that of the rig
        val lit = read(""""lights": "sun", "environment": {"studio": 2}""")
        assertEquals(Environment.studio(2f), lit.scene.environment)
        assertNull(read(""""lights": []""").lightRig)
    }

    @Test
    fun picturesOfSurroundingsAreFilesBesideIt() {
        folder.resolve("sky.hdr").writeBytes(PictureWords.sky())
        folder.resolve("sky.png").writeBytes(PictureWords.picture())
        fun read(environment: String) =
            parsed("""{"lazyz": 1, "environment": $environment}""", "a.json", folder)
        val loaded = read("""{"picture": {"image": "sky.hdr", "intensity": 2, "rotation": -90}}""")
        val map = Scenes.environment(folder.resolve("sky.hdr"))
        assertEquals(Environment.of(map, 2f, -90.0), loaded.scene.environment)
        assertEquals(listOf(folder.resolve("sky.hdr")), loaded.files)
        assertEquals(Environment.of(map), read("""{"picture": {"image": "SKY.hdr"}}""").scene.environment)
        for ((environment, message) in mapOf(
            """{"picture": {"image": "no.hdr"}}""" to "no.hdr is missing",
            """{"picture": {"image": "sky.png"}}""" to "sky.png, byte 0: is no Radiance picture",
            """{"picture": {"image": "sky.hdr", "intensity": -1}}""" to "must be 0 or more: -1",
            """{"studio": 1, "picture": {"image": "sky.hdr"}}""" to "keep one of",
        )) {
            val error = assertThrows(SceneFormatException::class.java) { read(environment) }
            assertTrue(message in error.message.orEmpty()) { "$message: ${error.message}" }
        }
    }

    @Test
    fun whatCannotBeWrittenIsRefusedBeforeAFileIsTouched() {
        val path = folder.resolve("a.json")
        Files.writeString(path, "old")
        val shader = Material().withShader { }
        val odd = listOf(
            Scene(listOf(Sphere(Vector3d(), 1.0, shader))) to "surfaces[0] has one of its own",
            Scene(emptyList(), viewpoint = Viewpoint { _, _ -> error("") }) to "withViewpoint",
            Scene(emptyList()).withAmbientVisibility { _, _, _, _, _, _ -> 1f } to "withAmbientVisibility(null)",
            Scene(emptyList()).withEnvironment(Environment.of(EnvironmentMap.of(1, 1, FloatArray(3)))) to
                "withEnvironment(null) instead, and name the picture's file",
        )
        for ((scene, message) in odd) {
            val error = assertThrows(IllegalArgumentException::class.java) { SceneFile.write(scene, path) }
            assertTrue(message in error.message.orEmpty(), error.message)
        }
        assertEquals("old", Files.readString(path))
    }

    private fun background(json: String): Rgba =
        parsed("""{"lazyz": 1, "background": $json}""").scene.background
}
