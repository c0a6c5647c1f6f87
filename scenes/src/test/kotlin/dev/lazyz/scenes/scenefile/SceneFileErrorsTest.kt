package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
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
        val error = assertThrows(SceneFormatException::class.java) { parsed(text, "a.json") }
        assertEquals(location, error.location)
        assertTrue(message in error.message.orEmpty(), "<$message> should be in <${error.message}>")
        assertTrue(error.message.orEmpty().startsWith("a.json"), error.message)
    }

    @Test
    fun hopelessNestingIsAnErrorAndNoStackOverflow() {
        for (bracket in listOf("[", "{\"a\":", "[{\"a\":")) {
            val text = "{\"lazyz\": 1, \"surfaces\": " + bracket.repeat(1_000_000)
            val error = assertThrows(SceneFormatException::class.java) { parsed(text) }
            assertTrue("nested more than 64 deep" in error.message.orEmpty(), error.message)
        }
    }

    @Test
    fun whatIsNotUtf8IsAnError() {
        val source = Source(byteArrayOf(0x7B, 0xFF.toByte(), 0x7D), "a.json", Path.of("."))
        val error =
            assertThrows(SceneFormatException::class.java) { SceneFileReader(source) { _, _ -> error("") }.read() }
        assertTrue("UTF-8" in error.message.orEmpty(), error.message)
    }

    @Test
    fun everyPrefixOfAFileIsAnErrorAndNothingElse() {
        val text = SceneFile.format(Scenes.builtin("star")!!).trimEnd()
        for (length in text.indices) {
            assertThrows(SceneFormatException::class.java) { parsed(text.substring(0, length)) }
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
        fun faults(): List<Arguments> =
            checkNotNull(SceneFileErrorsTest::class.java.getResource("faults.txt")).readText().lines()
                .filterNot { it.startsWith("#") }.dropLastWhile { it.isEmpty() }
                .chunked(3) { (text, location, message) ->
                    val place = location.trim().takeIf { it != "-" }
                    arguments(whole(text.replace("\\n", "\n").replace("\\u2028", "\u2028")), place, message.trim())
                }

        private fun whole(text: String): String = when (text.substringBefore(' ')) {
            "file" -> file(text.removePrefix("file "))
            "surface" -> surface(text.removePrefix("surface "))
            else -> text
        }
    }
}
