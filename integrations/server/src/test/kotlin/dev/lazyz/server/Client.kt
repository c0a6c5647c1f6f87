package dev.lazyz.server

import java.io.InputStream
import java.net.Socket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.time.Duration

/** Requests to a server on this machine. */
internal class Client(private val server: RenderServer) {
    private val http = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build()

    fun get(path: String): HttpResponse<String> =
        http.send(request(path).GET().build(), HttpResponse.BodyHandlers.ofString())

    fun post(path: String, body: ByteArray, vararg headers: String): HttpResponse<ByteArray> =
        http.send(posting(path, body, *headers), HttpResponse.BodyHandlers.ofByteArray())

    fun posting(path: String, body: ByteArray, vararg headers: String): HttpRequest {
        val request = request(path).POST(HttpRequest.BodyPublishers.ofByteArray(body))
        if (headers.isNotEmpty()) request.headers(*headers)
        return request.build()
    }

    private fun request(path: String) =
        HttpRequest.newBuilder(URI("http://127.0.0.1:${port(path)}$path")).timeout(Duration.ofMinutes(10))

    private fun port(path: String) =
        if (path.startsWith("/health/") || path == "/metrics") server.adminPort else server.port

    /** Opens a connection, and sends [text]. Reading fails after ten minutes. */
    fun open(text: String): Socket = Socket("127.0.0.1", server.port).apply {
        soTimeout = 600_000
        send(text)
    }

    /** The value of a number of the server. */
    fun metric(sample: String): Double =
        server.metrics().lines().firstOrNull { it.startsWith("$sample ") }?.substringAfter(' ')?.toDouble() ?: 0.0

    /** Waits until a number of the server has a value. */
    fun await(sample: String, value: Int) = await({ "$sample is ${metric(sample)}, not $value" }) {
        metric(sample) == value.toDouble()
    }

    companion object {
        /** A triangle. */
        val MODEL = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".toByteArray()

        /** A picture that takes much longer than a test. */
        const val LONG = "/render?size=4096&aa=8"

        /** The statuses of the answers in [text]. */
        fun statuses(text: String): List<Int> =
            Regex("HTTP/1.1 (\\d+)").findAll(text).map { it.groupValues[1].toInt() }.toList()

        /** Waits until [condition] holds. */
        fun await(message: () -> String, condition: () -> Boolean) {
            val end = System.nanoTime() + 300_000_000_000
            while (!condition()) {
                check(System.nanoTime() < end, message)
                Thread.sleep(2)
            }
        }
    }
}

internal fun Socket.send(text: String) {
    getOutputStream().write(text.toByteArray(Charsets.ISO_8859_1))
    getOutputStream().flush()
}

/** Reads to the end, or to a reset. */
internal fun InputStream.text(): String {
    val text = StringBuilder()
    try {
        while (true) {
            val byte = read()
            if (byte < 0) break
            text.append(byte.toChar())
        }
    } catch (_: java.net.SocketException) {
        text.append("(reset)")
    }
    return text.toString()
}
