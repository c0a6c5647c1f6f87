package dev.lazyz.server

import java.net.Socket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.TimeUnit
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** A server in a process with a small heap, which ends when its memory is used up. */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class MemoryTest {
    private val process = ProcessBuilder(
        "${Path.of(System.getProperty("java.home"), "bin", "java")}", "-Xmx160m", "-XX:+ExitOnOutOfMemoryError",
        "-cp", System.getProperty("java.class.path"), "dev.lazyz.server.MainKt",
        "--port", "0", "--admin-port", "0", "--renders", "2", "--memory", "112m", "--render-time", "6000",
    ).redirectError(ProcessBuilder.Redirect.DISCARD).start()
    private val output = process.inputStream.bufferedReader()
    private val address = output.readLine().substringAfter("listening at ")
    private val admin = output.readLine().substringAfter("health and metrics at ")
    private val reader = Thread { output.forEachLine { } }.apply { isDaemon = true }.also { it.start() }
    private val http = HttpClient.newHttpClient()

    @AfterEach
    fun end() {
        process.destroyForcibly().waitFor(300, TimeUnit.SECONDS)
        reader.join()
    }

    private fun request(body: ByteArray, query: Any = 512): HttpRequest {
        val address = URI("${address}render?size=$query")
        return HttpRequest.newBuilder(address).timeout(Duration.ofMinutes(10))
            .POST(HttpRequest.BodyPublishers.ofByteArray(body)).build()
    }

    private fun post(body: ByteArray, query: Any = 512): HttpResponse<String> =
        http.send(request(body, query), HttpResponse.BodyHandlers.ofString(Charsets.ISO_8859_1))

    @Test
    fun translucentLayersThatNeedTooMuchAreRefused() {
        val answer = post(layers(50_000, "BLEND"))
        assertEquals(413, answer.statusCode(), answer.body())
        assertTrue("fewer triangles or translucent layers" in answer.body()) { answer.body() }
        assertEquals(200, post(layers(20, "BLEND"), 64).statusCode())
        assertEquals(200, post(Client.MODEL).statusCode())
    }

    @Test
    fun manyRequestsOfManyLayersDoNotExhaustTheMemory() {
        val model = layers(10_000, "BLEND")
        val head = "POST /render?size=512 HTTP/1.1\r\nHost: x\r\nContent-Length: ${model.size}\r\n\r\n"
        val clients = List(4) {
            Socket("127.0.0.1", URI(address).port).apply { getOutputStream().write(head.toByteArray() + model) }
        }
        Client.await({ "the renderings do not begin" }) { "lazyz_renders_running 2\n" in metrics() }

        // Their layers take minutes, and soon all of the memory that they get
        val start = processorTime()
        Client.await({ "the renderings do not go on" }) { processorTime() > start.plusSeconds(3) }
        clients.forEach(Socket::close)
        assertEquals(200, post(Client.MODEL).statusCode())
        Client.await({ metrics() }) { "lazyz_requests_total{status=\"499\"} 4\n" in metrics() }
    }

    private fun processorTime(): Duration = process.toHandle().info().totalCpuDuration().get()

    private fun metrics(): String =
        http.send(HttpRequest.newBuilder(URI("${admin}metrics")).build(), HttpResponse.BodyHandlers.ofString()).body()

    /** Each reaches many tiles, and none hides another. */
    @Test
    fun largeTrianglesThatNeedTooMuchAreRefused() {
        val answer = post(layers(300_000, "OPAQUE"))
        assertEquals(413, answer.statusCode(), answer.body())
        assertEquals(200, post(layers(100, "OPAQUE"), 64).statusCode())
    }

    /** Every triangle has edges, and is cut. The process would end if that took more than was planned. */
    @Test
    fun edgesAndCutsOfManyTrianglesArePlanned() {
        // How long hidden lines take grows with the square of the triangles
        val most = mapOf("wireframe=true" to 15_000, "cut=x=50%25" to 15_000, "edges=true&hidden-lines=solid" to 3_000)
        for ((lines, many) in most) {
            for (triangles in listOf(many / 3, many, 300_000)) {
                val answer = post(layers(triangles, "OPAQUE"), "64&aa=1&$lines")
                val expected = if (triangles < many) listOf(200) else listOf(200, 413)
                assertTrue(answer.statusCode() in expected) { "$lines $triangles: $answer ${answer.body()}" }
            }
        }
        assertEquals(200, post(Client.MODEL).statusCode())
    }

    /** Returns a GLB file of slivers, or, if they are translucent, of triangles that coincide. */
    private fun layers(triangles: Int, mode: String): ByteArray {
        val steps = if (mode == "BLEND") 1 else STEPS
        val data = ByteBuffer.allocate(24 * (steps + 1) + 12 * triangles).order(ByteOrder.LITTLE_ENDIAN)
        for (i in 0..steps) {
            for (side in listOf(-1f, 1f)) data.putFloat(side).putFloat(2f * i / steps - 1).putFloat(side * i / steps)
        }
        for (i in 0 until triangles) {
            val left = i % steps
            val right = i / steps % steps
            data.putInt(2 * left).putInt(2 * right + 1).putInt(2 * right + 3)
        }
        val json = """{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
            "materials":[{"alphaMode":"$mode","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.2,0.01]}}],
            "buffers":[{"byteLength":${data.capacity()}}],
            "bufferViews":[{"buffer":0,"byteLength":${24 * (steps + 1)}},
                {"buffer":0,"byteOffset":${24 * (steps + 1)},"byteLength":${12 * triangles}}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":${2 * (steps + 1)},"type":"VEC3",
                "min":[-1,-1,-1],"max":[1,1,1]},
                {"bufferView":1,"componentType":5125,"count":${3 * triangles},"type":"SCALAR"}]}""".toByteArray()
        val padded = json.copyOf((json.size + 3) / 4 * 4).also { it.fill(' '.code.toByte(), json.size) }
        return ByteBuffer.allocate(28 + padded.size + data.capacity()).order(ByteOrder.LITTLE_ENDIAN)
            .put("glTF".toByteArray()).putInt(2).putInt(28 + padded.size + data.capacity())
            .putInt(padded.size).put("JSON".toByteArray()).put(padded)
            .putInt(data.capacity()).put("BIN\u0000".toByteArray()).put(data.array()).array()
    }

    private companion object {
        /** Vertices along a side. */
        const val STEPS = 600
    }
}
