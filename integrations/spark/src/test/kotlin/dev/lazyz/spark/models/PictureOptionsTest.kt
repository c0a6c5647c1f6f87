package dev.lazyz.spark.models

import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.Scenes
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.shared.PictureWords
import dev.lazyz.spark.ModelPictures
import dev.lazyz.spark.Models
import dev.lazyz.spark.RenderModel
import dev.lazyz.strategies.tiled.TiledRenderer
import org.apache.spark.sql.Row
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

/** The options give the pictures and the messages of the library. */
class PictureOptionsTest {
    private val usual = PictureSettings().withDefault(PictureParameters.SIZE, ImageSize(40, 30))

    private fun row(words: String): Row = RenderModel().call(Models.OBJ.toByteArray(), "a.obj", words)

    private fun Row.text(column: String): String? = getString(ModelPictures.schema.fieldIndex(column))

    private fun assertSame(words: Map<String, String>) {
        val row = row((mapOf("size" to "40x30") + words).entries.joinToString(" ") { "${it.key}=${it.value}" })
        val image = try {
            val settings = PictureDoor.SPARK.read(usual, words.toList()).also { it.check() }
            val loaded = Scenes.load(Models.OBJ.toByteArray(), SceneFormat.OBJ, "a.obj")
            settings.frame(loaded, observer = PictureObserver("a.obj")).render(TiledRenderer())
        } catch (e: IllegalArgumentException) {
            assertEquals(e.message, row.text("error"), "$words")
            return
        }
        assertNull(row.text("error"), "$words")
        assertEquals(image.pixelHash(), row.text("hash"), "$words")
    }

    @Test
    fun eachParameterHasThePicturesAndMessagesOfTheLibrary() {
        for (words in PictureWords.combinations(PictureDoor.SPARK.parameters.map { it.name })) assertSame(words)
    }

    @Test
    fun commasSeparateWordsOrBelongToThem() {
        val words = "size=40x30,eye=5,4,9 background=red,blue,edges=true"
        assertEquals(row("edges background=red,blue eye=5,4,9 size=40x30").text("hash"), row(words).text("hash"))
    }

    @Test
    fun aPictureOfOneColorOrOfAPartSaysSo() {
        assertEquals("one_color", row("light-intensity=0 background=black").text("blank"))
        assertNull(row("").text("blank"))
        val cropped = listOf("", "zoom=3").map { row(it).getBoolean(ModelPictures.schema.fieldIndex("cropped")) }
        assertEquals(listOf(false, true), cropped)
    }
}
