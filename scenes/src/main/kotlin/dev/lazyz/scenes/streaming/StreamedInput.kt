package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.writers.TemporaryFile
import java.io.InputStream
import java.nio.channels.Channels
import java.nio.file.Files
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * A file that is read part by part, and the temporary files that belong to it. Not thread safe, unlike [file].
 *
 * @param name name of the file in messages
 * @param copy the temporary file at [path], or null if the user's own file is there
 * @param folder where temporary files are created
 */
internal class StreamedInput private constructor(
    private val path: Path,
    name: String,
    private val copy: TemporaryFile?,
    private val folder: Path,
) : AutoCloseable {
    /** The whole file. */
    val file: FileBytes = FileBytes(path, name)

    private var spool: AutoCloseable? = null

    /** Returns the first bytes of the file, which determine its format. */
    fun head(): ByteArray = file.read(0, minOf(HEAD, file.size).toInt()).array()

    /** Opens the file from its beginning. */
    fun bytes(): InputStream = Files.newInputStream(path)

    /** Creates a temporary file of triangles, which are read from [source]. An earlier one is deleted. */
    fun spool(source: Source, origin: Vector3dc): FacetSpool {
        spool?.close()
        return FacetSpool(folder, source, origin).also { spool = it }
    }

    /** Creates temporary files of vertices and triangles, which are read from [source]. Earlier ones are deleted. */
    fun indexed(source: Source, origin: Vector3dc): IndexedSpool {
        spool?.close()
        return IndexedSpool(folder, source, origin).also { spool = it }
    }

    override fun close() {
        spool?.close()
        file.close()
        copy?.close()
    }

    companion object {
        private const val HEAD = 65_536L

        /** Opens the file at [path]. */
        fun ofFile(path: Path, name: String, folder: Path): StreamedInput = StreamedInput(path, name, null, folder)

        /** Copies all of [input] to a temporary file, and opens it. */
        fun ofStream(input: InputStream, name: String, folder: Path): StreamedInput {
            val copy = TemporaryFile.within(folder)
            try {
                input.transferTo(Channels.newOutputStream(copy.channel))
                return StreamedInput(copy.path, name, copy, folder)
            } catch (e: Throwable) {
                copy.close()
                throw e
            }
        }
    }
}
