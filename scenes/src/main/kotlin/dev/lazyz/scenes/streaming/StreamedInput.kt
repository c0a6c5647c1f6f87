package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.loading.Loading
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
 * @param space where temporary files are created, and the room that they may take
 */
internal class StreamedInput private constructor(
    private val path: Path,
    name: String,
    private val copy: TemporaryFile?,
    private val space: SpoolSpace,
) : AutoCloseable {
    /** The whole file. */
    val file: FileBytes = FileBytes(path, name)

    private var spool: FacetSpool? = null
    private var vertices: VertexSpool? = null

    /** Returns the first bytes of the file, which determine its format. */
    fun head(): ByteArray = file.read(0, minOf(HEAD, file.size).toInt()).array()

    /** Opens the file from byte [position] on. */
    fun bytes(position: Long = 0): InputStream {
        // A temporary file must not be opened again
        if (copy != null) return file.stream(position)
        val bytes = Files.newInputStream(path)
        try {
            bytes.skipNBytes(position)
            return bytes
        } catch (e: Throwable) {
            bytes.close()
            throw e
        }
    }

    /** Creates a temporary file of triangles, which are read from [source]. An earlier one is deleted. */
    fun spool(source: Source, origin: Vector3dc, hasColors: Boolean = false): FacetSpool {
        spool?.close()
        return FacetSpool(space, source, origin, hasColors).also { spool = it }
    }

    /** Creates temporary files of vertices, which are read from [source]. Earlier ones are deleted. */
    fun vertices(source: Source, origin: Vector3dc): VertexSpool {
        dropVertices()
        return VertexSpool(space, source, origin).also { vertices = it }
    }

    /** Deletes the temporary files of vertices. */
    fun dropVertices() {
        vertices?.close()
        vertices = null
    }

    override fun close() {
        dropVertices()
        spool?.close()
        file.close()
        copy?.close()
    }

    companion object {
        private const val HEAD = 4096L

        /** Bytes that are copied between two looks at the clock and the interrupt. */
        private const val PIECE = 1 shl 16

        /** Opens the file at [path]. */
        fun ofFile(path: Path, name: String, folder: Path, most: Long?): StreamedInput =
            StreamedInput(path, name, null, SpoolSpace(folder, name, most))

        /** Copies all of [input] to a temporary file as part of [loading], and opens it. */
        fun ofStream(input: InputStream, name: String, folder: Path, loading: Loading): StreamedInput {
            val space = SpoolSpace(folder, name, loading.limits.spoolBytes)
            val copy = TemporaryFile.within(folder)
            try {
                val output = space.counting(Channels.newOutputStream(copy.channel))
                val piece = ByteArray(PIECE)
                while (true) {
                    loading.look(name)
                    val count = input.read(piece)
                    if (count < 0) break
                    output.write(piece, 0, count)
                }
                return StreamedInput(copy.path, name, copy, space)
            } catch (e: Throwable) {
                copy.close()
                throw e
            }
        }
    }
}
