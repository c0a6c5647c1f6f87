package dev.lazyz.cli

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.net.URLClassLoader
import java.nio.file.Path
import java.util.jar.Attributes
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import java.util.jar.Manifest
import kotlin.io.path.createDirectories
import kotlin.io.path.outputStream
import kotlin.io.path.writeText
import kotlin.system.exitProcess

/** A renderer that fails after half of the rows. Its [id] names the kind of failure. */
open class FailingRenderer(override val id: String, private val failure: () -> Throwable) : Renderer {
    override val summary: String get() = "fails half way"

    override fun render(frame: Frame, sink: RowSink): Counters = ZBufferRenderer().render(frame) {
            y,
            argb,
            depth,
            primitive
        ->
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

/** Fails when it is asked for its capabilities, before any rule runs. */
class SpeechlessRenderer : FailingRenderer("speechless", { IllegalStateException() }) {
    override val capabilities: Set<Capability> get() = error("what can I do?")
}

/** Prints, and exits with code 0 if the frame has more than two primitives. */
class ExitingRenderer : Renderer {
    override val id: String get() = "exiting"

    override val summary: String get() = "exits"

    override fun render(frame: Frame, sink: RowSink): Counters {
        println("going on")
        if (frame.primitives.size > 2) exitProcess(0)
        return ZBufferRenderer().render(frame, sink)
    }
}

/** Exits before the suite can use it. */
class StillbornRenderer : FailingRenderer("stillborn", { IllegalStateException() }) {
    init {
        exitProcess(0)
    }
}

/** Never ends, but runs a little now and then. */
class DozingRenderer : FailingRenderer("dozing", ::doze)

private fun doze(): Nothing {
    while (true) Thread.sleep(5)
}

/** Has all capabilities that flags can require. Delegates to `lists`, and records its options. */
class CapableRenderer(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "capable"

    override val summary: String get() = "supports every flag"

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.MEMORY_BUDGET,
            Capability.COHERENCE,
            Capability.PARALLEL,
            Capability.SELECTION,
            Capability.TRANSPARENCY,
        )

    override fun configured(options: RenderOptions): Renderer = CapableRenderer(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        asked = options
        return ListsRenderer(options.supportedBy(ListsRenderer())).render(frame, sink)
    }

    companion object {
        /** The options of the last rendering. */
        var asked: RenderOptions? = null
    }
}

/** Correct except for the pixel at (20, 15), which [spoil] changes. */
open class WrongRenderer(override val id: String, private val spoil: (IntArray, IntArray, IntArray) -> Unit) :
    Renderer {
    override val summary: String get() = "has one wrong pixel"

    override fun render(frame: Frame, sink: RowSink): Counters = ZBufferRenderer().render(frame) {
            y,
            argb,
            depth,
            primitive
        ->
        if (y == 15) spoil(argb, depth, primitive)
        sink.row(y, argb, depth, primitive)
    }
}

class WrongColorRenderer : WrongRenderer("wrong-color", { argb, _, _ -> argb[20] = argb[20] xor 0x100 })

class WrongDepthRenderer : WrongRenderer("wrong-depth", { _, depth, _ -> depth[20]++ })

class WrongPrimitiveRenderer : WrongRenderer("wrong-primitive", { _, _, primitive -> primitive[20]++ })

/** Correct only every second time. */
class FickleRenderer : Renderer {
    private var runs = 0

    override val id: String get() = "fickle"

    override val summary: String get() = "is right every other time"

    override fun render(frame: Frame, sink: RowSink): Counters =
        (if (runs++ % 2 == 0) ZBufferRenderer() else WrongColorRenderer()).render(frame, sink)
}

/** Delivers rows as [deliver] does. */
open class RowsRenderer(override val id: String, private val deliver: (Int, () -> Unit) -> Unit) : Renderer {
    override val summary: String get() = "loses or repeats rows"

    override fun render(frame: Frame, sink: RowSink): Counters = ZBufferRenderer().render(frame) {
            y,
            argb,
            depth,
            primitive
        ->
        deliver(y) { sink.row(y, argb, depth, primitive) }
    }
}

class ShortRenderer : RowsRenderer("short", { y, row -> if (y < 20) row() })

class StutteringRenderer : RowsRenderer("stuttering", { y, row -> repeat(if (y == 7) 2 else 1) { row() } })

/** Writes a jar that registers these classes as renderers. */
internal fun Path.rendererJar(vararg classes: Class<*>, name: String = "mine.jar"): Path {
    val manifest = Manifest()
    manifest.mainAttributes[Attributes.Name.MANIFEST_VERSION] = "1.0"
    manifest.mainAttributes[Attributes.Name.IMPLEMENTATION_VERSION] = "2.7"
    val path = resolve(name)
    JarOutputStream(path.outputStream(), manifest).use { jar ->
        jar.putNextEntry(JarEntry("META-INF/services/dev.lazyz.Renderer"))
        jar.write(classes.joinToString("\n") { it.name }.toByteArray())
        jar.closeEntry()
    }
    return path
}

/** Runs [block] with the classes [names] registered as renderers on the class path, by a file in [folder]. */
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
