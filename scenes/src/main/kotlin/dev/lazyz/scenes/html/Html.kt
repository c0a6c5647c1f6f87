package dev.lazyz.scenes.html

import dev.lazyz.scenes.writers.AtomicFile
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Path
import java.util.Base64

/** What a page of HTML needs that has all its pictures in it. Thread safe. */
public object Html {
    /** The beginning of [pngUri]. */
    internal const val PNG_URI = "data:image/png;base64,"

    /**
     * Returns [text] escaped as content or attribute value of HTML and XML. Characters that XML does not allow become
     * `U+FFFD`.
     */
    @JvmStatic
    public fun escaped(text: String): String = buildString(text.length) {
        for (point in text.codePoints()) {
            when (point) {
                '&'.code -> append("&amp;")
                '<'.code -> append("&lt;")
                '>'.code -> append("&gt;")
                '"'.code -> append("&quot;")
                '\''.code -> append("&#39;")
                '\n'.code, '\t'.code -> appendCodePoint(point)
                else -> appendCodePoint(if (isXml(point)) point else 0xFFFD)
            }
        }
    }

    /** Returns the bytes of a PNG file as a `data:` URI (RFC 2397), the source of a picture within a page. */
    @JvmStatic
    public fun pngUri(png: ByteArray): String = PNG_URI + Base64.getEncoder().encodeToString(png)

    /**
     * Writes [page] to [path] in UTF-8. The file appears only when it is complete. If writing fails, an old file with
     * the same name stays unchanged.
     *
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     */
    @JvmStatic
    @Throws(IOException::class)
    public fun write(path: Path, page: String) {
        AtomicFile.write(path) { channel ->
            val bytes = ByteBuffer.wrap(page.toByteArray())
            while (bytes.hasRemaining()) channel.write(bytes)
        }
    }

    private fun isXml(point: Int): Boolean =
        point in 0x20..0xD7FF || point in 0xE000..0xFFFD || point in 0x10000..0x10FFFF
}
