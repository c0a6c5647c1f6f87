package dev.lazyz.spark.models

import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.ReferencePolicy
import dev.lazyz.scenes.formats.ModelArchive
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.strategies.tiled.TiledRenderer
import java.io.ByteArrayOutputStream
import java.io.Serializable
import java.time.Duration
import org.apache.spark.SparkEnv
import org.apache.spark.sql.Row

/**
 * Renders models, each on the calling thread alone, as Spark runs a task for each core. Thread safe.
 *
 * @param limits limits on what a model can request; without a limit of decoded data, the [share] of a task
 */
internal class ModelPicture(limits: LoadLimits) {
    private val options = RenderOptions(threads = 1)
    private val renderer: Renderer = TiledRenderer(options)
    private val limits = if (limits.decodedBytes == null) limits.withDecodedBytes(share()) else limits

    /**
     * Returns the row of a picture, see [PictureColumns]. A model that cannot be shown is a row with its error.
     *
     * @param name name of the model in the row and in messages
     * @throws InterruptedException if the task is being killed
     */
    fun row(name: String, bytes: ByteArray?, words: String): Row = try {
        picture(name, requireNotNull(bytes) { "$name: there are no bytes" }, PictureOptions(words))
    } catch (e: InterruptedException) {
        throw e
    } catch (e: Exception) {
        // A reader that is interrupted reports this as a problem of the file
        if (Thread.currentThread().isInterrupted) throw InterruptedException("interrupted while rendering $name")
        PictureColumns.failure(name, words, e.message ?: e.toString())
    }

    private fun picture(name: String, bytes: ByteArray, wish: PictureOptions): Row =
        ModelArchive.read(bytes, wish.format, name, wish.model, wish.settings(), limits) { loaded, settings ->
            val observer = PictureObserver(name, limits)
            val output = wish.output()
            if (output == null) {
                val frame = settings.frame(loaded, options, observer)
                val warnings = loaded.warnings + observer.warnings
                PictureColumns.row(name, wish, frame.render(renderer), frame.isCropped, warnings)
            } else {
                val file = ByteArrayOutputStream()
                val writer = output.writer(file, settings, loaded)
                for (number in 0 until output.frames) writer.add(writer.frame(number, options, observer), renderer)
                val warnings = loaded.warnings + observer.warnings.distinct()
                PictureColumns.row(name, wish, writer, file.toByteArray(), warnings)
            }
        }

    companion object {
        /** Bytes of heap for each byte of decoded data while a model is read and rendered, see docs/server.md. */
        private const val MEMORY_PER_DECODED = 4

        /** The part of the heap that Spark leaves to the code of users: `spark.memory.fraction` is 0.6. */
        private const val USER_PART = 0.4

        /** Returns the bytes of decoded data that a model may have if all tasks of this JVM read one. */
        private fun share(): Long {
            val slots = SparkEnv.get()?.conf()?.getInt("spark.executor.cores", 0)?.takeIf { it > 0 }
                ?: Runtime.getRuntime().availableProcessors()
            return (Runtime.getRuntime().maxMemory() * USER_PART / MEMORY_PER_DECODED / slots).toLong()
        }
    }
}

/** The values of [LoadLimits], on their way to an executor. */
internal class SerializableLimits(limits: LoadLimits) : Serializable {
    private val decodedBytes: Long? = limits.decodedBytes
    private val triangles: Long = limits.triangles
    private val vertices: Long = limits.vertices
    private val texels: Long = limits.texels
    private val nesting: Int = limits.nesting
    private val time: Duration? = limits.time
    private val references: ReferencePolicy = limits.references
    private val items: Long = limits.items

    /** Returns the limits. */
    fun limits(): LoadLimits =
        LoadLimits(decodedBytes, triangles, vertices, texels, nesting, time, references, items = items)
}
