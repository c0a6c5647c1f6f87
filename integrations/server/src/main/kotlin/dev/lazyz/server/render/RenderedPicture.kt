package dev.lazyz.server.render

import dev.lazyz.aov.Aov
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.Blank
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.InputStream
import java.security.MessageDigest
import java.util.HexFormat

/**
 * A finished picture.
 *
 * @param file the bytes of a file
 * @param written what it shows
 * @param warnings what the loader has left out
 */
internal class RenderedPicture(
    private val file: Bytes,
    request: PictureRequest,
    written: PictureOutput.Writer,
    warnings: List<String>,
) {
    /** The media type. */
    val type: String = request.output.mediaType

    /** Why there is nothing to see in it, or null. */
    val blank: Blank? = written.blank

    /** Whether a part of the model is outside. */
    val isCropped: Boolean = written.isCropped

    /** Names the picture: two with the same pixels, or the same data, have the same. */
    val tag: String = with(request.output) {
        val turn = steps?.let { listOf(it, framesPerSecond) }.orEmpty()
        val words = aovs.sorted().map(Aov::id) + views.map { it.name.lowercase() }
        val digest = if (aovs.isEmpty()) written.hash else file.digest()
        (listOf(written.size, digest) + turn + words).joinToString("-")
    }

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

        /** The SHA-256 of the bytes. */
        fun digest(): String {
            val sha = MessageDigest.getInstance("SHA-256").also { it.update(buf, 0, count) }
            return HexFormat.of().formatHex(sha.digest())
        }

        fun open(): InputStream = ByteArrayInputStream(buf, 0, count)
    }
}
