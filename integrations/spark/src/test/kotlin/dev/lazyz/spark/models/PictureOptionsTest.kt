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
import java.nio.file.Path
import kotlin.io.path.writeBytes
import org.apache.spark.sql.Row
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The options give the pictures and the messages of the library. */
class PictureOptionsTest {
    private val usual = PictureSettings().withDefault(PictureParameters.SIZE, ImageSize(40, 30))

    @TempDir
    lateinit var folder: Path

    private val files = listOf(PictureParameters.TEXTURE, PictureParameters.MATCAP)

    private fun row(words: String, model: ByteArray = Models.OBJ.toByteArray()): Row =
        RenderModel().call(model, "a.obj", words)

    private fun Row.text(column: String): String? = getString(ModelPictures.schema.fieldIndex(column))

    private fun assertSame(words: Map<String, String>) {
        val all = (mapOf("size" to "40x30") + words).entries.joinToString(" ") { "${it.key}=${it.value}" }
        val model = Models.OBJ.toByteArray()
        val row = row(all, if (files.any { it.name in words }) PictureWords.archive(model) else model)
        folder.resolve("picture.png").writeBytes(PictureWords.picture())
        val image = try {
            val asked = PictureDoor.SPARK.read(usual, words.toList()).also { it.check() }
            val settings = files.filter { asked[it] != null }
                .fold(asked) { all, file -> all.with(file, folder.resolve("${asked[file]}")) }
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
    fun archivesHaveModelsWithTheirFiles() {
        val zip = PictureWords.archive(Models.OBJ.toByteArray())
        assertEquals(row("").text("hash"), row("model=MODEL.obj", zip).text("hash"))
        val missing = row("model=b.obj", zip).text("error")
        assertEquals("a.obj: there is no file 'b.obj' in it; it has model.obj, picture.png", missing)
        val lonely = row("matcap=picture.png").text("error")
        assertEquals("a.obj: is no ZIP archive, so 'matcap' has no effect; send one, or omit it", lonely)
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
