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
 * @param space the room that they may take
 */
internal class StreamedInput private constructor(
    private val path: Path,
    name: String,
    private val copy: TemporaryFile?,
    private val folder: Path,
    private val space: SpoolSpace,
) : AutoCloseable {
    /** The whole file. */
    val file: FileBytes = FileBytes(path, name)

    private var spool: FacetSpool? = null

    /** Returns the first bytes of the file, which determine its format. */
    fun head(): ByteArray = file.read(0, minOf(HEAD, file.size).toInt()).array()

    /** Opens the file from its beginning. */
    fun bytes(): InputStream = Files.newInputStream(path)

    /** Creates a temporary file of triangles, which are read from [source]. An earlier one is deleted. */
    fun spool(source: Source, origin: Vector3dc): FacetSpool {
        spool?.close()
        return FacetSpool(folder, source, origin, space).also { spool = it }
    }

    override fun close() {
        spool?.close()
        file.close()
        copy?.close()
    }

    companion object {
        private const val HEAD = 4096L

        /** Opens the file at [path]. */
        fun ofFile(path: Path, name: String, folder: Path, most: Long?): StreamedInput =
            StreamedInput(path, name, null, folder, SpoolSpace(folder, name, most))

        /** Copies all of [input] to a temporary file, and opens it. */
        fun ofStream(input: InputStream, name: String, folder: Path, most: Long?): StreamedInput {
            val space = SpoolSpace(folder, name, most)
            val copy = TemporaryFile.within(folder)
            try {
                input.transferTo(space.counting(Channels.newOutputStream(copy.channel)))
                return StreamedInput(copy.path, name, copy, folder, space)
            } catch (e: Throwable) {
                copy.close()
                throw e
            }
        }
    }
}
