package dev.lazyz.cli.page

import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.util.Base64
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.w3c.dom.Element
import org.w3c.dom.NodeList

/** The parts of a page that `zcli` has written. */
internal class Html(val text: String) {
    /** The pictures that are stored in the page, by their ids. */
    val pictures: Map<String, BufferedImage> =
        Regex("""<symbol id="([^"]*)"[^>]*><image [^>]*href="data:image/png;base64,([^"]*)"/></symbol>""")
            .findAll(text).associate { match ->
                val bytes = Base64.getDecoder().decode(match.groupValues[2])
                match.groupValues[1] to ImageIO.read(ByteArrayInputStream(bytes))
            }

    /** The ids of pictures, by the descriptions of the places at which they are shown. */
    val shown: Map<String, String> =
        Regex("""<svg class="picture[^>]* aria-label="([^"]*)"[^>]*><use href="#([^"]*)"/></svg>""")
            .findAll(text).associate { it.groupValues[1] to it.groupValues[2] }

    /** The charts by the first words of their descriptions. */
    val charts: Map<String, Element> = Regex("""(?s)<svg class="bars".*?</svg>""").findAll(text)
        .map { xml(it.value) }.associateBy { it.getAttribute("aria-label").substringBefore(':') }

    /** The cells of the rows of the table, without markup, by the first one. */
    val rows: Map<String, List<String>> = Regex("(?s)<tr>(.*?)</tr>").findAll(text).map { row ->
        Regex("<t[dh][^>]*>(.*?)</t[dh]>").findAll(row.groupValues[1])
            .map { it.groupValues[1].replace(Regex("<[^>]*>"), "") }.toList()
    }.associate { it.first() to it.drop(1) }

    /** Asserts that the page is whole, needs no other file, and shows each picture that it stores. */
    fun requireSelfContained() {
        assertTrue(text.startsWith("<!DOCTYPE html>\n<html lang=\"en\">") && text.endsWith("</html>\n"))
        assertEquals(
            emptyList<String>(),
            Regex("""(?:src|href)="(?!data:|#)[^"]*"""").findAll(text).map {
                it.value
            }.toList()
        )
        assertTrue("url(" !in text && "@import" !in text)
        assertTrue(pictures.isNotEmpty())
        assertEquals(pictures.keys, shown.values.toSet())
        val ids = Regex(""" id="([^"]*)"""").findAll(text).map { it.groupValues[1] }.toList()
        assertEquals(ids.distinct(), ids)
        val targets = Regex("""href="#([^"]*)"""").findAll(text).map { it.groupValues[1] }
        assertEquals(emptyList<String>(), targets.filter { it !in ids }.toList())
    }

    companion object {
        fun xml(text: String): Element = DocumentBuilderFactory.newInstance().newDocumentBuilder()
            .parse(ByteArrayInputStream(text.toByteArray())).documentElement

        val NodeList.elements: List<Element> get() = List(length) { item(it) as Element }
    }
}
