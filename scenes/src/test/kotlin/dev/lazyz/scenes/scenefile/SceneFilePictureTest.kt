package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.shared.PictureWords
import dev.lazyz.strategies.tiled.TiledRenderer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The object `picture` gives the pictures and the messages of the settings. */
class SceneFilePictureTest {
    private val usual = PictureSettings(40, 30)

    private fun file(picture: String): LoadedScene = parsed(
        """{"lazyz": 1, "picture": {$picture}, "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}},
            {"mesh": {"positions": [0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 2], "triangles": [0, 2, 1, 0, 1, 3]}}]}""",
        "a.json",
    )

    private fun hash(loaded: LoadedScene, settings: PictureSettings): String = try {
        settings.frame(loaded).render(TiledRenderer()).pixelHash()
    } catch (e: IllegalArgumentException) {
        "${e.message}"
    }

    @Test
    fun eachParameterHasThePicturesAndMessagesOfTheLibrary() {
        for (words in PictureWords.combinations(PictureDoor.SCENE_FILE.parameters.map { it.name })) {
            val text = words.entries.joinToString { (name, word) -> "\"$name\": \"$word\"" }
            val settings = try {
                PictureDoor.SCENE_FILE.read(usual, words.toList()).also { it.check() }
            } catch (e: IllegalArgumentException) {
                val error = assertThrows(SceneFormatException::class.java, { file(text) }, text)
                assertTrue(e.message.orEmpty() in error.message.orEmpty()) { "${e.message}\n${error.message}" }
                continue
            }
            assertEquals(hash(file(""), settings), hash(file(text), usual), text)
        }
    }

    @Test
    fun whoAsksForAPictureHasTheLastWord() {
        val red = file("\"color\": \"red\", \"edge-width\": 2, \"edges\": true, \"cut\": [\"x=0.5\", \"y=50%\"]")
        val blue = PictureDoor.SCENE_FILE.read(usual, listOf("color" to "blue"))
        val both = listOf("edge-width" to "2", "edges" to "true", "cut" to "x=0.5", "cut" to "y=50%")
        assertEquals(hash(file(""), PictureDoor.SCENE_FILE.read(blue, both)), hash(red, blue))

        // What excludes it does not count
        val wireframe = usual.with(PictureParameters.WIREFRAME, true)
        assertEquals(hash(file(""), wireframe), hash(red, wireframe))
    }

    @Test
    fun whatTheFileSaysOtherwiseIsNoParameter() {
        val error = assertThrows(SceneFormatException::class.java) { file("\"zoom\": 2") }
        assertTrue("there is no parameter 'zoom'" in error.message.orEmpty(), error.message)
    }
}
