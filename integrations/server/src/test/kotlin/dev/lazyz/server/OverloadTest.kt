package dev.lazyz.server

import java.net.SocketException
import java.time.Duration
import java.util.concurrent.CountDownLatch
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** More requests than the server can answer at once. Each server here renders one picture at a time. */
class OverloadTest {
    private val config = ServerConfig(port = 0, adminPort = 0, renders = 1, queue = 1, log = {})

    private fun Client.begin(path: String) =
        Client.MODEL.decodeToString().let {
            open("POST $path HTTP/1.1\r\nHost: x\r\nContent-Length: ${it.length}\r\n\r\n$it")
        }

    @Test
    fun aFullQueueRefusesFurtherRequests() = RenderServer(config).start().use { server ->
        val client = Client(server)
        val running = client.begin(Client.LONG)
        client.await("lazyz_renders_running", 1)
        val waiting = client.begin("/render?size=8")
        client.await("lazyz_renders_waiting", 1)

        val refused = client.post("/render?size=8", Client.MODEL)
        assertEquals(429, refused.statusCode())
        assertTrue(refused.headers().firstValue("retry-after").get().toInt() > 0)
        val ready = client.get("/health/ready")
        assertEquals(503, ready.statusCode())
        assertEquals("application/problem+json", ready.headers().firstValue("content-type").get())
        assertTrue("\"detail\":\"the queue is full" in ready.body()) { ready.body() }
        assertEquals(200, client.get("/health/live").statusCode())

        // The end of the first client frees its place, and the second has its picture
        running.close()
        val answer = ByteArray(15).also { waiting.getInputStream().readNBytes(it, 0, 15) }.decodeToString()
        assertEquals("HTTP/1.1 200 OK", answer)
        assertEquals(200, client.get("/health/ready").statusCode())
        waiting.close()
        client.await("lazyz_render_memory_bytes", 0)
        client.await("lazyz_upload_memory_bytes", 0)
        assertEquals(1.0, client.metric("lazyz_requests_total{status=\"499\"}"))
        assertEquals(1.0, client.metric("lazyz_requests_total{status=\"429\"}"))
    }

    @Test
    fun aClientThatIsGoneLeavesTheQueue() = RenderServer(config).start().use { server ->
        val client = Client(server)
        client.begin(Client.LONG).use {
            client.await("lazyz_renders_running", 1)
            val waiting = client.begin("/render?size=8")
            client.await("lazyz_renders_waiting", 1)
            waiting.close()
            client.await("lazyz_renders_waiting", 0)
            assertEquals(1.0, client.metric("lazyz_renders_running"))
        }
        client.await("lazyz_renders_running", 0)
        client.await("lazyz_requests_total{status=\"499\"}", 2)
    }

    @Test
    fun workThatTakesTooLongIsStopped() {
        val short = config.withRenderTime(Duration.ofMillis(50))
        RenderServer(short).start().use { server ->
            val client = Client(server)
            val answer = client.post(Client.LONG, Client.MODEL)
            assertEquals(503, answer.statusCode())
            assertTrue("the picture took longer than" in answer.body().decodeToString())
            client.await("lazyz_renders_running", 0)
        }
    }

    @Test
    fun requestsDoNotWaitForever() {
        val short = config.withQueueTime(Duration.ofSeconds(1))
        RenderServer(short).start().use { server ->
            val client = Client(server)
            client.begin(Client.LONG).use {
                client.await("lazyz_renders_running", 1)
                val answer = client.post("/render?size=8", Client.MODEL)
                assertEquals(503, answer.statusCode())
                assertTrue("the model has waited for" in answer.body().decodeToString())
                assertTrue(answer.headers().firstValue("retry-after").isPresent)
            }
        }
    }

    @Test
    fun renderingsWaitForMemory() {
        // Each of these takes more than half of the memory
        val small = config.withRenders(2).withMemory(96L shl 20)
        RenderServer(small).start().use { server ->
            val client = Client(server)
            client.begin("/render?size=2048&aa=8").use {
                client.await("lazyz_renders_running", 1)
                client.begin("/render?size=2048&aa=8").use {
                    client.await("lazyz_renders_waiting", 1)
                    assertEquals(1.0, client.metric("lazyz_renders_running"))
                }
            }
            client.await("lazyz_render_memory_bytes", 0)
            val refused = client.post(Client.LONG, Client.MODEL)
            assertEquals(413, refused.statusCode())
            assertTrue("bytes of memory, and there are" in refused.body().decodeToString())
        }
    }

    /** With the usual 4 x 4 samples a pixel, its side would be too long for a raster. */
    @Test
    fun aWidePictureTakesTheMemoryOfOneSampleAPixel() {
        RenderServer(config.withMemory(192L shl 20)).start().use { server ->
            val client = Client(server)
            val usual = client.post("/render?size=100000x9", Client.MODEL)
            assertEquals(200, usual.statusCode()) { usual.body().decodeToString() }
            val single = client.post("/render?size=100000x9&aa=1", Client.MODEL)
            assertEquals(single.headers().firstValue("etag"), usual.headers().firstValue("etag"))
            val chosen = client.post("/render?size=1x100000&aa=4", Client.MODEL)
            assertEquals(400, chosen.statusCode())
            assertTrue("aa: with 4 x 4 samples a pixel, a side has at most 65536" in chosen.body().decodeToString())
        }
    }

    @Test
    fun tooManyConnectionsAreRefused() = RenderServer(config.withConnections(1)).start().use { server ->
        val client = Client(server)
        client.open("").use { first ->
            client.await("lazyz_connections", 1)
            val second = client.open("").use { it.getInputStream().text() }
            assertTrue(second.startsWith("HTTP/1.1 503 Service Unavailable\r\n")) { second }
            first.send("GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n")
            assertTrue("200 OK" in first.getInputStream().text())
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun closingWaitsForRequestsInWork() {
        val server = RenderServer(config).start()
        val client = Client(server)
        val socket = client.begin("/render?size=2048&aa=1")
        client.await("lazyz_received_bytes_total", Client.MODEL.size)
        server.close()
        assertTrue(socket.use { it.getInputStream().text() }.startsWith("HTTP/1.1 200 OK"))
        server.close()
    }

    /** A client that sends requests and does not wait for answers takes no memory, and no place in the queue. */
    @Test
    fun requestsBeforeTheAnswerAreDropped() = RenderServer(config).start().use { server ->
        val client = Client(server)
        client.begin(Client.LONG).use { socket ->
            client.await("lazyz_renders_running", 1)
            repeat(100) { socket.send("GET / HTTP/1.1\r\nHost: x\r\n\r\n") }
            assertEquals(1.0, client.metric("lazyz_requests_open"))
        }
        client.await("lazyz_renders_running", 0)
        client.await("lazyz_requests_open", 0)
        assertEquals(0.0, client.metric("lazyz_requests_total{status=\"200\"}"))
    }

    @Test
    fun aClientThatSendsTooManyRequestsIsDisconnected() {
        val bugs = ArrayList<String>()
        val handler = object : Handler() {
            override fun publish(record: LogRecord) {
                bugs += record.message
            }

            override fun flush() = Unit

            override fun close() = Unit
        }
        val logger = Logger.getLogger("dev.lazyz.server").apply { addHandler(handler) }
        RenderServer(config).start().use { server ->
            val client = Client(server)
            client.begin(Client.LONG).use { socket ->
                client.await("lazyz_renders_running", 1)
                assertThrows(SocketException::class.java) {
                    repeat(100_000) { socket.send("GET / HTTP/1.1\r\nHost: x\r\n\r\n") }
                }
            }
            client.await("lazyz_renders_running", 0)
            client.await("lazyz_requests_open", 0)
        }
        logger.removeHandler(handler)
        assertEquals(emptyList<String>(), bugs)
    }

    @Test
    fun numbersCanBeReadWhileTheServerIsClosed() {
        val server = RenderServer(config).start()
        val client = Client(server)
        client.begin(Client.LONG).use {
            client.await("lazyz_renders_running", 1)
            val closing = Thread { server.close() }.apply { start() }
            Client.await({ "not closing" }) { closing.state == Thread.State.TIMED_WAITING }
            assertEquals(1.0, client.metric("lazyz_renders_running"))
            it.close()
            closing.join()
        }
        assertThrows(IllegalStateException::class.java) { server.metrics() }
    }

    @Test
    fun aLogThatFailsDoesNotStopTheWork() {
        RenderServer(config.withLog { error("the disk is full") }).start().use { server ->
            val client = Client(server)
            repeat(2) { assertEquals(200, client.get("/").statusCode()) }
            client.await("lazyz_requests_total{status=\"200\"}", 2)
        }
    }

    /** Nobody reads the output of the process. */
    @Test
    fun aLogThatBlocksDoesNotStopTheWork() {
        val released = CountDownLatch(1)
        RenderServer(config.withLog { released.await() }).start().use { server ->
            val client = Client(server)
            repeat(20) { assertEquals(200, client.get("/").statusCode()) }
            assertEquals(200, client.post("/render?size=8", Client.MODEL).statusCode())
        }
        released.countDown()
    }

    @Test
    fun closingStopsWhatTakesTooLong() {
        val server = RenderServer(config.withDrainTime(Duration.ofMillis(1))).start()
        val client = Client(server)
        val socket = client.begin(Client.LONG)
        client.await("lazyz_renders_running", 1)
        server.close()
        assertTrue(socket.use { it.getInputStream().text() }.startsWith("HTTP/1.1 503"))
    }
}
