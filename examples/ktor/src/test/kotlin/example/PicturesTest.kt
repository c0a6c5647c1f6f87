package example

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsBytes
import io.ktor.client.statement.bodyAsText
import io.ktor.server.testing.testApplication
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64
import javax.imageio.ImageIO
import kotlinx.coroutines.sync.Semaphore
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PicturesTest {
    private val model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".toByteArray()

    @Test
    fun thePictureHasTheBitsOfALocalRendering() = testApplication {
        application { pictures() }
        val answer = client.post("/picture?format=obj") { setBody(model) }
        assertEquals(200, answer.status.value)
        val picture = ImageIO.read(answer.bodyAsBytes().inputStream())
        val local = PictureSettings(512, 512).frame(Scenes.load(model, SceneFormat.OBJ)).render(ZBufferRenderer())
        assertArrayEquals(local.argb, picture.getRGB(0, 0, 512, 512, null, 0, 512))
    }

    @Test
    fun badModelsAreRefused() = testApplication {
        application { pictures() }
        val answer = client.post("/picture?format=stl") { setBody(model) }
        assertEquals(422, answer.status.value)
        assertTrue("upload" in answer.bodyAsText())
        for (format in listOf("doc", "json")) {
            assertEquals(415, client.post("/picture?format=$format") { setBody(model) }.status.value)
        }
        val large = ByteArray((20 shl 20) + 1)
        assertEquals(413, client.post("/picture?format=obj") { setBody(large) }.status.value)
    }

    /** Triangles that cover the picture, all in the same place. */
    private fun layers(triangles: Int): ByteArray {
        val data = ByteBuffer.allocate(36 + 6 * triangles).order(ByteOrder.LITTLE_ENDIAN)
        for (value in listOf(-9, -9, 0, 9, -9, 0, 0, 9, 0)) data.putFloat(value.toFloat())
        for (i in 0 until 3 * triangles) data.putShort((i % 3).toShort())
        val content = Base64.getEncoder().encodeToString(data.array())
        return """
            {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
             "materials": [{"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 0.01]}}],
             "buffers": [{"byteLength": ${data.capacity()}, "uri": "data:application/octet-stream;base64,$content"}],
             "bufferViews": [{"buffer": 0, "byteLength": 36},
                             {"buffer": 0, "byteOffset": 36, "byteLength": ${6 * triangles}}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                            "min": [-9, -9, 0], "max": [9, 9, 0]},
                           {"bufferView": 1, "componentType": 5123, "count": ${3 * triangles}, "type": "SCALAR"}]}
        """.toByteArray()
    }

    @Test
    fun translucentLayersHaveLimitsOfMemoryAndTime() = testApplication {
        application { pictures() }
        for ((triangles, status) in listOf(50_000 to 422, 2_000 to 503, 3 to 200)) {
            val answer = client.post("/picture?format=gltf") { setBody(layers(triangles)) }
            assertEquals(status, answer.status.value, answer.bodyAsText().take(200))
        }
    }

    @Test
    fun withoutAPlaceARequestIsRefused() = testApplication {
        val places = Semaphore(1, acquiredPermits = 1)
        application { pictures(places) }
        assertEquals(429, client.post("/picture?format=obj") { setBody(model) }.status.value)
        places.release()
        repeat(2) { assertEquals(200, client.post("/picture?format=obj") { setBody(model) }.status.value) }
    }
}
