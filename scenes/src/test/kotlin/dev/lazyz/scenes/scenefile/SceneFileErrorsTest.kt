package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.Scenes
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.surface.Mesh
import java.nio.file.Path
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments
import org.junit.jupiter.params.provider.Arguments.arguments
import org.junit.jupiter.params.provider.MethodSource

@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class SceneFileErrorsTest {
    @ParameterizedTest
    @MethodSource("faults")
    fun messageSaysWhereWhatAndWhatToDo(text: String, location: String?, message: String) {
        val error = assertThrows(SceneFormatException::class.java) { SceneFile.parse(text, "a.json") }
        assertEquals(location, error.location)
        assertTrue(message in error.message.orEmpty(), "<$message> should be in <${error.message}>")
        assertTrue(error.message.orEmpty().startsWith("a.json"), error.message)
    }

    @Test
    fun hopelessNestingIsAnErrorAndNoStackOverflow() {
        for (bracket in listOf("[", "{\"a\":", "[{\"a\":")) {
            val text = "{\"lazyz\": 1, \"surfaces\": " + bracket.repeat(1_000_000)
            val error = assertThrows(SceneFormatException::class.java) { SceneFile.parse(text) }
            assertTrue("nested more than 64 deep" in error.message.orEmpty(), error.message)
        }
    }

    @Test
    fun whatIsNotUtf8IsAnError() {
        val source = Source(byteArrayOf(0x7B, 0xFF.toByte(), 0x7D), "a.json", Path.of("."))
        val error = assertThrows(SceneFormatException::class.java) { SceneFileReader(source).read() }
        assertTrue("UTF-8" in error.message.orEmpty(), error.message)
    }

    @Test
    fun everyPrefixOfAFileIsAnErrorAndNothingElse() {
        val text = SceneFile.format(Scenes.builtin("star")!!).trimEnd()
        for (length in text.indices) {
            assertThrows(SceneFormatException::class.java) { SceneFile.parse(text.substring(0, length)) }
        }
    }

    @Test
    fun theTextureOfAModelNeedsItsCoordinates(@TempDir folder: Path) {
        folder.resolve("t.png").writeBytes(PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9))))
        val bare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"
        folder.resolve("bare.obj").writeText(bare)
        folder.resolve("mixed.obj").writeText(bare + "vt 0 0\nf 1/1 2/1 3/1\n")
        fun load(model: String): LoadedScene {
            val file = folder.resolve("scene.json")
            file.writeText(surface(""""mesh": "$model", "material": {"texture": {"image": "t.png"}}"""))
            return Scenes.load(file)
        }

        val error = assertThrows(SceneFormatException::class.java) { load("bare.obj") }
        assertEquals("surfaces[2].mesh", error.location)
        assertTrue("\"bare.obj\" has no texture coordinates for the texture" in error.message!!, error.message)
        val loaded = load("mixed.obj")
        assertTrue("1 of 2 surfaces of mixed.obj have no texture coordinates" in loaded.warnings.single())
        assertEquals(listOf(false, true), loaded.scene.surfaces.drop(2).map { (it as Mesh).material.texture != null })
    }

    private companion object {
        fun file(members: String): String = """{"lazyz": 1, $members}"""

        fun surface(members: String): String = file(""""surfaces": [{}, {}, {$members}]""")
            .replace("{}", """{"sphere": {"center": [0, 0, 0], "radius": 1}}""")

        @JvmStatic
        fun faults(): List<Arguments> = listOf(
            // Unknown keys
            arguments(file(""""lihgts": []"""), "lihgts", "unknown key \"lihgts\"; did you mean \"lights\"?"),
            arguments(
                surface(""""sphere": {"center": [0, 0, 0], "radius": 1}, "materail": "red""""),
                "surfaces[2].materail", "unknown key \"materail\"; did you mean \"material\"?",
            ),
            arguments(file(""""camera": {"fit": {"x": 1}}"""), "camera.fit.x", "known here: azimuth, elevation"),
            arguments(file(""""a b": 1"""), "[\"a b\"]", "unknown key \"a b\""),
            // The version
            arguments("""{"lazyz": 2, "new": 1}""", "lazyz", "version 2 is not supported; this library reads"),
            arguments("""{"surfaces": []}""", null, "begin it with \"lazyz\": 1"),
            arguments("""{"asset": {"version": "2.0"}}""", null, "is glTF, not a scene file; name it *.gltf"),
            arguments("[]", null, "must be an object"),
            // Types and ranges
            arguments(file(""""size": [640]"""), "size", "needs 2 numbers, width and height, not 1"),
            arguments(file(""""size": [0, 10]"""), "size", "width must be in 1..262144: 0"),
            arguments(file(""""size": [6.5, 10]"""), "size[0]", "must be a whole number, not 6.5"),
            arguments(file(""""up": "w""""), "up", "write one of \"x\", \"-x\", \"y\", \"-y\", \"z\", \"-z\""),
            arguments(file(""""background": "mud""""), "background", "#rrggbb"),
            arguments(file(""""background": [1, 2]"""), "background", "needs 3 or 4 numbers, not 2"),
            arguments(file(""""background": null"""), "background", "must be a colour"),
            arguments(file(""""background": [0, "x", 0]"""), "background[1]", "must be a number, not the text \"x\""),
            arguments(file(""""background": [0, 1e99, 0]"""), "background[1]", "1e99 is too large"),
            arguments(file(""""background": [0, 01, 0]"""), "line 1, column 33", "is not JSON: Invalid numeric value"),
            arguments(
                file(""""background": [0, NaN, 0]"""),
                "line 1, column 35", "is not JSON: Non-standard token 'NaN'",
            ),
            arguments(file(""""camera": {"fit": {"elevation": 91}}"""), "camera.fit", "-90..90 degrees: 91"),
            arguments(file(""""camera": {"fit": {"fieldOfView": 141}}"""), "camera.fit", "at most 140.0 degrees: 141"),
            arguments(file(""""camera": {}"""), "camera", "\"orthographic\", \"screen\", \"fit\""),
            arguments(file(""""camera": {"screen": {"near": 2}}"""), "camera.screen", "near must be less than far"),
            arguments(file(""""up": "z", "camera": {"screen": {}}"""), "camera.screen", "remove \"up\""),
            arguments(file(""""depth": {"test": "lesser"}"""), "depth.test", "\"less\", \"less-or-equal\""),
            arguments(file(""""depth": {"background": -1}"""), "depth", "must be in 0..2147483647: -1"),
            arguments(file(""""camera": {"perspective": {}}"""), "camera.perspective", "\"eye\" is missing"),
            arguments(
                file(""""lights": [{"directional": {"direction": [0, 0, 0]}}]"""),
                "lights[0].directional", "must be finite and not zero",
            ),
            arguments(file(""""lights": "sunny""""), "lights", "\"sunny\" is not known here; write one of \"studio\""),
            arguments(file(""""lights": ["sun"]"""), "lights[0]", "must be an object with ambient, directional"),
            arguments(file(""""lights": {"sun": {}}"""), "lights", "must be a list, not an object"),
            arguments(file(""""lightIntensity": -1"""), "lightIntensity", "must be 0 or more, and finite: -1.0"),
            arguments(file(""""lightIntensity": "NaN""""), "lightIntensity", "must be 0 or more, and finite: NaN"),
            arguments(file(""""lightIntensity": "Infinity""""), "lightIntensity", "0 or more, and finite: Infinity"),
            arguments(file(""""lightIntensity": "2""""), "lightIntensity", "must be a number, not the text \"2\""),
            arguments(
                file(""""materials": {"red": {"shininess": 5000}}"""),
                "materials.red", "shininess must be in 1..1024: 5000",
            ),
            arguments(
                file(""""materials": {"red": {"shading": "shiny"}}"""),
                "materials.red.shading", "\"flat\"",
            ),
            arguments(
                file(""""materials": {"red": {"texture": "data:image/png;base64,!"}}"""),
                "materials.red.texture", "is not base64",
            ),
            arguments(
                file(""""materials": {"red": {"texture": "data:image/png;base64,AAAA"}}"""),
                "materials.red.texture", "is not a PNG",
            ),
            // Surfaces
            arguments(
                surface(""""sphere": {"center": [0, 0, 0], "radius": 1}, "material": "gold""""),
                "surfaces[2].material", "there is no material \"gold\"; add it to \"materials\"",
            ),
            arguments(surface(""""material": {}"""), "surfaces[2]", "add one of \"mesh\", \"polygon\", \"sphere\""),
            arguments(
                surface(""""mesh": "a.obj", "sphere": {}"""),
                "surfaces[2]", "has \"mesh\" and \"sphere\"; keep one",
            ),
            arguments(
                surface(""""sphere": {"center": [0, 0, 0], "radius": -1}"""),
                "surfaces[2].sphere", "not be negative",
            ),
            arguments(
                surface(""""mesh": {"positions": [0, 0, 0], "triangles": [0, 0, 1]}"""),
                "surfaces[2].mesh", "vertex number must be in 0..0: 1",
            ),
            arguments(surface(""""mesh": "a.obj""""), "surfaces[2].mesh", "there is no folder to look for a.obj in"),
            arguments(surface(""""mesh": "a.json""""), "surfaces[2].mesh", "a scene file cannot contain another"),
            arguments(surface(""""builtin": "teepot""""), "surfaces[2].builtin", "known: teapot, cycle"),
            arguments(
                surface(""""builtin": {"name": "star", "seed": 1}"""),
                "surfaces[2].builtin.seed", "\"star\" has no parameter \"seed\"",
            ),
            arguments(
                surface(""""builtin": {"name": "teapot", "segments": 0}"""),
                "surfaces[2].builtin", "segments must be in 1..256: 0",
            ),
            arguments(
                surface(""""builtin": "molecule", "transform": [{"scale": [1, 2, 1]}]"""),
                "surfaces[2].transform", "",
            ),
            arguments(
                surface(""""builtin": "star", "transform": [{"scale": 0}]"""),
                "surfaces[2].transform[0].scale", "be 0",
            ),
            arguments(
                surface(""""builtin": "star", "smoothNormals": 10"""),
                "surfaces[2].smoothNormals", "is for meshes",
            ),
            // Text that is not JSON
            arguments(file(""""up": "y", "up": "z""""), "line 1, column 25", "key \"up\" is given twice"),
            arguments("{\"lazyz\": 1,\n \"size\": [1, 2\n}", "line 3, column 1", "is not JSON: "),
            arguments("{\"lazyz\": 1,\n}", "line 2, column 1", "is not JSON: Unexpected character ('}'"),
            arguments("{}\u2028", "line 1, column 3", "is not JSON: Unexpected character"),
            arguments("", null, "is not JSON: there is no value"),
        )
    }
}
