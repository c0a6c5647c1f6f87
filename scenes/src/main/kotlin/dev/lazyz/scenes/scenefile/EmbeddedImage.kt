package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureWrap
import java.io.ByteArrayOutputStream
import java.util.Base64

/** An image within a scene file: a PNG as a `data:` URI (RFC 2397) that keeps every texel unchanged. */
internal object EmbeddedImage {
    fun isEmbedded(reference: String): Boolean = reference.startsWith("data:")

    fun write(texture: Texture): String {
        val bytes = ByteArrayOutputStream()
        val row = IntArray(texture.width)
        PngSink(bytes, texture.width, texture.height).use { sink ->
            for (y in 0 until texture.height) {
                for (x in row.indices) row[x] = texture.texel(x, y)
                sink.row(y, row, row, row)
            }
        }
        return Html.pngUri(bytes.toByteArray())
    }

    fun read(source: Source, node: JsonNode): Texture {
        val reference = node.text()
        if (!reference.startsWith(Html.PNG_URI)) {
            node.fail("embedded picture is not a PNG in base64: ${reference.take(40)}", "begin it with ${Html.PNG_URI}")
        }
        val bytes = try {
            Base64.getDecoder().decode(reference.substring(Html.PNG_URI.length))
        } catch (e: IllegalArgumentException) {
            node.fail("embedded picture is not base64: ${e.message}", "embed it again")
        }
        return TextureFiles.decode(source, bytes, "") ?: node.fail("embedded picture is not a PNG", "embed it again")
    }
}
