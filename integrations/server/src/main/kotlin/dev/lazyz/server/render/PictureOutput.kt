package dev.lazyz.server.render

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.Image.PixelHash
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.aov.Aov
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.pictures.Blank
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.VisibleRows
import dev.lazyz.scenes.sheets.ContactSheet
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.scenes.writers.animation.ApngSink
import java.io.OutputStream
import java.security.DigestOutputStream
import java.security.MessageDigest
import java.util.HexFormat

/** Renders what [request] asks for, and writes it to [file]: a picture, an animation, or data of pixels. */
internal class PictureOutput(private val file: OutputStream, private val request: PictureRequest) {
    private val hash = PixelHash()
    private val data = MessageDigest.getInstance("SHA-256")
    private lateinit var size: ImageSize
    private lateinit var rows: VisibleRows
    private var animation: ApngSink? = null
    private val sheet = ContactSheet.of(request.settings, request.views.map { it.name.lowercase() })
    private var frames = 0

    /** Fragments of all pictures. */
    var fragments = 0L
        private set

    /** Whether a part of the model is outside a picture. */
    var isCropped = false
        private set

    /** Why there is nothing to see in any picture, or null. */
    val blank: Blank? get() = rows.blank

    /** The media type. */
    val type: String
        get() = when {
            request.aovs.isNotEmpty() -> "application/zip"
            request.steps != null -> "image/apng"
            else -> "image/png"
        }

    /** Names what was written by pixels or data; width and height are no part of the hash. Call it once, at the end. */
    fun tag(): String {
        val turn = request.steps?.let { listOf(it, request.framesPerSecond) }.orEmpty()
        val words = request.aovs.sorted().map(Aov::id) + request.views.map { it.name.lowercase() }
        val digest = if (request.aovs.isEmpty()) hash.digest() else HexFormat.of().formatHex(data.digest())
        return (listOf(size, digest) + turn + words).joinToString("-")
    }

    /** Renders [frame], which is the next picture. */
    fun add(frame: PictureFrame, renderer: Renderer) {
        if (!::size.isInitialized) {
            size = ImageSize(frame.pixels.width, frame.pixels.height)
            rows = VisibleRows(size.width)
        }
        isCropped = isCropped || frame.isCropped
        fragments += when {
            request.aovs.isNotEmpty() -> {
                val aovs = frame.render(renderer, seen { _, _, _, _ -> }, request.aovs)
                AovFiles.writeArchive(DigestOutputStream(file, data), aovs.images)
                aovs.counters
            }
            request.steps != null -> turned(frame, renderer)

            request.views.isNotEmpty() -> {
                val cell = Image.Collector(frame.pixels)
                val counters = frame.render(renderer, seen(cell))
                sheet.put(frames, cell.toImage(counters).argb)
                if (++frames == request.views.size) sheet.write(file)
                counters
            }

            else -> PngSink(file, size.width, size.height, frame.alpha).use { frame.render(renderer, seen(it)) }
        }.fragments
    }

    private fun turned(frame: PictureFrame, renderer: Renderer): Counters {
        val steps = checkNotNull(request.steps)
        val shape = Animation(size.width, size.height, steps, request.framesPerSecond, frame.alpha)
        val sink = animation ?: ApngSink(file, shape).also { animation = it }
        return frame.render(renderer, seen(sink)).also { if (++frames == steps) sink.close() }
    }

    private fun seen(sink: RowSink) = RowSink { y, argb, depth, primitive ->
        hash.add(argb, size.width)
        rows.row(y, argb, depth, primitive)
        sink.row(y, argb, depth, primitive)
    }
}
