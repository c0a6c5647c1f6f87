package dev.lazyz.server.render

import dev.lazyz.scenes.pictures.Blank
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.InputStream

/**
 * A finished picture.
 *
 * @param file the bytes of a file
 * @property type its media type
 * @property tag names the picture: two with the same pixels have the same
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

    private companion object {
        const val MOST_WARNINGS = 5
    }

    /** Collects bytes, and reads them again without a copy. */
    class Bytes : ByteArrayOutputStream() {
        /** The length of the array. */
        val room: Int get() = buf.size

        fun open(): InputStream = ByteArrayInputStream(buf, 0, count)
    }
}
