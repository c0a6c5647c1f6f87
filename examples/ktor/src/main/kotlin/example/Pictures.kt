package example

import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.tiled.TiledRenderer
import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.cio.CIO
import io.ktor.server.engine.embeddedServer
import io.ktor.server.request.receiveChannel
import io.ktor.server.response.header
import io.ktor.server.response.respondBytes
import io.ktor.server.response.respondText
import io.ktor.server.routing.post
import io.ktor.server.routing.routing
import io.ktor.utils.io.readRemaining
import java.time.Duration
import kotlin.time.Duration.Companion.seconds
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.TimeoutCancellationException
import kotlinx.coroutines.runInterruptible
import kotlinx.coroutines.sync.Semaphore
import kotlinx.coroutines.withTimeout
import kotlinx.io.readByteArray

private const val MOST_BYTES = 20L shl 20

/** What a model may ask for: all places together must fit into the heap. */
private val options = LoadOptions(
    LoadLimits().withDecodedBytes(64L shl 20).withTriangles(2_000_000).withTime(Duration.ofSeconds(5)),
)

/** The whole model, anti-aliased. Properties choose camera, light and background. */
private val settings = PictureSettings(512, 512)

/** The formats of models. Scene files are for people who trust their content. */
private val formats = SceneFormat.entries - SceneFormat.SCENE

/** What drawing may take: many translucent layers take much, although their file is small. */
private const val DRAWING_BYTES = 64L shl 20

private val mostTime = 10.seconds

/** Thread safe, like all renderers: one is enough for all requests. */
private val renderer = TiledRenderer()

/** Adds `POST /picture?format=obj`: a model in the body, a PNG file in the answer. */
fun Application.pictures(places: Semaphore = Semaphore(2 * Runtime.getRuntime().availableProcessors())) {
    routing {
        post("/picture") {
            val format: SceneFormat? = SceneFormat.ofFileName("upload.${call.parameters["format"]}")
            if (format !in formats) {
                val message = "format must be one of ${formats.joinToString { it.id }}"
                call.respondText(message, status = HttpStatusCode.UnsupportedMediaType)
            } else if (!places.tryAcquire()) {
                call.response.header("Retry-After", 1)
                call.respondText("too many requests", status = HttpStatusCode.TooManyRequests)
            } else {
                try {
                    call.picture(checkNotNull(format))
                } finally {
                    places.release()
                }
            }
        }
    }
}

private suspend fun ApplicationCall.picture(format: SceneFormat) {
    val body = receiveChannel().readRemaining(MOST_BYTES + 1).readByteArray()
    if (body.size > MOST_BYTES) return respondText("at most 20 MiB", status = HttpStatusCode.PayloadTooLarge)
    try {
        // Rendering occupies a thread, so it must not run on those of the server. A cancelled call interrupts it
        val png = withTimeout(mostTime) { runInterruptible(Dispatchers.Default) { png(body, format) } }
        respondBytes(png, ContentType.Image.PNG)
    } catch (_: TimeoutCancellationException) {
        respondText("the picture takes too long", status = HttpStatusCode.ServiceUnavailable)
    } catch (invalid: SceneFormatException) {
        // The message says where and what is wrong, or which limit was exceeded
        respondText(invalid.message.orEmpty(), status = HttpStatusCode.UnprocessableEntity)
    } catch (impossible: IllegalArgumentException) {
        // No camera can show the model, or drawing it takes too much memory
        respondText(impossible.message.orEmpty(), status = HttpStatusCode.UnprocessableEntity)
    }
}

private fun png(body: ByteArray, format: SceneFormat): ByteArray {
    val loaded = Scenes.load(body, format, "upload", options)
    val setUp = loaded.scene.setUpBytes
    requireMemory(setUp <= DRAWING_BYTES)
    val frame = settings.frame(loaded)
    val plan = frame.plan(RenderPlanner(DRAWING_BYTES), listOf(renderer), listOf(RenderPlan.Item("set-up", setUp)))
    requireMemory(plan.fits)
    return frame.render(plan.renderer).toPng()
}

private fun requireMemory(isEnough: Boolean) =
    require(isEnough) { "too many triangles or translucent layers to draw" }

fun main() {
    embeddedServer(CIO, port = 8080, host = "127.0.0.1") { pictures() }.start(wait = true)
}
