package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.RowSink
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.scenes.writers.RowProducer
import dev.lazyz.scenes.writers.TemporaryFile
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.WRITE

/**
 * Writes Deep Zoom pyramids: a descriptor, `NAME.dzi`, and a folder of tiles beside it, `NAME_files`. Viewers such as
 * OpenSeadragon load only the tiles that they show, so a picture of any size can be looked at in a browser. If the
 * descriptor is a link, the tiles are beside the file that it names.
 *
 * Tiles are collected in a temporary folder beside their place, and get their name when they are complete; then the
 * descriptor is written. So a failure, or a signal that ends the process, leaves no partial files. An old pyramid of
 * the same name is replaced then. [DeepZoomSink] describes the tiles, time and memory.
 */
public object DeepZoomFiles {
    /** File name extension of descriptors, lower case, without a dot. */
    public const val EXTENSION: String = "dzi"

    /**
     * Writes the rows that [produce] renders.
     *
     * For example `DeepZoomFiles.write(path, frame.width, frame.height) { sink -> renderer.render(frame, sink) }`.
     *
     * @param path the descriptor
     * @param width number of columns
     * @param height number of rows
     * @param alpha whether tiles have an alpha channel
     * @param produce renders to the sink it is given, all rows from the top
     * @return what [produce] returns
     * @throws IllegalArgumentException if [path] does not end in `.dzi`, or a side is not in the range of
     *   [DeepZoomSink]
     * @throws IOException if a file cannot be written, or the folder of the tiles exists and has other files; the
     *   message states which file, why, and what to do
     * @throws InterruptedException if the thread is interrupted while it renders or writes
     */
    @JvmStatic
    @JvmOverloads
    @Throws(InterruptedException::class, IOException::class)
    public fun <R> write(
        path: Path,
        width: Int,
        height: Int,
        alpha: AlphaChannel = AlphaChannel.KEEP,
        produce: RowProducer<R>,
    ): R = writing(path) { files ->
        TemporaryFile.beside(files.folder).use { temporary ->
            val result = DeepZoomSink(temporary.folder, width, height, alpha).use { produce.sendTo(it) }
            files.publish(temporary.folder, width, height)
            result
        }
    }

    /**
     * Writes the rows that [produce] renders, and goes on where an earlier, interrupted call of this function stopped.
     * The files are the same, byte for byte, as if there had been no interruption.
     *
     * Until they are complete, tiles are in the folder `NAME_files.partial`, which stays if the call fails or the
     * process ends, for whatever reason, even if it is killed. If `NAME_files` is a link, it is beside the folder that
     * the link names, with the name of that folder. The next call reads the finished rows of tiles of the largest
     * level, which takes less time than rendering and compressing them, and has the rest rendered.
     *
     * @param path the descriptor
     * @param width number of columns
     * @param height number of rows
     * @param alpha whether tiles have an alpha channel
     * @param facts all that the picture depends on, by name, such as a hash of the model, and the version of the
     *   program
     * @param produce renders to the sink it is given, all rows from the number that it is given
     * @return what [produce] returns
     * @throws IllegalArgumentException if [path] does not end in `.dzi`, or a side is not in the range of
     *   [DeepZoomSink]
     * @throws IOException if a file cannot be read or written; if the folder has tiles of a picture with other facts;
     *   or if another process is writing it. The message states which file, why, and what to do
     * @throws InterruptedException if the thread is interrupted while it renders or writes
     */
    @JvmStatic
    @Throws(InterruptedException::class, IOException::class)
    public fun <R> resume(
        path: Path,
        width: Int,
        height: Int,
        alpha: AlphaChannel,
        facts: Map<String, String>,
        produce: RemainingRows<R>,
    ): R = writing(path) { files ->
        val all = linkedMapOf("size" to "${width}x$height", "alpha" to alpha.name.lowercase()) + facts
        PartialPyramid(files, all).use { partial ->
            val result = DeepZoomSink(partial.tiles, width, height, alpha).use { sink ->
                val first = sink.resume()
                produce.sendTo(sink, first)
            }
            files.publish(partial.tiles, width, height)
            partial.delete()
            result
        }
    }

    /**
     * Makes a pyramid of tiles that are complete: for tiles that several processes have written. The folder [tiles]
     * gets its name, and then the descriptor is written. An old pyramid of the same name is replaced.
     *
     * @param path the descriptor
     * @param tiles the folder of the levels, as [DeepZoomSink] writes it, in the same file system as [path]
     * @param width number of columns
     * @param height number of rows
     * @throws IllegalArgumentException if [path] does not end in `.dzi`
     * @throws IOException if there is no folder [tiles], if a file cannot be moved or written, or if the folder of the
     *   pyramid's tiles exists and has other files; the message states which file, why, and what to do
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun publish(path: Path, tiles: Path, width: Int, height: Int): Unit = AtomicFile.explaining(path) {
        PyramidFiles(path).publish(tiles, width, height)
    }

    /**
     * Returns where the folder of the tiles is, or will be, if the descriptor is [path]. Links are followed.
     *
     * @throws IOException if a link cannot be followed
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun tiles(path: Path): Path = PyramidFiles.tiles(path)

    private inline fun <R> writing(path: Path, block: (PyramidFiles) -> R): R =
        AtomicFile.rendering { AtomicFile.explaining(path) { block(PyramidFiles(path)) } }
}

/** Produces the rows of an image from a certain one on. */
public fun interface RemainingRows<R> {
    /**
     * Passes the rows from [first] on to [sink], in order.
     *
     * @param first the first row, counted from the top of the image from 0; smaller than its height
     * @return any result, for example the counters of the rendering
     * @throws IOException if the sink throws it
     * @throws InterruptedException if the rendering is interrupted
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun sendTo(sink: RowSink, first: Int): R
}

/**
 * The folder of a pyramid that stays if its writing is interrupted, and belongs to one process at a time. A file in it
 * states what the picture depends on.
 *
 * @param facts what the picture depends on, by name
 * @throws IOException if the folder belongs to a picture with other facts, or another process writes it
 */
internal class PartialPyramid(private val files: PyramidFiles, facts: Map<String, String>) : AutoCloseable {
    private val stated = files.partial.resolve("resume.txt")
    private val channel: FileChannel

    /** The folder of the tiles. */
    val tiles: Path = files.partial.resolve("tiles")

    init {
        if (Files.exists(files.partial) && !Files.exists(stated) && Files.list(files.partial).use { it.count() } > 0) {
            throw files.refused("${files.partial} is not from an interrupted run; move it away")
        }
        Files.createDirectories(files.partial)
        channel = FileChannel.open(stated, CREATE, READ, WRITE)
        try {
            if (!TemporaryFile.tryLock(channel)) {
                throw files.refused("another process is writing ${files.partial}; wait until it has ended")
            }
            val text = facts.entries.joinToString("") { (name, value) -> "$name: ${value.replace('\n', ' ')}\n" }

            // Not with another channel: on Linux, all locks on a file are lost when one of its channels is closed
            val old = String(Channels.newInputStream(channel).readAllBytes())
            if (old.isEmpty()) channel.write(ByteBuffer.wrap(text.toByteArray())) else requireSame(old, text)
        } catch (e: IOException) {
            channel.close()
            throw e
        }
    }

    /** Deletes the folder, after the tiles were moved out of it. */
    fun delete() {
        Files.delete(stated)
        Files.delete(files.partial)
    }

    override fun close() = channel.close()

    private fun requireSame(old: String, new: String) {
        if (old == new) return
        val before = old.lines()
        val after = new.lines()
        val i = (before zip after).indexOfFirst { (a, b) -> a != b }.coerceAtLeast(0)
        throw files.refused(
            "${files.partial} is from a run with another picture (\"${before[i]}\", and now \"${after[i]}\"); " +
                "run the same command as then, or delete that folder to begin again",
        )
    }
}
