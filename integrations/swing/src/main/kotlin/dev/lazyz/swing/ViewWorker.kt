package dev.lazyz.swing

import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.pictures.PictureStyle
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Mesh
import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.io.IOException
import java.io.UncheckedIOException
import java.util.concurrent.Callable
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import javax.swing.SwingUtilities
import kotlin.concurrent.withLock

/**
 * Where a model comes from. [read] is called once, by the thread that renders.
 *
 * @param name what the model is called in messages
 */
internal class Source(name: String, val read: Callable<LoadedScene>) : PictureObserver(name) {
    var camera: Camera? = null
        private set
    var up: UpAxis = UpAxis.Y
        private set
    private var loaded: LoadedScene? = null

    fun load(): LoadedScene = loaded ?: read.call().also { loaded = it }

    override fun camera(camera: Camera, up: UpAxis) {
        this.camera = camera
        this.up = up
    }

    /** Nobody reads the warnings of a picture that the next one replaces. */
    override fun warning(message: String): Unit = Unit
}

/** A picture that is wanted. */
internal class Wish(val source: Source, val settings: PictureSettings, val size: ImageSize)

/**
 * A picture that was rendered.
 *
 * @property isFinal whether it has all samples and effects, and not only those that are quick
 */
internal class Shown(
    val wish: Wish,
    val model: LoadedScene,
    val image: BufferedImage,
    val frame: PictureFrame,
    val camera: Camera,
    val up: UpAxis,
    val isFinal: Boolean,
)

/**
 * Renders the newest wish in a thread of its own: first quickly, with one sample a pixel, and then, unless another
 * wish comes within a moment, as its settings say. Such a picture, and the reading of a model, is interrupted by the
 * next wish; a quick one is finished, because a mouse can be faster, and there would be none.
 *
 * @param show shows a picture; returns the image that was shown before, which is used again. Called by Swing's thread
 * @param fail shows why there is no picture. Called by Swing's thread
 */
internal class ViewWorker(private val show: (Shown) -> BufferedImage?, private val fail: (Wish, String) -> Unit) {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()

    // Guarded by the lock
    private var wanted: Wish? = null
    private var thread: Thread? = null
    private var work: Work? = null

    // Of the thread. Each renderer keeps its arrays for the next picture of the same kind
    private val quick = TiledRenderer()
    private val full = TiledRenderer()
    private val isShown = Semaphore(0)
    private var free: BufferedImage? = null

    private class Work(val wish: Wish, val isFull: Boolean)

    /** Renders [wish] in place of all earlier ones. */
    fun request(wish: Wish): Unit = lock.withLock {
        wanted = wish
        val now = work
        if (thread == null) {
            thread = Thread(::run, "lazyz-view").apply { isDaemon = true }.also { it.start() }
        } else if (now != null && (now.isFull || now.wish.source !== wish.source)) {
            thread?.interrupt()
        }
        changed.signalAll()
    }

    /** Ends what is going on. */
    fun stop(): Unit = lock.withLock {
        wanted = null
        thread?.interrupt()
    }

    private fun run() {
        var last: Work? = null
        while (true) {
            val next = next(last) ?: return
            last = next.takeIf { attempt(it) }
        }
    }

    /** Waits for the next picture to render after [last]; returns null if there is none for a while. */
    private fun next(last: Work?): Work? = lock.withLock {
        // The interrupt was meant for the work that has ended
        Thread.interrupted()
        work = null
        val rest = last?.wish?.takeIf { !last.isFull }
        var left = TimeUnit.MILLISECONDS.toNanos(if (rest == null) IDLE_MILLIS else REST_MILLIS)
        while (wanted == null && left > 0) {
            try {
                left = changed.awaitNanos(left)
            } catch (_: InterruptedException) {
                // Nothing more is wanted
                thread = null
                return null
            }
        }
        val next = wanted?.let { Work(it, isFull = false) } ?: rest?.let { Work(it, isFull = true) }
        wanted = null
        work = next
        if (next == null) thread = null
        next
    }

    /** Renders and shows a picture; returns whether there is one. */
    private fun attempt(work: Work): Boolean {
        val wish = work.wish
        try {
            val shown = rendered(wish, work.isFull)
            SwingUtilities.invokeLater {
                free = show(shown)
                isShown.release()
            }
            isShown.acquireUninterruptibly()
            return true
        } catch (_: InterruptedException) {
            return false
        } catch (failure: IOException) {
            if (!isReplaced()) report(wish, failure)
        } catch (failure: UncheckedIOException) {
            report(wish, failure)
        } catch (failure: IllegalArgumentException) {
            report(wish, failure)
        } catch (failure: OutOfMemoryError) {
            report(wish, failure)
        }
        return false
    }

    /** Whether a later wish has interrupted the reading of a model. */
    private fun isReplaced(): Boolean = Thread.currentThread().isInterrupted

    private fun report(wish: Wish, failure: Throwable) =
        SwingUtilities.invokeLater { fail(wish, failure.message ?: failure.javaClass.simpleName) }

    private fun rendered(wish: Wish, isFull: Boolean): Shown {
        val model = wish.source.load()
        val settings = if (isFull) wish.settings else quick(wish.settings, model)
        val frame = settings.with(PictureParameters.SIZE, wish.size).frame(model, observer = wish.source)
        val image = image(wish.size, frame.alpha)
        val pixels = (image.raster.dataBuffer as DataBufferInt).data
        frame.render(if (isFull) full else quick) { y, argb, _, _ ->
            System.arraycopy(argb, 0, pixels, y * image.width, image.width)
        }
        return Shown(wish, model, image, frame, checkNotNull(wish.source.camera), wish.source.up, isFull)
    }

    private fun image(size: ImageSize, alpha: AlphaChannel): BufferedImage {
        val type = if (alpha == AlphaChannel.DROP) BufferedImage.TYPE_INT_RGB else BufferedImage.TYPE_INT_ARGB
        val old = free
        free = null
        if (old != null && old.width == size.width && old.height == size.height && old.type == type) return old
        return BufferedImage(size.width, size.height, type)
    }

    /** Returns [settings] without what takes long. */
    private fun quick(settings: PictureSettings, model: LoadedScene): PictureSettings {
        val slow = ArrayList(SLOW)
        if (settings[PictureParameters.STYLE] == PictureStyle.PRODUCT) slow += PictureParameters.STYLE
        val triangles = model.scene.surfaces.sumOf { if (it is Mesh) it.triangleCount else 0 }
        if (triangles > MOST_TRIANGLES_WITH_EDGES) slow += EDGES
        return slow.fold(settings) { all, parameter -> all.without(parameter) }.with(PictureParameters.AA, 1)
    }

    companion object {
        /** After this time without a new wish, a picture rests. */
        const val REST_MILLIS = 120L

        private const val IDLE_MILLIS = 2000L

        /** Edges of larger models are drawn when they rest. */
        const val MOST_TRIANGLES_WITH_EDGES = 20_000

        private val SLOW = listOf(
            PictureParameters.AA_FILTER, PictureParameters.AMBIENT_OCCLUSION, PictureParameters.GROUND_SHADOW,
        )

        /** What draws edges, and what needs it. */
        val EDGES = ParameterGroup.LINES.parameters - setOf(PictureParameters.CUT, PictureParameters.CAP_COLOR)
    }
}
