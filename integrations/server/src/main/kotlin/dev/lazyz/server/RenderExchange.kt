package dev.lazyz.server

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.server.render.MediaTypes
import dev.lazyz.server.render.PictureRequest
import dev.lazyz.server.render.Problem
import dev.lazyz.server.render.QueuedJob
import dev.lazyz.server.render.RenderedPicture
import dev.lazyz.server.render.Upload
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpMethod
import io.netty.handler.codec.http.HttpRequest
import io.netty.handler.codec.http.HttpUtil

/**
 * A request for a picture, from its headers to its job. Used by the event loop of its connection; the job runs on a
 * thread of the queue.
 *
 * @throws Problem if the headers already show that there will be no picture
 */
internal class RenderExchange(private val service: Service, request: HttpRequest, query: Map<String, List<String>>) {
    private val wish: PictureRequest
    private val format: SceneFormat?

    /** The bytes so far. */
    val upload: Upload

    /** The pictures that the client has. */
    val known: String? = request.headers().getAll(HttpHeaderNames.IF_NONE_MATCH).joinToString(",").ifEmpty { null }

    init {
        if (request.method() != HttpMethod.POST) {
            throw Problem(Problem.METHOD_NOT_ALLOWED, "send the model to /render with POST", allowed = "POST")
        }
        wish = PictureRequest.of(query, service.config.pixels)
        val coding = request.headers().get(HttpHeaderNames.CONTENT_ENCODING, "identity")
        if (!coding.equals("identity", ignoreCase = true)) {
            throw Problem(Problem.UNSUPPORTED, "content coding '$coding' is not supported; send the model as it is")
        }
        format = wish.format ?: MediaTypes.format(request.headers().get(HttpHeaderNames.CONTENT_TYPE))
        requireMemory(service.maker.pictureNeed(wish), "a smaller size, or aa")
        if (service.isDraining) throw service.draining()
        if (service.queue.isFull) throw tooMany()
        val length = HttpUtil.getContentLength(request, UNKNOWN)
        upload = Upload(length.takeIf { it >= 0 }, service.mostBody, service.uploads)
    }

    /**
     * Adds a job for the complete upload to the queue. The job releases the memory of the upload when no thread is at
     * work on it any more.
     *
     * @param started is called on a thread of the queue
     * @param ended is called on some thread of the queue, or the calling one of a cancellation
     * @throws Problem if there is no place or no memory for it
     */
    fun enqueue(started: () -> Unit, ended: (QueuedJob.Outcome) -> Unit): QueuedJob {
        service.received.add(upload.size.toLong())
        val need = service.maker.pictureNeed(wish) + service.maker.modelNeed(format, upload.start(), upload.size)
        requireMemory(need, "a smaller model or picture")
        val work = { job: QueuedJob ->
            timed { service.maker.picture(upload.joined(), format, wish, job.need) { service.queue.grow(job, it) } }
        }
        val job = QueuedJob(need, work, started, upload::release, ended)
        if (!service.queue.offer(job)) throw tooMany()
        return job
    }

    private fun timed(work: () -> RenderedPicture): RenderedPicture {
        val start = System.nanoTime()
        try {
            return work()
        } finally {
            service.renderTime.add(System.nanoTime() - start)
        }
    }

    private fun requireMemory(need: Long, remedy: String) {
        val most = service.queue.memory
        if (need > most) {
            throw Problem(Problem.TOO_LARGE, "this needs $need bytes of memory, and there are $most; choose $remedy")
        }
    }

    private fun tooMany() = Problem(Problem.TOO_MANY, "too many requests wait; try again later", Problem.SOON)

    private companion object {
        const val UNKNOWN = -1L
    }
}
