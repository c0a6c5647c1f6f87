package dev.lazyz.server

import dev.lazyz.Raster
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.camera.Camera
import java.io.ByteArrayInputStream
import java.io.IOException
import java.util.concurrent.ConcurrentLinkedQueue
import javax.imageio.ImageIO
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource

class RenderServerTest {
    @Test
    fun thePictureHasTheBitsOfALocalRendering() {
        val answer = client.post("/render?size=64x48&view=front&aa=2", Client.MODEL, "Content-Type", "model/obj")
        assertEquals(200, answer.statusCode())
        assertEquals("image/png", answer.headers().firstValue("content-type").get())

        val scene = Scenes.load(Client.MODEL, SceneFormat.OBJ).scene.withViewpoint(Camera.fit(0.0, 0.0))
        val local = SuperSampling(2).frame(scene, Raster(64, 48, scene.background)).render(ZBufferRenderer())
        val picture = ImageIO.read(ByteArrayInputStream(answer.body()))
        assertArrayEquals(local.argb, picture.getRGB(0, 0, 64, 48, null, 0, 64))
        assertEquals("\"64x48-${local.pixelHash()}\"", answer.headers().firstValue("etag").get())
    }

    @Test
    fun aPictureThatTheClientHasIsNotSentAgain() {
        val path = "/render?size=16"
        val tag = client.post(path, Client.MODEL).headers().firstValue("etag").get()
        for (known in listOf(tag, "\"other\", W/$tag", "*")) {
            val answer = client.post(path, Client.MODEL, "If-None-Match", known)
            assertEquals(304, answer.statusCode(), known)
            assertEquals(0, answer.body().size)
            assertEquals(tag, answer.headers().firstValue("etag").get())
        }
        assertEquals(200, client.post("/render?size=17", Client.MODEL, "If-None-Match", tag).statusCode())
    }

    @ParameterizedTest
    @CsvSource(
        "400, /render?sise=5, there is no parameter 'sise'",
        "400, /render?size=5y5, is not WIDTHxHEIGHT",
        "400, /render?size=100000, at most 16777216 pixels",
        "400, /render?aa=3, 'aa: ''3'' is not one of 1, 2, 4, 8'",
        "400, /render?zoom=0, zoom: must be in 0.001..1000",
        "400, /render?zoom=NaN, is not a number",
        "400, /render?background=mud, is not a colour",
        "422, /render?format=stl, model",
        "404, /rendering, there is nothing at /rendering",
        "405, /, is read with GET",
        "404, /metrics/, there is nothing at /metrics/",
    )
    fun mistakesAreAnsweredWithAProblem(status: Int, path: String, detail: String) {
        val answer = client.post(path, Client.MODEL)
        val text = answer.body().decodeToString()
        assertEquals(status, answer.statusCode(), text)
        assertEquals("application/problem+json", answer.headers().firstValue("content-type").get())
        assertTrue("\"status\":$status" in text && detail in text) { text }
    }

    @ParameterizedTest
    @CsvSource(
        "image/png, 415", "multipart/form-data; boundary=x, 415", "application/x-zip-compressed, 200", "model/stl, 422",
        "model/obj; a=b, 200",
    )
    fun theTypeDeterminesTheFormat(type: String, status: Int) {
        assertEquals(status, client.post("/render?size=8", Client.MODEL, "Content-Type", type).statusCode())
        assertEquals(200, client.post("/render?size=8&format=obj", Client.MODEL, "Content-Type", type).statusCode())
    }

    @Test
    fun theContentDeterminesTheFormatIfNothingElseDoes() {
        assertEquals(200, client.post("/render?size=8", Client.MODEL).statusCode())
        assertEquals(415, client.post("/render?size=8", "no model".toByteArray()).statusCode())
        val scene = """{"lazyz": 1, "surfaces": []}""".toByteArray()
        assertEquals(415, client.post("/render?size=8", scene).statusCode())
        assertEquals(415, client.post("/render?size=8", Client.MODEL, "Content-Encoding", "gzip").statusCode())
    }

    @Test
    fun whatTheLoaderLeavesOutIsInAHeader() {
        val model = "mtllib ../../etc/passwd\n".toByteArray() + Client.MODEL
        val answer = client.post("/render?size=8", model)
        assertEquals(200, answer.statusCode())
        assertTrue("passwd" in answer.headers().firstValue("lazyz-warning").get())
    }

    /** The loader leaves all of it out, or there is nothing that could cover a sample. */
    @ParameterizedTest
    @ValueSource(
        strings = [
            "v inf inf 0\nv 1 inf 0\nv 0 inf 1\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
            "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n", "v 0 0 0\nf 1 1 1\n",
        ],
    )
    fun aModelOfWhichNothingRemainsIsRefused(model: String) {
        val answer = client.post("/render?size=8", model.toByteArray())
        val text = answer.body().decodeToString()
        assertEquals(422, answer.statusCode(), text)
        assertTrue("nothing of the model" in text && "no area" in text) { text }
    }

    @Test
    fun theReasonsWhyNothingRemainsAreInTheMessage() {
        val model = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n" +
            "end_header\n"
        val answer = client.post("/render?size=8", model.toByteArray())
        val text = answer.body().decodeToString()
        assertEquals(422, answer.statusCode(), text)
        assertTrue("nothing of the model remains to show: model: the file is cut short" in text) { text }
    }

    @Test
    fun messagesToClientsDoNotAdviseOperators() {
        val limits = LoadLimits().withTriangles(1).withNesting(3)
        RenderServer(ServerConfig(port = 0, limits = limits, log = {})).start().use { server ->
            val client = Client(server)
            val models = mapOf("obj" to "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n", "gltf" to "{\"a\":[[[[1]]]]}")
            for ((format, model) in models) {
                val answer = client.post("/render?format=$format", model.toByteArray())
                val text = answer.body().decodeToString()
                assertEquals(422, answer.statusCode(), text)
                assertTrue("limit of this server" in text, text)
                assertFalse(listOf("LoadLimits", "zcli", "-Xmx", "raise").any { it in text }, text)
            }
        }
    }

    @Test
    fun aWarningHas300Characters() {
        val model = "mtllib ${"a".repeat(390)} ${"b".repeat(390)}.mtl\n".toByteArray() + Client.MODEL
        val warning = client.post("/render?size=8", model).headers().firstValue("lazyz-warning").get()
        assertEquals(300, warning.length, warning)
        assertTrue(warning.startsWith("model: material library aaa") && " ... " in warning, warning)
    }

    @Test
    fun pagesAreReadWithGet() {
        assertTrue("light-intensity=FACTOR" in client.get("/").body())
        assertEquals(404, client.get("/favicon.ico").statusCode())
        val get = client.get("/render")
        assertEquals("POST", get.headers().firstValue("allow").get())
        assertEquals(405, get.statusCode())
        client.open("HEAD / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n").use {
            val answer = it.getInputStream().text()
            assertTrue(answer.startsWith("HTTP/1.1 200 OK\r\n") && answer.endsWith("\r\n\r\n")) { answer }
        }
    }

    @Test
    fun aLineOfTheLogHasNoControlCharacters() {
        client.open("GET /a\u0007\u001b[31m HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n").use {
            it.getInputStream().text()
        }
        client.get("/?x=%0a%1b")
        Client.await({ "$log" }) { log.any { "x=%0a" in it } }
        val lines = log.toList()
        assertFalse(lines.any { line -> line.any { it.isISOControl() } }) { "$lines" }
        assertTrue(lines.any { Regex("""\S+Z 127\.0\.0\.1 GET /\?x=%0a%1b 200 \d+B \d+ms""").matches(it) })
    }

    @Test
    fun anAddressThatIsUnknownIsNamed() {
        val unknown = RenderServer(ServerConfig(host = "nowhere.invalid", port = 0, log = {}))
        val failure = assertThrows(IOException::class.java, unknown::start)
        val message = "cannot listen at nowhere.invalid:0: the host is unknown; use the name or number of an address " +
            "of this machine"
        assertEquals(message, failure.message)
    }

    @Test
    fun theNumbersAddUp() {
        RenderServer(ServerConfig(port = 0, adminPort = 0, log = {})).start().use { server ->
            val client = Client(server)
            repeat(3) { client.post("/render?size=8", Client.MODEL) }
            client.post("/render?size=8", "x".toByteArray())
            client.get("/")
            client.await("lazyz_requests_open", 0)
            assertEquals(4.0, client.metric("lazyz_requests_total{status=\"200\"}"))
            assertEquals(1.0, client.metric("lazyz_requests_total{status=\"415\"}"))
            assertEquals(3.0, client.metric("lazyz_render_seconds_count"))
            assertEquals(3.0, client.metric("lazyz_render_seconds_bucket{le=\"+Inf\"}"))
            assertEquals(3.0 * Client.MODEL.size + 1, client.metric("lazyz_received_bytes_total"))
            for (gauge in listOf("renders_waiting", "renders_running", "upload_memory_bytes", "render_memory_bytes")) {
                client.await("lazyz_$gauge", 0)
            }
            assertTrue("# TYPE lazyz_render_seconds histogram\n" in client.get("/metrics").body())
        }
    }

    private companion object {
        val log = ConcurrentLinkedQueue<String>()
        val server = RenderServer(ServerConfig(port = 0, log = log::add)).start()
        val client = Client(server)

        @AfterAll
        @JvmStatic
        fun close() = server.close()
    }
}
