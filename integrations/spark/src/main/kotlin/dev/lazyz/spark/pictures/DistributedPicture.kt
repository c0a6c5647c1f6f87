package dev.lazyz.spark.pictures

import dev.lazyz.Counters
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import java.io.IOException
import java.io.Serializable
import java.nio.file.Path
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SparkSession

/**
 * One large picture, of which each task renders a part. The bits are those of one JVM.
 *
 * ```
 * val picture = DistributedPicture(spark) { SuperSampling.NONE.of(Scenes.city().frame(20000, 10000)) }
 * picture.writePng(Path.of("city.png"))
 * ```
 *
 * Every JVM has the whole scene in memory, and shows a part of it at a time on each of its threads, with
 * `TiledRenderer`. All scenes are possible, also translucent and anti-aliased ones. For scenes larger than the memory
 * of an executor see `TrianglePicture`.
 *
 * If a task fails or an executor is lost, Spark renders its parts again; a part that is rendered twice has the same
 * bits. Thread safe.
 *
 * If the driver itself may end, see [checkpointed].
 */
public class DistributedPicture private constructor(
    private val context: JavaSparkContext,
    private val source: OncePerJvm,
    private val checkpoint: Checkpoint?,
) {
    /** Where parts are kept, and what the picture depends on. */
    private class Checkpoint(val parts: PartFiles, val facts: Map<String, String>)

    /**
     * @param spark where to render
     * @param source makes the frame; the driver calls it once, too, to know the size
     */
    public constructor(spark: SparkSession, source: PictureSource) :
        this(JavaSparkContext.fromSparkContext(spark.sparkContext()), OncePerJvm(source), null)

    private val region = this.source.picture().pixels
    private val alpha: AlphaChannel
        get() = if (source.picture().frame.raster.background.alpha >= 1f) AlphaChannel.DROP else AlphaChannel.KEEP

    /** Number of columns, in pixels. */
    public val width: Int get() = region.width

    /** Number of rows, in pixels. */
    public val height: Int get() = region.height

    /**
     * Returns this picture with its finished parts kept in [folder], so that a new driver continues where an earlier
     * one has ended, for whatever reason, even if it was killed: parts that are there, and not damaged, are not
     * rendered again. When the picture is complete, the parts are deleted.
     *
     * The parts of a cluster with another number of cores, or of another function of this class, are other parts.
     *
     * @param folder a folder of its own for each picture, which all executors and the driver must see under the same
     *   path; it is created if it does not exist
     * @param facts all that the picture depends on, by name, such as the name and the hash of the model. Rendering
     *   throws an [IOException] if the folder has parts of a picture with other facts
     */
    public fun checkpointed(folder: Path, facts: Map<String, String>): DistributedPicture {
        val all = linkedMapOf("size" to "${width}x$height") + facts
        return DistributedPicture(context, source, Checkpoint(PartFiles("${folder.toAbsolutePath()}"), all))
    }

    /** Calls [work] with the parts, of [planes]. */
    private fun <R> rendering(planes: Int, work: (SortFirst) -> R): R {
        checkpoint?.let { it.parts.open(it.facts) }
        val result = SortFirst(context, source, planes, checkpoint?.parts).use(work)
        checkpoint?.parts?.delete()
        return result
    }

    /**
     * Renders the picture, and passes its rows to [sink] on this thread, from the top, as `SampledFrame.render`
     * does.
     *
     * Memory of the driver: one band of some rows. The executors keep finished bands on disk until they are read.
     *
     * @throws org.apache.spark.SparkException if a task has failed too often
     * @throws IOException if the sink throws it
     */
    @Throws(IOException::class)
    public fun render(sink: RowSink): Counters = rendering(SortFirst.ALL_PLANES) {
        it.render(SortFirst.bands(region, context.defaultParallelism()), sink)
    }

    /**
     * Writes the picture to a PNG file on the driver. The file appears when it is complete, and has the bytes that one
     * JVM writes. The executors render, and the driver compresses; a pyramid, [writeDeepZoom], is compressed by all.
     *
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     * @throws InterruptedException if the thread is interrupted while it writes
     * @throws org.apache.spark.SparkException if a task has failed too often
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun writePng(path: Path): Counters = rendering(planes = 1) { parts ->
        ImageFiles.write(path, width, height, ImageFormat.PNG, alpha) { sink ->
            parts.render(SortFirst.bands(region, context.defaultParallelism()), sink)
        }
    }

    /**
     * Writes the picture as a Deep Zoom pyramid: a descriptor, `NAME.dzi`, and a folder of tiles beside it,
     * `NAME_files`, whose pixels are those that `DeepZoomFiles` writes.
     *
     * The executors write the tiles into a folder beside the place of the pyramid, which all of them and the driver
     * must see under the same path. The pyramid appears when it is complete; if the job fails, the folder is deleted.
     * Each attempt of a task writes to files of its own first, so attempts do not disturb each other.
     *
     * Levels below 1/1024 of the size, which have up to 256 x 256 pixels, are made by the driver of all pixels.
     *
     * @param path the descriptor
     * @throws IllegalArgumentException if [path] does not end in `.dzi`
     * @throws IOException if a file cannot be written; the message states which file, why, and what to do
     * @throws org.apache.spark.SparkException if a task has failed too often
     */
    @Throws(IOException::class)
    public fun writeDeepZoom(path: Path): Counters = rendering(planes = 1) { parts ->
        PyramidJob(path, width, height, alpha).write(parts)
    }

    override fun toString(): String = "DistributedPicture($width x $height)"
}

/**
 * Makes the frame of a picture. It is sent to all executors, and called once in each JVM; so it should name a scene (a
 * file that all can read, a built-in scene, some parameters) rather than hold it. All calls must return the same
 * picture. In Kotlin and Java it can be a lambda:
 *
 * ```
 * PictureSource { SuperSampling.NONE.of(Scenes.load(path).scene.frame(30000, 20000)) }
 * ```
 *
 * [SuperSampling] also gives frames of several samples a pixel.
 */
public fun interface PictureSource : Serializable {
    /** Returns the frame, for pixels of the whole picture. */
    @Throws(Exception::class)
    public fun picture(): SampledFrame
}

/** Calls [source] once in each JVM. Thread safe. */
internal class OncePerJvm(private val source: PictureSource) : Serializable {
    @Transient
    private var made: SampledFrame? = null

    @Synchronized
    fun picture(): SampledFrame = made ?: source.picture().also { made = it }

    /** Does the work of a task. A source that holds its frame is notified. */
    fun <T> rendering(work: (SampledFrame) -> T): T =
        if (source is TaskWitness) source.during { work(picture()) } else work(picture())
}

/** A source that wants to know when tasks run, and what they throw. */
internal interface TaskWitness {
    /** Does [work], the work of a task. */
    fun <T> during(work: () -> T): T
}
