package dev.lazyz.server

import java.net.Socket
import java.util.concurrent.CyclicBarrier
import kotlin.concurrent.thread
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** The port for health and metrics. */
class AdminTest {
    private val config = ServerConfig(port = 0, adminPort = 0, renders = 1, queue = 1, log = {})

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun idleConnectionsDoNotKeepTheHealthFromBeingRead() {
        RenderServer(config.withConnections(3)).start().use { server ->
            val client = Client(server)
            val idle = List(3) { client.open("") }
            client.await("lazyz_connections", 3)
            assertTrue("HTTP/1.1 503 " in client.open("").use { it.getInputStream().text() })
            assertEquals("alive\n", client.get("/health/live").body())
            assertEquals("ready\n", client.get("/health/ready").body())
            assertTrue("lazyz_connections 3\n" in client.get("/metrics").body())
            idle.forEach(Socket::close)
        }
    }

    /** A counter that two threads make at the same time is one. */
    @Test
    fun noCountIsLost() {
        val metrics = Metrics()
        val counters = 2_000
        val start = CyclicBarrier(2)
        val threads = List(2) {
            thread {
                for (i in 0 until counters) {
                    start.await()
                    metrics.counter("requests", "Requests.", "status=\"$i\"").add()
                }
            }
        }
        threads.forEach(Thread::join)
        val lost = metrics.text().lines().filter { it.startsWith("requests{") && !it.endsWith(" 2") }
        assertEquals(emptyList<String>(), lost)
    }

    @Test
    fun eachConnectionHasOneAnswer() = RenderServer(config).start().use { server ->
        fun answer(text: String) = Socket("127.0.0.1", server.adminPort).use { socket ->
            socket.soTimeout = 600_000
            socket.send(text)
            socket.getInputStream().text()
        }
        val live = "GET /health/live HTTP/1.1\r\nHost: x\r\n\r\n"
        assertEquals(listOf(200), Client.statuses(answer(live + live)))
        val post = answer("POST /health/live HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n")
        assertTrue(post.startsWith("HTTP/1.1 405 ") && "allow: GET, HEAD" in post, post)
        assertTrue(answer("GET /render HTTP/1.1\r\nHost: x\r\n\r\n").startsWith("HTTP/1.1 404 "))
        assertTrue(answer("nonsense\r\n\r\n").startsWith("HTTP/1.1 400 "))
        assertTrue(answer("HEAD /metrics HTTP/1.1\r\nHost: x\r\n\r\n").endsWith("\r\n\r\n"))
        assertEquals(0.0, Client(server).metric("lazyz_connections"))
    }

    /** A process that ends its work is healthy, and takes no more. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whileTheServerIsClosedItIsAliveAndNotReady() {
        val server = RenderServer(config).start()
        val client = Client(server)
        client.open("POST ${Client.LONG} HTTP/1.1\r\nHost: x\r\nContent-Length: ${Client.MODEL.size}\r\n\r\n").use {
            it.send(Client.MODEL.decodeToString())
            client.await("lazyz_renders_running", 1)
            val closing = Thread { server.close() }.apply { start() }
            Client.await({ "not closing" }) { closing.state == Thread.State.TIMED_WAITING }
            assertEquals(200, client.get("/health/live").statusCode())
            val ready = client.get("/health/ready")
            assertEquals(503, ready.statusCode())
            assertTrue("the server is being closed" in ready.body(), ready.body())
            it.close()
            closing.join()
        }
    }

    @Test
    fun withoutAPortThereIsNone() {
        RenderServer(config.withAdminPort(null)).start().use { server ->
            assertThrows(IllegalStateException::class.java) { server.adminPort }
            val text = Client(server).open("GET /health/live HTTP/1.0\r\n\r\n").use { it.getInputStream().text() }
            assertTrue(text.startsWith("HTTP/1.1 404 "), text)
        }
    }
}
