package dev.lazyz.server

import dev.lazyz.server.Client.Companion.statuses
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource

/** Requests as RFC 9110 and RFC 9112 allow and forbid them. */
class HttpTest {
    private val alive = "GET / HTTP/1.1\r\nHost: x\r\n\r\n"
    private val last = "GET /none HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"

    /** The statuses of the answers to [requests], until the server closes the connection. */
    private fun answers(requests: String): List<Int> =
        client.open(requests).use { statuses(it.getInputStream().text()) }

    @ParameterizedTest
    @CsvSource(
        "http://host/, 200",
        "HTTP://host:80/?x=1, 200",
        "https://[::1]:8/, 200",
        "http://host, 200",
        "http://host?x=1, 200",
        "http://host/none, 404",
        "ftp://host/, 404",
        "http:/, 404",
    )
    fun theTargetCanHaveTheAbsoluteForm(target: String, status: Int) {
        assertEquals(listOf(status, 404), answers("GET $target HTTP/1.1\r\nHost: x\r\n\r\n$last"))
    }

    @Test
    fun aPictureCanBeRequestedWithTheAbsoluteForm() {
        val head = "POST http://host/render?size=8 HTTP/1.1\r\nHost: host\r\nConnection: close\r\n"
        val model = Client.MODEL.decodeToString()
        assertEquals(listOf(200), answers("${head}Content-Length: ${model.length}\r\n\r\n$model"))
        val get = client.open("GET http://host/render HTTP/1.1\r\nHost: host\r\nConnection: close\r\n\r\n")
        val text = get.use { it.getInputStream().text() }
        assertTrue("allow: POST" in text) { text }
    }

    @ParameterizedTest
    @ValueSource(strings = ["", "Host: x\r\nHost: x\r\n", "Host: a b\r\n", "Host: a/b\r\n", "Host: x:port\r\n"])
    fun aRequestWithoutOneValidHostIsRefused(hosts: String) {
        assertEquals(listOf(400), answers("GET / HTTP/1.1\r\n$hosts\r\n$last"))
    }

    @ParameterizedTest
    @ValueSource(strings = ["", "a.example:80", "[::1]:8080", "127.0.0.1", "a_b:"])
    fun aHostCanBeANameOrANumberOrEmpty(host: String) {
        assertEquals(listOf(200, 404), answers("GET / HTTP/1.1\r\nHost: $host\r\n\r\n$last"))
    }

    @ParameterizedTest
    @CsvSource("HTTP/1.0, 200", "HTTP/1.9, 200", "HTTP/2.0, 505", "HTTP/0.9, 505", "HTTP/3.1, 505", "ICY/1.1, 400")
    fun theMajorVersionIsOne(version: String, status: Int) {
        assertEquals(listOf(status), answers("GET / $version\r\nHost: x\r\nConnection: close\r\n\r\n"))
        if (status != 200) assertEquals(listOf(status), answers("GET / $version\r\nHost: x\r\n\r\n"))
    }

    @Test
    fun version10NeedsNoHost() = assertEquals(listOf(200), answers("GET / HTTP/1.0\r\n\r\n"))

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = ["gzip, chunked|501", "gzip, Chunked|501", "gzip|400", "chunked, gzip|400", "chunked, chunked|400"],
    )
    fun otherTransferCodingsAreRefused(codings: String, status: Int) {
        for (start in listOf("POST /render?size=8", "GET /")) {
            val head = "$start HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: $codings\r\n\r\n"
            assertEquals(listOf(status), answers("${head}1\r\nv\r\n0\r\n\r\n$alive"))
        }
    }

    /** A proxy may read another end of such a request, so what follows is not taken for the next one. */
    @Test
    fun aRequestWithTwoLengthsIsTheLast() {
        val size = Client.MODEL.size.toString(16)
        val body = "$size\r\n${Client.MODEL.decodeToString()}\r\n0\r\n\r\n"
        val lengths = listOf("Transfer-Encoding: chunked", "Content-Length: 5")
        for (start in listOf("POST /render?size=8", "GET /")) {
            for (both in listOf(lengths, lengths.reversed())) {
                val head = "$start HTTP/1.1\r\nHost: x\r\n${both.joinToString("\r\n")}\r\n\r\n"
                assertEquals(1, answers("$head$body$alive").size, "$both")
            }
        }
    }

    @Test
    fun aChunkedModelIsRead() {
        val size = Client.MODEL.size.toString(16)
        val body = "$size\r\n${Client.MODEL.decodeToString()}\r\n0\r\n\r\n"
        val head = "POST /render?size=8 HTTP/1.1\r\nHost: x\r\nConnection: close\r\nTransfer-Encoding: CHUNKED\r\n\r\n"
        assertEquals(listOf(200), answers(head + body))
    }

    @Test
    fun endsOfLinesCountAsHeaders() {
        val most = 8192
        val host = "Host: x\r\n"
        val line = "a: \r\n"
        val fitting = (most - host.length) / line.length
        val start = "GET / HTTP/1.1\r\n$host"
        assertEquals(listOf(200, 404), answers(start + line.repeat(fitting) + "\r\n$last"))
        assertEquals(listOf(431), answers(start + line.repeat(fitting + 1) + "\r\n$last"))
    }

    /** A client that asks before it sends a body, and gets another answer, may go on with its next request. */
    @ParameterizedTest
    @ValueSource(strings = ["GET /render", "GET /", "HEAD /", "POST /metrics", "GET /none"])
    fun aBodyThatIsNotReadEndsTheConnection(start: String) {
        val head = "$start HTTP/1.1\r\nHost: x\r\nExpect: 100-continue\r\nContent-Length: ${alive.length}\r\n\r\n"
        client.open(head).use { socket ->
            val answer = socket.getInputStream().text()
            assertEquals(1, statuses(answer).size)
            assertTrue("connection: close" in answer) { answer }
        }
    }

    @Test
    fun anEmptyBodyDoesNotEndTheConnection() {
        val head = "GET / HTTP/1.1\r\nHost: x\r\nContent-Length: 0\r\n\r\n"
        assertEquals(listOf(200, 404), answers(head + last))
    }

    private companion object {
        val server = RenderServer(ServerConfig(port = 0, log = {})).start()
        val client = Client(server)

        @AfterAll
        @JvmStatic
        fun close() = server.close()
    }
}
