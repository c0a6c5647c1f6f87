package dev.lazyz.server

import dev.lazyz.server.render.Parameter
import dev.lazyz.server.render.Problem

/** The paths of the server that need no model. */
internal class Pages(private val service: Service) {
    /**
     * Returns the answer to GET or HEAD, or null if there is no such page.
     *
     * @throws Problem if the page says that the server is ready, and it is not
     */
    fun answer(path: String): Answer? = when (path) {
        "/" -> Answer.text(help())
        "/health/live" -> Answer.text("alive\n")
        "/health/ready" -> ready()
        "/metrics" -> Answer.text(service.metrics.text(), "text/plain; version=0.0.4; charset=utf-8")
        else -> null
    }

    private fun ready(): Answer {
        if (service.isDraining) throw service.draining()
        if (service.queue.isFull) throw Problem(Problem.UNAVAILABLE, "the queue is full", Problem.SOON)
        return Answer.text("ready\n")
    }

    private fun help(): String = buildString {
        appendLine("Lazy Z renders 3D models to pictures.")
        appendLine()
        appendLine("  POST /render      a model in the body; the answer is a PNG file")
        appendLine("  GET /health/live  GET /health/ready  GET /metrics")
        appendLine()
        appendLine("Parameters, as in /render?size=512&view=iso:")
        appendLine()
        for (parameter in Parameter.entries) appendLine("  ${parameter.id}=${parameter.form}\n      ${parameter.help}")
    }
}
