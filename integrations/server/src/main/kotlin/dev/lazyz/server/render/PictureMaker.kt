package dev.lazyz.server.render

import dev.lazyz.RenderOptions
import dev.lazyz.aov.Aov
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.ClientText
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.ModelArchive
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.Blank
import dev.lazyz.scenes.pictures.NoPictureException
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Mesh
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.InputStream
import java.security.MessageDigest
import java.util.HexFormat
import java.util.concurrent.ForkJoinPool

/**
 * Reads models and renders pictures of them, each on the calling thread alone. Thread safe.
 *
 * @param limits limits on what a model can request
 * @param mostDecoded the limit of decoded data for each model, if [limits] have none
 */
internal class PictureMaker(private val limits: LoadLimits, mostDecoded: Long) {
    private val options = RenderOptions(threads = 1)

    /** Its needs are upper bounds. */
    private val renderer = TiledRenderer(options)
    private val pngBlocks = minOf(2 * ForkJoinPool.getCommonPoolParallelism() + 1, MOST_BLOCKS)
    private val mostDecoded = limits.decodedBytes ?: mostDecoded

    /** Returns the bytes of memory that a picture takes besides its model. */
    fun pictureNeed(request: PictureRequest): Long {
        val columns = request.width.toLong() * request.factor
        return columns * BYTES_PER_COLUMN + FIXED_BYTES + outputNeed(request) + shadowNeed(request)
    }

    private fun shadowNeed(request: PictureRequest): Long {
        val hasShadows = request.settings.hasOcclusion || request.settings.hasGroundShadow
        return if (hasShadows) SHADOW_BYTES else 0
    }

    private fun outputNeed(request: PictureRequest): Long {
        val numbers = request.output.aovs.sumOf { it.channels.size } + if (request.output.views.isEmpty()) 0 else 1
        return request.pixels * (BYTES_PER_PIXEL + numbers * BYTES_PER_NUMBER) + pngBlocks * BLOCK_BYTES
    }

    /** What edges and cuts take of a model that is loaded. */
    private fun linesNeed(scene: Scene, request: PictureRequest): Long {
        val meshes = scene.surfaces.filterIsInstance<Mesh>()
        val edges = if (request.settings.hasEdges) meshes.sumOf { it.triangleCount * BYTES_PER_EDGED } else 0L
        val cuts = request.settings[PictureParameters.CUT].orEmpty().size
        return edges + cuts * meshes.sumOf { (it.triangleCount + it.vertexCount) * BYTES_PER_CUT }
    }

    /**
     * Returns the bytes of memory that a model of [size] bytes that begin with [start] takes, with an array of them.
     *
     * @param format its format, or that of the model in a ZIP archive; null if its content decides
     * @throws Problem if it looks like no model
     */
    fun modelNeed(format: SceneFormat?, start: ByteArray, size: Int): Long =
        decoded(format, start, size) * MEMORY_PER_DECODED + size

    /**
     * Returns the picture of the model in [body], a file or a ZIP archive, in [memory] bytes.
     *
     * @param format as for [modelNeed]
     * @param grow is called with the bytes that are needed, when that turns out to be more than [memory], before they
     *   are used. It throws if there are too few
     * @throws dev.lazyz.scenes.SceneFormatException if the model is invalid, or exceeds a limit
     * @throws Problem if it cannot be shown as requested
     * @throws InterruptedException if the thread is interrupted
     */
    fun picture(
        body: ByteArray,
        format: SceneFormat?,
        request: PictureRequest,
        memory: Long,
        grow: (Long) -> Unit,
    ): RenderedPicture {
        val decoded = decoded(format, body, body.size)
        val own = limits.withDecodedBytes(decoded)
        return ModelArchive.read(body, format, "model", request.model, request.settings, own) { loaded, settings ->
            requireGoingOn()
            val items = listOf(
                RenderPlan.Item("file", body.size.toLong()),
                RenderPlan.Item("model", decoded),
                RenderPlan.Item("other files", decoded * settings.files.size),
                RenderPlan.Item("lines and cuts", linesNeed(loaded.scene, request)),
            )
            picture(loaded, settings, request, PictureObserver(limits = own), items, memory, grow)
        }
    }

    /** Returns the picture of [loaded]; [before] is what it takes besides drawing. */
    private fun picture(
        loaded: LoadedScene,
        settings: PictureSettings,
        request: PictureRequest,
        observer: PictureObserver,
        before: List<RenderPlan.Item>,
        memory: Long,
        grow: (Long) -> Unit,
    ): RenderedPicture {
        // The loader's working memory is free now
        val items = before + listOf(
            RenderPlan.Item("set-up", loaded.scene.setUpBytes),
            RenderPlan.Item("output", outputNeed(request)),
            RenderPlan.Item("shadows", shadowNeed(request)),
        )
        val setUp = items.sumOf { it.bytes }
        if (setUp > memory) grow(setUp)
        val file = RenderedPicture.Bytes()
        val writer = request.output.writer(file, settings, loaded)
        for (number in 0 until request.output.frames) {
            val frame = try {
                writer.frame(number, options, observer)
            } catch (e: NoPictureException) {
                val reason = ClientText.of(e.message.orEmpty())
                throw Problem(Problem.UNPROCESSABLE, "the model cannot be shown as requested: $reason")
            }
            requireGoingOn()
            val plan = plan(frame, maxOf(memory, setUp), items)
            if (!plan.fits) grow(plan.bytes)
            writer.add(frame, plan.renderer)
        }
        if (writer.counters.fragments == 0L) throw nothing(loaded)
        val warnings = loaded.warnings + observer.warnings.distinct()
        return RenderedPicture.of(file, writer, warnings)
    }

    /** Returns the problem that the picture is empty, with the reasons. */
    private fun nothing(loaded: LoadedScene): Problem {
        val left = loaded.warnings.take(MOST_REASONS).map(ClientText::of)
        val reasons = left + "what there is has no area, no finite corners, or is too small or outside"
        return Problem(Problem.UNPROCESSABLE, "nothing of the model remains to show: ${reasons.joinToString("; ")}")
    }

    /** Returns the plan that fits into [memory] bytes, or the one that needs the least. No reserve is part of them. */
    private fun plan(frame: PictureFrame, memory: Long, items: List<RenderPlan.Item>): RenderPlan =
        frame.plan(RenderPlanner(RenderPlan.leastMemory(memory), options), listOf(renderer), items)

    /** Returns the limit of decoded data for a model: text and plain numbers become at most so many times larger. */
    private fun decoded(format: SceneFormat?, start: ByteArray, size: Int): Long {
        if (ModelArchive.isZip(start)) return mostDecoded
        return when (format ?: MediaTypes.sniffed(start, size)) {
            SceneFormat.OBJ, SceneFormat.STL, SceneFormat.PLY, SceneFormat.OFF ->
                minOf(mostDecoded, LEAST_DECODED + MOST_GROWTH * size)
            else -> mostDecoded
        }
    }

    private fun requireGoingOn() {
        if (Thread.currentThread().isInterrupted) throw InterruptedException("interrupted between two steps")
    }

    companion object {
        /** Bytes of heap for each byte of decoded data while a model is read, see docs/server.md. */
        const val MEMORY_PER_DECODED = 4L

        /** Decoded data of the smallest models. */
        private const val LEAST_DECODED = 1L shl 20

        /** Decoded bytes for each byte of a model without compression, at most. Usual ones have 1 to 4. */
        private const val MOST_GROWTH = 16L

        /** Warnings in a message. */
        private const val MOST_REASONS = 5

        /** The PNG file, and room for it to grow. */
        private const val BYTES_PER_PIXEL = 8L

        /** A number of an AOV, or the colour of a cell, and the same in a file that grows. */
        private const val BYTES_PER_NUMBER = 12L

        /** Rows of tiles and of the filter. */
        private const val BYTES_PER_COLUMN = 1024L

        /** What every rendering takes. */
        private const val FIXED_BYTES = 1L shl 20

        /** Maps of distances, see [dev.lazyz.lighting.AmbientOcclusion]. */
        private const val SHADOW_BYTES = 18L shl 20

        /**
         * For a triangle: its edges with neighbours, their places on the raster and what hides them, and lines; and its
         * part of a cut, with that of the vertices.
         */
        private const val BYTES_PER_EDGED = 768L
        private const val BYTES_PER_CUT = 256L

        /** A block of a PNG file while it is compressed, see [dev.lazyz.scenes.writers.PngSink]. */
        private const val BLOCK_BYTES = 1L shl 20
        private const val MOST_BLOCKS = 17
    }
}

/**
 * A finished picture.
 *
 * @param file the bytes of a file
 * @property type its media type
 * @property tag names the picture: two with the same pixels, or the same data, have the same
 * @param warnings what the loader has left out
 * @property blank why there is nothing to see in it, or null
 * @property isCropped whether a part of the model is outside
 */
internal class RenderedPicture(
    private val file: Bytes,
    val type: String,
    val tag: String,
    warnings: List<String>,
    val blank: Blank?,
    val isCropped: Boolean,
) {
    /** The number of warnings. */
    val warningCount = warnings.size

    /** The first warnings, for the client. */
    val warnings: List<String> = warnings.take(MOST_WARNINGS).map(ClientText::of)

    /** The bytes of the file. */
    val size: Int get() = file.size()

    /** The bytes of memory that it takes: its array has room to grow. */
    val memory: Long get() = file.room.toLong()

    fun open(): InputStream = file.open()

    companion object {
        private const val MOST_WARNINGS = 5

        /** Returns the picture that [written] has written to [file]. */
        fun of(file: Bytes, written: PictureOutput.Writer, warnings: List<String>): RenderedPicture {
            val tag = with(written.output) {
                val turn = steps?.let { listOf(it, framesPerSecond) }.orEmpty()
                val words = aovs.sorted().map(Aov::id) + views.map { it.name.lowercase() }
                val digest = if (aovs.isEmpty()) written.hash else file.digest()
                (listOf(written.size, digest) + turn + words).joinToString("-")
            }
            return RenderedPicture(file, written.output.mediaType, tag, warnings, written.blank, written.isCropped)
        }
    }

    /** Collects bytes, and reads them again without a copy. */
    class Bytes : ByteArrayOutputStream() {
        /** The length of the array. */
        val room: Int get() = buf.size

        /** The SHA-256 of the bytes. */
        fun digest(): String {
            val sha = MessageDigest.getInstance("SHA-256").also { it.update(buf, 0, count) }
            return HexFormat.of().formatHex(sha.digest())
        }

        fun open(): InputStream = ByteArrayInputStream(buf, 0, count)
    }
}
