package dev.lazyz.server.render

import dev.lazyz.aov.Aov
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.outputs.ContactSheet
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.scenes.writers.animation.AnimationFiles
import dev.lazyz.server.Client
import dev.lazyz.server.RenderServer
import dev.lazyz.server.ServerConfig
import dev.lazyz.shared.PictureWords
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.camera.FittedViewpoint.View
import java.io.ByteArrayOutputStream
import java.net.URLEncoder
import java.nio.file.Path
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import javax.imageio.ImageIO
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The parameters give the pictures and the messages of the library. */
class ParametersTest {
    private val usual = PictureSettings().withDefault(PictureParameters.SIZE, ImageSize(40, 30))

    @TempDir
    lateinit var folder: Path

    private fun assertSame(format: SceneFormat, model: String, words: Map<String, String>) {
        val hasFiles = PictureSettings.FILES.any { it.name in words }
        val body = model.toByteArray().let { if (hasFiles) PictureWords.archive(it) else it }
        for ((name, bytes) in PictureWords.files) folder.resolve(name).writeBytes(bytes)
        val query = (mapOf("size" to "40x30") + words).entries.joinToString("&") { (name, word) ->
            "$name=${URLEncoder.encode(word, Charsets.UTF_8)}"
        }
        val answer = client.post("/render?$query", body)
        val text = answer.body().decodeToString()
        val image = try {
            val asked = PictureDoor.SERVICE.read(usual, words.toList()).also { it.check() }
            val settings = asked.files.entries
                .fold(asked) { all, (parameter, file) -> all.with(parameter, folder.resolve("$file")) }
            val observer = PictureObserver()
            settings.frame(Scenes.load(model.byteInputStream(), format), observer = observer).render(TiledRenderer())
        } catch (e: IllegalArgumentException) {
            assertTrue(answer.statusCode() in listOf(400, 422)) { "$words: ${e.message}" }
            assertTrue(e.message.orEmpty() in text) { "$words: ${e.message}\n$text" }
            return
        }
        if (image.counters.fragments == 0L) {
            assertEquals(422, answer.statusCode()) { "$words" }
            return
        }
        assertEquals(200, answer.statusCode()) { "$words: $text" }
        val picture = ImageIO.read(answer.body().inputStream())
        val argb = picture.getRGB(0, 0, picture.width, picture.height, null, 0, picture.width)
        assertEquals(image.argb.asList(), argb.asList()) { "$format with $words" }
    }

    @Test
    fun eachParameterHasThePicturesAndMessagesOfTheLibrary() {
        for (words in PictureWords.combinations(PictureDoor.SERVICE.parameters.map { it.name })) {
            assertSame(SceneFormat.OBJ, WEDGE, words)
        }
    }

    @Test
    fun defaultsDependOnTheModel() {
        assertSame(SceneFormat.STL, FACET, mapOf())
        assertSame(SceneFormat.PLY, DARK, mapOf())
    }

    @Test
    fun aPictureOfOneColorOrOfAPartSaysSo() {
        val answer =
            client.post("/render?size=40x30&color=white&light-intensity=0&background=black", WEDGE.toByteArray())
        assertEquals("one_color", answer.headers().firstValue("lazyz-blank").orElse("missing"))
        val usual = client.post("/render?size=40x30", WEDGE.toByteArray())
        assertTrue(usual.headers().firstValue("lazyz-blank").isEmpty)
        assertTrue(usual.headers().firstValue("lazyz-cropped").isEmpty)
        val near = client.post("/render?size=40x30&zoom=3", WEDGE.toByteArray())
        assertEquals("true", near.headers().firstValue("lazyz-cropped").orElse("missing"))
    }

    @Test
    fun archivesHaveModelsWithTheirFiles() {
        val textured = "mtllib a.mtl\nusemtl a\nvt 0 0\nvt 1 0\nvt 0 1\n" + WEDGE.replace("f 1 3 2", "f 1/1 3/3 2/2")
        fun zip(vararg files: Pair<String, String>): ByteArray {
            val bytes = ByteArrayOutputStream()
            ZipOutputStream(bytes).use { zip ->
                for ((name, text) in files) {
                    zip.putNextEntry(ZipEntry(name))
                    zip.write(if (name.endsWith(".png")) PictureWords.picture() else text.toByteArray())
                }
            }
            return bytes.toByteArray()
        }
        val looks = "a.mtl" to "newmtl a\nmap_Kd looks/picture.png\n"
        val whole = zip("a.obj" to textured, looks, "looks/picture.png" to "")
        val answer = client.post("/render?size=40x30&view=front", whole, "Content-Type", "application/zip")
        assertEquals(200, answer.statusCode()) { answer.body().decodeToString() }
        assertTrue(answer.headers().allValues("lazyz-warning").isEmpty()) { "${answer.headers()}" }
        val part = client.post("/render?size=40x30&view=front", zip("a.obj" to textured, looks))
        val warning = part.headers().allValues("lazyz-warning").single()
        assertTrue("looks/picture.png" in warning && "lazyz-" !in warning) { warning }

        fun refused(status: Int, detail: String, query: String, body: ByteArray) {
            val text = client.post("/render?size=8&$query", body).run { "${statusCode()} ${body().decodeToString()}" }
            assertTrue(text.startsWith("$status ") && detail in text && "/tmp" !in text) { text }
        }
        val two = zip("a.obj" to WEDGE, "b.obj" to WEDGE, "c.txt" to WEDGE)
        refused(422, "it has 2 models, a.obj, b.obj; choose one", "", two)
        refused(422, "there is no file 'd.obj' in it", "model=d.obj", two)
        assertEquals(200, client.post("/render?size=8&model=b.obj", two).statusCode())
        assertEquals(200, client.post("/render?size=8&model=c.txt&format=obj", two).statusCode())
        refused(422, "is no ZIP archive, so 'model' has no effect", "model=a.obj", WEDGE.toByteArray())
        refused(422, "is no ZIP archive, so 'texture' has no effect", "texture=/etc/passwd", WEDGE.toByteArray())
        refused(422, "there is no file '/etc/passwd' in it", "texture=/etc/passwd", zip("a.obj" to WEDGE))
        refused(422, "'../a.obj' is no name of a file in an archive", "", zip("../a.obj" to WEDGE))
        refused(422, "no file in it is a model", "", zip("a.png" to ""))
        refused(422, "", "format=3mf", zip("a.obj" to WEDGE))
        refused(400, "a scene is no model", "format=scene", zip("a.obj" to WEDGE))
        refused(422, "there is no file '${"d".repeat(150)}'", "model=${"d".repeat(150)}", two)
        refused(400, "matcap: a value has at most 250 characters", "matcap=${"d".repeat(251)}", two)
    }

    /** What is wrong with an archive is no fault of the server. */
    @Test
    fun damagedArchivesAreAnsweredWithoutABug() {
        val bugs = ConcurrentLinkedQueue<LogRecord>()
        val handler = object : Handler() {
            override fun publish(record: LogRecord) {
                bugs += record
            }

            override fun flush() = Unit

            override fun close() = Unit
        }
        val logger = Logger.getLogger("dev.lazyz.server").also { it.addHandler(handler) }
        try {
            val archive = PictureWords.archive(WEDGE.toByteArray())
            for (at in listOf(40, 44, 50)) {
                val damaged = archive.clone().also { it[at] = (it[at] + 0x55).toByte() }
                val answer = client.post("/render?size=8", damaged)
                val text = answer.body().decodeToString()
                assertEquals(422, answer.statusCode()) { text }
                assertTrue("is damaged: " in text) { text }
            }
            assertEquals(emptyList<LogRecord>(), bugs.toList())
        } finally {
            logger.removeHandler(handler)
        }
    }

    /** Each of them can have as much as the model. */
    @Test
    fun texturesMatcapsAndSurroundingsArePartOfThePlan() {
        val most = 1L shl 20
        val archive = PictureWords.archive(WEDGE.toByteArray())
        fun need(vararg words: Pair<String, String>): Long {
            val query = (words.toMap() + ("size" to "8")).mapValues { listOf(it.value) }
            val needs = ArrayList<Long>()
            PictureMaker(LoadLimits(), most).picture(archive, null, PictureRequest.of(query, 64), 0, needs::add)
            return needs.first()
        }
        assertEquals(most, need("matcap" to "picture.png") - need())
        assertEquals(most, need("environment" to "sky.hdr") - need())
    }

    /** The bytes are those that the library writes. */
    @Test
    fun dataOfPixelsAndTurnsAreAnswers() {
        val settings = usual.with(PictureParameters.AA, 2)
        val loaded = Scenes.load(WEDGE.byteInputStream(), SceneFormat.OBJ)
        fun answer(query: String) = client.post("/render?size=40x30&aa=2&$query", WEDGE.toByteArray())

        val data = answer("aov=normal,depth")
        val aovs = settings.frame(loaded).render(TiledRenderer(), { _, _, _, _ -> }, setOf(Aov.DEPTH, Aov.NORMAL))
        val expected = ByteArrayOutputStream().also { AovFiles.writeArchive(it, aovs.images) }.toByteArray()
        assertEquals("application/zip", data.headers().firstValue("content-type").get())
        assertTrue(data.headers().firstValue("etag").get().endsWith("-depth-normal\"")) { "${data.headers()}" }
        assertArrayEquals(expected, data.body())

        // Data differ although pixels are the same
        val farther = WEDGE.replace(" 0\n", " 7\n").replace(" 1\n", " 8\n")
        for ((query, isSame) in mapOf("view=front" to true, "view=front&aov=position" to false)) {
            val tags = listOf(WEDGE, farther).map { model ->
                val seen = client.post("/render?size=40x30&projection=orthographic&$query", model.toByteArray())
                seen.headers().firstValue("etag").get()
            }
            assertEquals(isSame, tags[0] == tags[1]) { "$query: $tags" }
        }

        val turn = answer("turntable=3&frames-per-second=5&zoom=2")
        val turntable = settings.with(PictureParameters.ZOOM, 2.0).turntable(loaded, 3)
        val file = folder.resolve("turn.png")
        AnimationFiles.write(file, Animation(40, 30, 3, 5, turntable.frame(0).alpha)) { sink ->
            for (step in 0 until 3) turntable.frame(step).render(TiledRenderer(), sink)
        }
        assertEquals("image/apng", turn.headers().firstValue("content-type").get())
        assertEquals("true", turn.headers().firstValue("lazyz-cropped").get())
        assertArrayEquals(file.readBytes(), turn.body())

        val views = answer("views=top,front&background=tan")
        val tan = settings.withWord(PictureParameters.BACKGROUND, "tan")
        val sheet = ContactSheet.of(tan, listOf("top", "front"))
        for ((cell, view) in listOf(View.TOP, View.FRONT).withIndex()) {
            sheet.put(cell, tan.with(PictureParameters.VIEW, view).frame(loaded).render(TiledRenderer()).argb)
        }
        assertTrue(views.headers().firstValue("etag").get().endsWith("-top-front\"")) { "${views.headers()}" }
        assertArrayEquals(ByteArrayOutputStream().also { sheet.write(it) }.toByteArray(), views.body())

        val mistakes = mapOf(
            "views=top,down" to "views: 'down' is not one of front, back",
            "views=top&view=iso" to "views cannot be combined with view",
            "views=top&aov=depth" to "aov cannot be combined with views",
            "aov=depth,deep" to "aov: 'deep' is not one of depth, normal",
            "aov=shading-calls" to "aov: 'shading-calls' is not one of",
            "turntable=1" to "turntable: '1' is no whole number in 2..3600",
            "turntable=x" to "turntable: 'x' is no",
            "turntable=1000&size=200" to "at most 16777216 pixels in all: 200x200, 1000 times",
            "turntable=3&aov=depth" to "aov cannot be combined with turntable",
            "turntable=3&eye=1,2,3" to "turntable cannot be combined with eye",
            "frames-per-second=5" to "frames-per-second needs turntable",
            "turntable=3&frames-per-second=51" to "frames-per-second: '51' is no whole number in 1..50",
        )
        for ((query, message) in mistakes) {
            val text = answer(query).run { "${statusCode()} ${body().decodeToString()}" }
            assertTrue(text.startsWith("400 ") && message in text) { "$query: $text" }
        }
    }

    private companion object {
        const val WEDGE = "v 0 0 0\nv 4 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"

        /** Of a format in which z points up. */
        const val FACET = "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 1\n" +
            "endloop\nendfacet\nendsolid\n"

        /** Dark enough for more light. */
        const val DARK = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" +
            "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n" +
            "property list uchar int vertex_indices\nend_header\n" +
            "0 0 0 20 9 9\n1 0 0 9 20 9\n0 1 0.5 9 9 20\n3 0 1 2\n"

        val server = RenderServer(ServerConfig(port = 0, log = {})).start()
        val client = Client(server)

        @AfterAll
        @JvmStatic
        fun close() = server.close()
    }
}
