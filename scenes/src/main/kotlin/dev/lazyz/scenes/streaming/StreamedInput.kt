package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.loading.Source
import java.io.InputStream
import java.nio.file.Files
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * A file that is read part by part, and the temporary files that belong to it. Not thread safe, unlike [file].
 *
 * @property source the first bytes of the file, for its format
 * @param folder where temporary files are created
 */
internal class StreamedInput(private val path: Path, val source: Source, private val folder: Path) : AutoCloseable {
    /** The whole file. */
    val file: FileBytes = FileBytes(path)

    private var spool: FacetSpool? = null

    /** Opens the file from its beginning. */
    fun bytes(): InputStream = Files.newInputStream(path)

    /** Creates a temporary file of triangles. An earlier one is deleted. */
    fun spool(origin: Vector3dc): FacetSpool {
        spool?.close()
        return FacetSpool(folder, source, origin).also { spool = it }
    }

    override fun close() {
        spool?.close()
        file.close()
    }

    companion object {
        /** Number of bytes of [source]. */
        const val HEAD: Int = 4096
    }
}
