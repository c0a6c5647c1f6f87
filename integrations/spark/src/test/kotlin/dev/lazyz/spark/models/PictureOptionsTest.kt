package dev.lazyz.spark.models

import dev.lazyz.aov.Aov
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.shared.PictureWords
import dev.lazyz.spark.ModelPictures
import dev.lazyz.spark.Models
import dev.lazyz.spark.RenderModel
import dev.lazyz.strategies.tiled.TiledRenderer
import java.io.ByteArrayOutputStream
import java.nio.file.Path
import kotlin.io.path.writeBytes
import org.apache.spark.sql.Row
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The options give the pictures and the messages of the library. */
class PictureOptionsTest {
    private val usual = PictureSettings().withDefault(PictureParameters.SIZE, ImageSize(40, 30))

    @TempDir
    lateinit var folder: Path

    private fun row(words: String, model: ByteArray = Models.OBJ.toByteArray()): Row =
        RenderModel().call(model, "a.obj", words)

    private fun Row.text(column: String): String? = getString(ModelPictures.schema.fieldIndex(column))

    private fun Row.bytes(column: String): ByteArray? = getAs(ModelPictures.schema.fieldIndex(column))

    private fun assertSame(words: Map<String, String>) {
        val all = (mapOf("size" to "40x30") + words).entries.joinToString(" ") { (name, value) ->
            if (' ' in value) "$name=\"$value\"" else "$name=$value"
        }
        val model = Models.OBJ.toByteArray()
        val row = row(all, if (PictureSettings.FILES.any { it.name in words }) PictureWords.archive(model) else model)
        for ((name, bytes) in PictureWords.files) folder.resolve(name).writeBytes(bytes)
        val image = try {
            val asked = PictureDoor.SPARK.read(usual, words.toList()).also { it.check() }
            val settings = asked.files.entries
                .fold(asked) { all, (parameter, file) -> all.with(parameter, folder.resolve("$file")) }
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
        assertEquals("a.obj: there is no file 'b.obj' in it; it has model.obj, picture.png, sky.hdr", missing)
        val lonely = row("matcap=picture.png").text("error")
        assertEquals("a.obj: is no ZIP archive, so 'matcap' has no effect; send one, or omit it", lonely)
    }

    /** The bytes are those of the library. */
    @Test
    fun dataOfPixelsTurnsAndViewsAreColumns() {
        val settings = usual.with(PictureParameters.AA, 2).with(PictureParameters.ZOOM, 2.0)
        val loaded = Scenes.load(Models.OBJ.toByteArray(), SceneFormat.OBJ, "a.obj")
        val data = row("size=40x30 aa=2 zoom=2 aov=normal,depth")
        val frame = settings.frame(loaded)
        val aovs = frame.render(TiledRenderer(), { _, _, _, _ -> }, setOf(Aov.DEPTH, Aov.NORMAL))
        val npz = ByteArrayOutputStream().also { AovFiles.writeArchive(it, aovs.images) }.toByteArray()
        assertArrayEquals(npz, data.bytes("npz"))
        assertEquals(frame.render(TiledRenderer()).pixelHash(), data.text("hash"))
        assertNull(data.bytes("png"))

        for (words in listOf(mapOf("turntable" to "3", "frames-per-second" to "5"), mapOf("views" to "top,front"))) {
            val file = ByteArrayOutputStream()
            val output = PictureOutput.read(words, settings)
            val writer = output.writer(file, settings, loaded)
            for (number in 0 until output.frames) writer.add(writer.frame(number), TiledRenderer())
            val row = row("size=40x30,aa=2,zoom=2," + words.entries.joinToString(",") { "${it.key}=${it.value}" })
            assertArrayEquals(file.toByteArray(), row.bytes("png")) { row.text("error") }
            assertEquals(writer.hash, row.text("hash"))
            assertNull(row.bytes("npz"))
        }
        val mistakes = mapOf(
            "turntable=1" to "turntable: '1' is no whole number in 2..3600",
            "aov=depth output=pixels" to "output cannot be combined with aov",
            "views=top eye=1,2,3" to "views cannot be combined with eye",
            "variant=\"blue" to "a quote has no end: variant=\"blue",
        )
        for ((words, message) in mistakes) assertEquals(message, row(words).text("error"))
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
