package dev.lazyz.server

import java.io.ByteArrayOutputStream
import java.time.Duration
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Clients that are slow, wrong or hostile. */
class AttackTest {
    private val config =
        ServerConfig(port = 0, renders = 1, memory = 64L shl 20, renderTime = Duration.ofMinutes(10), log = {})
    private val head = "POST /render?size=8 HTTP/1.1\r\nHost: x\r\n"

    private fun attack(config: ServerConfig = this.config, act: (Client) -> Unit) =
        RenderServer(config).start().use { server ->
            val client = Client(server)
            act(client)

            // Nothing is left behind, and the next client has its picture
            client.await("lazyz_requests_open", 0)
            client.await("lazyz_upload_memory_bytes", 0)
            client.await("lazyz_render_memory_bytes", 0)
            assertEquals(200, client.post("/render?size=8", Client.MODEL).statusCode())
        }

    private fun Client.answer(text: String): String = open(text).use { it.getInputStream().text() }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun slowHeadersAreCutOff() = attack(config.withIdleTime(Duration.ofSeconds(5))) { client ->
        val slow = listOf("POST /render HTTP/1.1\r\nX-Slow: ", "").map { client.open(it) }
        for (connection in slow) assertEquals("", connection.use { it.getInputStream().text() })
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aSlowUploadIsCutOff() = attack(config.withUploadTime(Duration.ofSeconds(5))) { client ->
        val answer = client.answer(head + "Content-Length: 1000\r\n\r\nv 0 0 0\n")
        assertTrue(answer.startsWith("HTTP/1.1 408 ")) { answer }
        assertTrue("connection: close" in answer.lowercase()) { answer }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun anUploadThatTricklesIsCutOff() = attack(config.withUploadRate(1L shl 40)) { client ->
        val answer = client.answer(head + "Content-Length: 1000\r\n\r\nv 0 0 0\n")
        assertTrue(answer.startsWith("HTTP/1.1 408 ") && "bytes a second" in answer) { answer }
    }

    @Test
    fun aClientThatGoesAwayDuringTheUploadLeavesNothing() = attack { client ->
        client.open(head + "Content-Length: 1000\r\n\r\nv 0 0 0\n").use {
            Client.await({ "no upload" }) { client.metric("lazyz_upload_memory_bytes") > 0 }
        }
        client.await("lazyz_requests_total{status=\"499\"}", 1)
    }

    @Test
    fun largeUploadsAreRefusedBeforeTheyAreRead() = attack(config.withBody(100)) { client ->
        val announced = client.answer(head + "Expect: 100-continue\r\nContent-Length: 101\r\n\r\n")
        assertTrue(announced.startsWith("HTTP/1.1 413 ") && "at most 100 bytes" in announced) { announced }
        val chunked = client.answer(head + "Transfer-Encoding: chunked\r\n\r\n65\r\n" + "#".repeat(101))
        assertTrue(chunked.startsWith("HTTP/1.1 413 ")) { chunked }
        val endless = client.answer(head + "Content-Length: 99999999999999999999\r\n\r\n")
        assertTrue(endless.startsWith("HTTP/1.1 400 ")) { endless }
    }

    @Test
    fun aClientThatAsksFirstMaySend() = attack { client ->
        val asking = head + "Connection: close\r\nExpect: 100-continue\r\n"
        client.open(asking + "Content-Length: ${Client.MODEL.size}\r\n\r\n").use {
            val wait = "HTTP/1.1 100 Continue\r\n\r\n"
            assertEquals(wait, it.getInputStream().readNBytes(wait.length).decodeToString())
            it.send(Client.MODEL.decodeToString())
            assertTrue("200 OK" in it.getInputStream().text())
        }
        val other = client.answer(head + "Expect: miracles\r\nContent-Length: 5\r\n\r\n")
        assertTrue(other.startsWith("HTTP/1.1 417 ")) { other }
    }

    @Test
    fun whatIsNotHttpIsRefused() = attack { client ->
        val long = "x".repeat(9_000)
        assertTrue(client.answer("\u0016\u0003\u0001 hello\r\n\r\n").startsWith("HTTP/1.1 400 "))
        assertTrue(client.answer("GET /${long.take(4100)} HTTP/1.1\r\n\r\n").startsWith("HTTP/1.1 414 "))
        assertTrue(client.answer("GET / HTTP/1.1\r\nX: $long\r\n\r\n").startsWith("HTTP/1.1 431 "))
        val chunk = client.answer(head + "Transfer-Encoding: chunked\r\n\r\nnumber\r\n")
        assertTrue(chunk.startsWith("HTTP/1.1 400 ")) { chunk }
        val target = client.answer("POST /render?view=%zz HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
        assertTrue(target.startsWith("HTTP/1.1 400 ") && "the address cannot be read" in target) { target }
    }

    @Test
    fun severalRequestsOnAConnectionAreAnsweredInOrder() = attack { client ->
        client.open("GET / HTTP/1.1\r\nHost: x\r\n\r\nHEAD / HTTP/1.1\r\nHost: x\r\n\r\n").use {
            it.send("GET /none HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
            assertEquals(listOf(200, 200, 404), Client.statuses(it.getInputStream().text()))
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun bombsAreRefusedWithinTheLimits() = attack { client ->
        val bombs = mapOf(
            "PLY with many vertices" to (
                "ply" to "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\n" +
                    "property float x\nproperty float y\nproperty float z\nend_header\n"
                ).toBytes(),
            "ZIP bomb" to ("3mf" to zipBomb("3D/3dmodel.model")),
            "archive" to ("obj" to zipBomb("a.obj")),
        )
        for ((name, bomb) in bombs) {
            val answer = client.post("/render?size=8&format=${bomb.first}", bomb.second)
            val text = answer.body().decodeToString()
            assertEquals(422, answer.statusCode()) { "$name: $text" }
            val beginning = if (name.startsWith("PLY")) "nothing of the model remains to show: model" else "model"
            assertTrue("\"detail\":\"$beginning" in text) { "$name: $text" }
        }
    }

    private fun Pair<String, String>.toBytes() = first to second.toByteArray()

    /** 200 MB of spaces before the model, in 200 KB. */
    private fun zipBomb(name: String): ByteArray {
        val bytes = ByteArrayOutputStream()
        ZipOutputStream(bytes).use { zip ->
            zip.putNextEntry(ZipEntry(name))
            zip.write("<model unit='millimeter'>".toByteArray())
            val spaces = ByteArray(1 shl 20) { ' '.code.toByte() }
            repeat(200) { zip.write(spaces) }
        }
        return bytes.toByteArray()
    }
}
