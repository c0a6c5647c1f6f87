package dev.lazyz.spark.models

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.ReferencePolicy
import dev.lazyz.scenes.formats.ModelArchive
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.VisibleRows
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.tiled.TiledRenderer
import java.io.ByteArrayOutputStream
import java.io.Serializable
import java.nio.ByteBuffer
import java.time.Duration
import org.apache.spark.SparkEnv
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType

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

/** The columns of pictures of models. */
internal object PictureColumns {
    private val counters = StructType()
        .add("primitives", DataTypes.LongType).add("fragments", DataTypes.LongType)
        .add("depthEvaluations", DataTypes.LongType).add("depthPasses", DataTypes.LongType)
        .add("shadingCalls", DataTypes.LongType)

    val schema: StructType = StructType()
        .add("name", DataTypes.StringType).add("options", DataTypes.StringType)
        .add("width", DataTypes.IntegerType).add("height", DataTypes.IntegerType)
        .add("png", DataTypes.BinaryType).add("pixels", DataTypes.BinaryType).add("depth", DataTypes.BinaryType)
        .add("npz", DataTypes.BinaryType)
        .add("hash", DataTypes.StringType).add("counters", counters)
        .add("blank", DataTypes.StringType).add("cropped", DataTypes.BooleanType)
        .add("warnings", DataTypes.createArrayType(DataTypes.StringType))
        .add("error", DataTypes.StringType)

    /** Returns the row of a picture. */
    fun row(
        name: String,
        wish: PictureOptions,
        image: Image,
        isCropped: Boolean,
        warnings: List<String>,
    ): Row = RowFactory.create(
        name, wish.words, image.width, image.height,
        if (wish.has("png")) image.toPng() else null,
        if (wish.has("pixels")) bytes(image.argb) else null,
        if (wish.has("depth")) bytes(image.depth) else null, null,
        image.pixelHash(), row(image.counters),
        VisibleRows(image.width).apply { add(image) }.blank?.name?.lowercase(), isCropped,
        warnings.toTypedArray(), null,
    )

    /** Returns the row of what is in place of one picture: [file], which [written] has made. */
    fun row(
        name: String,
        wish: PictureOptions,
        written: PictureOutput.Writer,
        file: ByteArray,
        warnings: List<String>,
    ): Row = RowFactory.create(
        name, wish.words, written.size.width, written.size.height,
        file.takeIf { written.output.aovs.isEmpty() }, null, null, file.takeIf { written.output.aovs.isNotEmpty() },
        written.hash, row(written.counters), written.blank?.name?.lowercase(), written.isCropped,
        warnings.toTypedArray(), null,
    )

    /** Returns the row of a model that cannot be shown. */
    fun failure(name: String, words: String, error: String): Row =
        RowFactory.create(name, words, null, null, null, null, null, null, null, null, null, null, null, error)

    private fun row(counters: Counters): Row = with(counters) {
        RowFactory.create(primitives, fragments, depthEvaluations, depthPasses, shadingCalls)
    }

    /** Returns the numbers as bytes, each from the highest to the lowest byte. */
    private fun bytes(numbers: IntArray): ByteArray =
        ByteBuffer.allocate(Int.SIZE_BYTES * numbers.size).apply { asIntBuffer().put(numbers) }.array()
}
