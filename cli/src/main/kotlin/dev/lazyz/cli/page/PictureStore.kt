package dev.lazyz.cli.page

import dev.lazyz.Image
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.scenes.writers.toPng

/** The pictures of a page. A picture that is shown several times is stored once. */
internal class PictureStore {
    /** The numbers of pictures by size and pixel hash. */
    private val numbers = HashMap<String, Int>()
    private val definitions = StringBuilder()

    /**
     * Returns HTML that shows [image], as wide as its place.
     *
     * @param description what it shows, for readers who do not see it
     */
    fun show(image: Image, description: String): String {
        val key = "${image.width}x${image.height} ${image.pixelHash()}"
        val number = numbers[key] ?: define(image).also { numbers[key] = it }
        val look = if (image.width <= SMALL) "picture pixels" else "picture"
        return """<svg class="$look" role="img" aria-label="${escaped(description)}" """ +
            """viewBox="0 0 ${image.width} ${image.height}"><use href="#picture-$number"/></svg>"""
    }

    /** Returns the pictures themselves, which [show] refers to. */
    fun definitions(): String =
        if (definitions.isEmpty()) "" else "<svg class=\"store\" aria-hidden=\"true\">\n$definitions</svg>\n"

    private fun define(image: Image): Int {
        val number = numbers.size + 1
        val size = """width="${image.width}" height="${image.height}""""
        definitions.append("""<symbol id="picture-$number" viewBox="0 0 ${image.width} ${image.height}">""")
            .append("""<image $size href="""").append(Html.pngUri(image.toPng())).append("\"/></symbol>\n")
        return number
    }

    private companion object {
        /** Pictures of at most so many columns are enlarged without smoothing. */
        const val SMALL = 400
    }
}
