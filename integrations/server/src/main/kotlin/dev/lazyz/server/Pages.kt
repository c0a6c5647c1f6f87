package dev.lazyz.server

import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.server.render.PictureRequest
import dev.lazyz.server.render.Problem
import io.netty.handler.codec.http.HttpMethod

/** The paths that need no model. Each page is read with GET or HEAD. */
internal object Pages {
    /**
     * Returns the page of the port for pictures.
     *
     * @throws Problem if there is none at [path], or [method] is another
     */
    fun help(method: HttpMethod, path: String): Answer {
        if (path != "/") throw absent("there is nothing at $path; see /")
        requireGet(method, path)
        return Answer.text(help())
    }

    /**
     * Returns a page of the port for health and metrics.
     *
     * @throws Problem if there is none at [path], [method] is another, or the page says that [service] is not well
     */
    fun admin(service: Service, method: HttpMethod, path: String): Answer {
        val page: (Service) -> Answer = when (path) {
            "/health/live" -> ::live
            "/health/ready" -> ::ready
            "/metrics" -> ::metrics
            else -> throw absent("there is nothing at $path; see /health/live, /health/ready and /metrics")
        }
        requireGet(method, path)
        return page(service)
    }

    private fun absent(message: String) = Problem(Problem.NOT_FOUND, message)

    private fun requireGet(method: HttpMethod, path: String) {
        if (method == HttpMethod.GET || method == HttpMethod.HEAD) return
        throw Problem(Problem.METHOD_NOT_ALLOWED, "$path is read with GET", allowed = "GET, HEAD")
    }

    private fun live(service: Service): Answer {
        if (service.queue.isStuck) throw Problem(Problem.UNAVAILABLE, "threads hang, and nothing is rendered: restart")
        return Answer.text("alive\n")
    }

    private fun ready(service: Service): Answer {
        if (service.isDraining) throw service.draining()
        if (service.queue.isFull) throw Problem(Problem.UNAVAILABLE, "the queue is full", Problem.SOON)
        return Answer.text("ready\n")
    }

    private fun metrics(service: Service): Answer =
        Answer.text(service.metrics.text(), "text/plain; version=0.0.4; charset=utf-8")

    private fun help(): String = buildString {
        appendLine("Lazy Z renders 3D models to pictures.")
        appendLine()
        appendLine("  POST /render      a model in the body, or a ZIP archive with it and its files;")
        appendLine("                    the answer is a PNG file, or what aov and turntable say")
        appendLine()
        appendLine("Parameters, as in /render?size=512&view=iso:")
        appendLine()
        for ((name, own) in PictureRequest.OWN) appendLine("  $name=${own.first}\n      ${own.second}")
        for (parameter in PictureDoor.SERVICE.parameters) {
            appendLine("  ${parameter.name}=${parameter.values.form ?: "true"}\n      ${parameter.text(prefix = "")}")
        }
    }
}
