package dev.lazyz.cli

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.zbuffer.ZBuffer
import java.net.URLClassLoader
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/** A renderer that fails after half the rows in a way that its [id] names. */
open class FailingRenderer(override val id: String, private val failure: () -> Throwable) : Renderer {
    override val summary: String get() = "fails half way"

    override fun render(frame: Frame, sink: RowSink): Counters = ZBuffer().render(frame) { y, argb, depth, primitive ->
        if (y == frame.height / 2) throw failure()
        sink.row(y, argb, depth, primitive)
    }
}

class BuggyRenderer : FailingRenderer("buggy", { IllegalStateException("the cursor ran away") })

class GreedyRenderer : FailingRenderer("greedy", { OutOfMemoryError("Java heap space") })

class SecondZBuffer : FailingRenderer("zbuffer", { IllegalStateException() })

class UnbornRenderer : FailingRenderer("unborn", { IllegalStateException() }) {
    init {
        error("cannot be made")
    }
}

/** Runs [block] with the classes called [names] offered as renderers on the class path, by way of [folder]. */
internal fun withRenderers(folder: Path, vararg names: String, block: () -> Unit) {
    val services = folder.resolve("services/META-INF/services").createDirectories()
    services.resolve("dev.lazyz.Renderer").writeText(names.joinToString("\n"))
    val thread = Thread.currentThread()
    val before = thread.contextClassLoader
    URLClassLoader(arrayOf(folder.resolve("services").toUri().toURL()), before).use { loader ->
        thread.contextClassLoader = loader
        try {
            block()
        } finally {
            thread.contextClassLoader = before
        }
    }
}
