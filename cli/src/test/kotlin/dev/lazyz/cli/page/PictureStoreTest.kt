package dev.lazyz.cli.page

import dev.lazyz.Image
import dev.lazyz.scenes.pictures.Canvas
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class PictureStoreTest {
    private fun image(width: Int, height: Int, color: Int): Image = Canvas(width, height, color).toImage()

    @Test
    fun equalPicturesAreStoredOnce() {
        val page = Page("<test> & co")
        val shown = listOf(
            page.pictures.show(image(4, 3, -1), "first"),
            page.pictures.show(image(4, 3, -1), "\"again\""),
            page.pictures.show(image(3, 4, -1), "same colours, another shape"),
            page.pictures.show(image(500, 1, 0x80FF0000.toInt()), "red"),
        )
        val html = Html(page.html(shown.joinToString("\n")))
        html.requireSelfContained()
        val ids = mapOf("first" to 1, "&quot;again&quot;" to 1, "same colours, another shape" to 2, "red" to 3)
        assertEquals(ids.mapValues { "picture-${it.value}" }, html.shown)
        assertEquals(listOf(4 to 3, 3 to 4, 500 to 1), html.pictures.values.map { it.width to it.height })
        assertEquals(0x80FF0000.toInt(), html.pictures.getValue("picture-3").getRGB(9, 0))
        assertEquals(
            listOf(true, true, true, false),
            shown.map {
                "picture pixels" in it
            },
            "small ones are not smoothed"
        )
        assertEquals(true, "<title>&lt;test&gt; &amp; co</title>" in html.text)
    }

    @Test
    fun onlyPagesWithAScriptMayRunOne() {
        val policy = "Content-Security-Policy"
        val plain = Page("a").html("<p>text</p>\n")
        assertEquals(true, policy in plain && "default-src 'none'" in plain && "script" !in plain)
        val moving = Page("a").html("<p>text</p>\n", "let a = 1 < 2;\n")
        assertEquals(true, "script-src 'unsafe-inline'" in moving && "<script>\nlet a = 1 < 2;\n</script>" in moving)
    }
}
