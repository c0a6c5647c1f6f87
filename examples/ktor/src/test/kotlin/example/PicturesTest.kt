package example

import dev.lazyz.scenes.PictureSettings
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.Scenes
import dev.lazyz.strategies.zbuffer.ZBuffer
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsBytes
import io.ktor.client.statement.bodyAsText
import io.ktor.server.testing.testApplication
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
        val local = PictureSettings(512, 512).frame(Scenes.load(model, SceneFormat.OBJ)).render(ZBuffer())
        assertArrayEquals(local.argb, picture.getRGB(0, 0, 512, 512, null, 0, 512))
    }

    @Test
    fun badModelsAreRefused() = testApplication {
        application { pictures() }
        val answer = client.post("/picture?format=stl") { setBody(model) }
        assertEquals(422, answer.status.value)
        assertTrue("upload" in answer.bodyAsText())
        assertEquals(415, client.post("/picture?format=doc") { setBody(model) }.status.value)
        val large = ByteArray((20 shl 20) + 1)
        assertEquals(413, client.post("/picture?format=obj") { setBody(large) }.status.value)
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
