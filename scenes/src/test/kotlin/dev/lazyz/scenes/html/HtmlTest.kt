package dev.lazyz.scenes.html

import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class HtmlTest {
    @Test
    fun textHasNoMarkup() {
        assertEquals("&lt;a href=&quot;x&quot; t=&#39;y&#39;&gt;&amp;amp;", Html.escaped("<a href=\"x\" t='y'>&amp;"))
        assertEquals("tab\tline\n", Html.escaped("tab\tline\n"))
        assertEquals("Größe 点 \uD83D\uDE00", Html.escaped("Größe 点 \uD83D\uDE00"))
        val bad = listOf("\u0000", "\u0007", "\r", "\uD800", "\uDC00", "\uFFFE", "\uFFFF")
        for (text in bad) assertEquals("[\uFFFD]", Html.escaped("[$text]"), "%04x".format(text[0].code))
    }

    @Test
    fun picturesAreDataUris() = assertEquals("data:image/png;base64,AP8Q", Html.pngUri(byteArrayOf(0, -1, 16)))

    @Test
    fun pagesAreWholeFiles(@TempDir folder: Path) {
        val page = folder.resolve("page.html")
        Html.write(page, "<p>old, and longer")
        Html.write(page, "<p>ü")
        assertEquals("<p>ü", page.readText())
        val error = assertThrows(IOException::class.java) { Html.write(folder.resolve("d").createDirectory(), "") }
        assertEquals("cannot write ${folder.resolve("d")}: it is a folder; name a file in it", error.message)
        assertEquals(listOf("d", "page.html"), folder.listDirectoryEntries().map { "${it.fileName}" }.sorted())
    }
}
