package dev.lazyz.scenes.gltf.draco

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import java.util.Base64
import java.util.concurrent.CountDownLatch
import kotlin.math.abs
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class DracoGeometryTest {
    /** What Draco 1.5 made of a strip of squares with a colour at each vertex: by edges, and one after the other. */
    private val compressed = Base64.getDecoder().decode(
        "RFJBQ08CAgEBAAAACAYBBgAAA++6Af8BEf8CVUAC/wAAAAAAAQAJAwAAAgECAgQAAQEBAQEACwMBKB8BGAMAvq+rqgqAqqkCAICq" +
            "AAAAAAAAAAD/AwAAAAAAAAAAAAAAAAAAAABAQAoBAQEBA7IBASj7ARD/AQI7AQI7AQI7AQIJABZK7exO/2+AAAAAAPgAAAA=",
    )

    private val sequential = Base64.getDecoder().decode(
        "RFJBQ08CAgEAAAAGCAEAAgEBAgMCBAMDBAUEBgUFBgcBAgAJAwAAAgIEAAECAQABAQECqwVVJf////////////+fAQitEgYdg9be" +
            "qFgAAAAA/wMAAAABAQEDQQECOwECOwECOwECOwE4BgB+sUBwgAAAAAD4AAAAAAAAAAAAAAAAAAAAAABAQAo=",
    )

    private fun decode(bytes: ByteArray) = DracoGeometry.decode(bytes, null) {}

    @Test
    fun verticesTrianglesAndAttributesComeBack() {
        for (bytes in listOf(compressed, sequential)) assertStrip(decode(bytes))
    }

    private fun assertStrip(geometry: DracoGeometry) {
        assertEquals(8, geometry.vertexCount)
        assertEquals(18, geometry.triangles.size)
        val positions = geometry.floats(0, false)!!
        val colours = geometry.floats(1, true)!!
        for (vertex in 0 until 8) {
            // The order is the encoder's; the position tells which it was
            val x = Math.round(positions[3 * vertex])
            val y = Math.round(positions[3 * vertex + 1])
            assertTrue(abs(positions[3 * vertex] - x) < 0.01f)
            for (i in 0 until 4) assertEquals((2 * x + y) * 4 * 8 + i * 8, Math.round(colours[4 * vertex + i] * 255))
        }
        assertNull(geometry.floats(7, false))
    }

    @Test
    fun sizesAreAskedForBeforeTheyAreDecoded() {
        val refusal = IllegalStateException()
        var asked = 0L
        assertThrows(IllegalStateException::class.java) {
            DracoGeometry.decode(compressed, null) {
                asked = it
                throw refusal
            }
        }
        assertTrue(asked in 1000..10000, "$asked")
    }

    @Test
    fun headersThatAreNoneAreRefused() {
        fun message(change: (ByteArray) -> Unit) = assertThrows(DracoException::class.java) {
            decode(compressed.copyOf().also(change))
        }.message!!
        assertTrue("is not Draco's" in message { it[0] = 0 })
        assertTrue("version 3.2, not 2.2" in message { it[5] = 3 })
        assertTrue("is no mesh" in message { it[7] = 0 })
        assertTrue("beyond 32 bits" in message { it.fill(-1, 12, 17) })
        for (length in 0 until compressed.size) {
            assertThrows(DracoException::class.java, { decode(compressed.copyOf(length)) }, "cut at byte $length")
        }
    }

    @Test
    fun stepsThatDoNotEndAreGivenUp() {
        val steps = EndlessSteps(1)
        assertEquals(5, steps.run(600_000) { 5 })
        assertThrows(IllegalStateException::class.java) { steps.run(600_000) { error("as it is") } }
        val message = { assertThrows(DracoException::class.java) { steps.run(20) { Thread.sleep(60_000) } }.message!! }
        assertTrue("more than 20 ms" in message())
        assertTrue("still busy" in message())
    }

    @Test
    fun interruptedStepsAreAbandonedToo() {
        val steps = EndlessSteps(1)
        Thread.currentThread().interrupt()
        assertThrows(DracoException::class.java) { steps.run(60_000) { Thread.sleep(60_000) } }
        assertTrue(Thread.interrupted())
        val message = assertThrows(DracoException::class.java) { steps.run(1000) { } }.message!!
        assertTrue("still busy" in message, message)
    }

    @Test
    fun stepsThatEndAfterAllMakeRoomForOthers() {
        val steps = EndlessSteps(1)
        val isOver = CountDownLatch(1)
        var worker = Thread.currentThread()
        assertThrows(DracoException::class.java) {
            steps.run(20) {
                worker = Thread.currentThread()
                isOver.await()
            }
        }
        isOver.countDown()
        worker.join()
        assertEquals(5, steps.run(600_000) { 5 })
    }

    private fun file(bytes: ByteArray, ids: String = """"POSITION":0,"COLOR_0":1"""): String = """{
        "asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"],
        "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":2,
            "extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{$ids}}}}]}],
        "buffers":[{"byteLength":${bytes.size},"uri":"data:;base64,${Base64.getEncoder().encodeToString(bytes)}"}],
        "bufferViews":[{"buffer":0,"byteLength":${bytes.size}}],
        "accessors":[{"componentType":5126,"count":8,"type":"VEC3"},
            {"componentType":5121,"normalized":true,"count":8,"type":"VEC4"},
            {"componentType":5123,"count":18,"type":"SCALAR"}]}"""

    @Test
    fun primitivesAreDecoded() {
        val source = TestSources.of(file(compressed))
        val mesh = GltfParser.parse(source).meshes.single()
        assertEquals(emptyList<String>(), source.warnings)
        assertEquals(8, mesh.corners().map { corner -> corner.map { Math.round(it) } }.distinct().size)
        assertEquals(32, mesh.colors!!.size)
        for (triangle in mesh.corners().chunked(3)) {
            val (a, b, c) = triangle
            assertTrue((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0f, "counter-clockwise")
        }
    }

    @Test
    fun errorsNameTheExtension() {
        val place = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression"
        val damaged = TestSources.error(GltfParser, TestSources.of(file(compressed.copyOf(40))))
        assertEquals(place, damaged.location)
        val missing = TestSources.error(GltfParser, TestSources.of(file(compressed, """"POSITION":5""")))
        assertEquals("$place.attributes.POSITION", missing.location)
        val swapped = TestSources.error(GltfParser, TestSources.of(file(compressed, """"POSITION":1""")))
        assertTrue("no attribute 1 of this kind" in swapped.message!!, swapped.message)
        val loading = Loading(LoadOptions(LoadLimits(decodedBytes = 900)))
        val limited = Source(file(compressed).toByteArray(), "test", null, loading)
        assertTrue("--max-decoded" in TestSources.error(GltfParser, limited).message!!)
    }

    @Test
    fun damageIsReportedAndNothingElse() {
        for (at in 11 until 40) {
            val bad = compressed.copyOf().also { it[at] = (it[at].toInt() xor 1).toByte() }
            try {
                GltfParser.parse(TestSources.of(file(bad)))
            } catch (_: SceneFormatException) {
                // The one exception that is allowed
            }
        }
    }
}
